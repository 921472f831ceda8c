// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/dialogs/connectiondialog.h"

#include "ui/dialogs/ladderview.h"
#include "ui/dialogs/profileform.h"
#include "ui/widgets/scrollcolumn.h"
#include "ui/widgets/text.h"
#include <QHBoxLayout>
#include <QListWidget>
#include <QPushButton>
#include <QScrollArea>

namespace dialogs {

using settings::Profile;

namespace {

QPushButton *profileButton(const char *name, const QString &words)
{
    auto *result = new QPushButton(words);
    result->setObjectName(QLatin1String(name));
    result->setAutoDefault(false);
    return result;
}

} // namespace

ConnectionDialog::ConnectionDialog(settings::ProfileStore &store, const QString &selected, QWidget *parent)
    : DialogSheet(parent),
      m_store {store},
      m_list {new QListWidget},
      m_duplicate {profileButton("duplicateProfile", tr("Duplicate"))},
      m_remove {profileButton("removeProfile", tr("Remove"))},
      m_form {new ProfileForm},
      m_complaint {widgets::sentence({}, ui::Role::Amber)},
      m_save {profileButton("saveProfile", tr("Save"))},
      m_connect {profileButton("connectProfile", tr("Connect"))},
      m_ladder {new LadderView}
{
    setObjectName(QStringLiteral("connectionDialog"));
    setWindowTitle(tr("Connect to a controller"));
    resize(820, 640);
    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(ui::space::page, ui::space::page, ui::space::page, ui::space::page);
    row->setSpacing(ui::space::page);
    row->addWidget(listColumn(), 1);
    row->addWidget(formColumn(), 2);
    connect(m_list, &QListWidget::currentRowChanged, this, &ConnectionDialog::onSelected);
    connect(m_form, &ProfileForm::edited, this, &ConnectionDialog::onEdited);
    fill(selected);
    m_form->setFocus();
}

QWidget *ConnectionDialog::listColumn()
{
    auto *result = new QWidget;
    auto *column = new QVBoxLayout(result);
    column->setContentsMargins(0, 0, 0, 0);
    QPushButton *addButton = profileButton("addProfile", tr("Add"));
    m_list->setObjectName(QStringLiteral("profileList"));
    m_list->setAccessibleName(tr("Known controllers"));
    column->addWidget(widgets::text(tr("CONTROLLERS"), ui::Type::Heading, ui::Role::Text2));
    column->addWidget(m_list, 1);
    auto *row = new QHBoxLayout;
    for (QPushButton *each : {addButton, m_duplicate, m_remove})
        row->addWidget(each);
    column->addLayout(row);
    connect(addButton, &QPushButton::clicked, this, &ConnectionDialog::add);
    connect(m_duplicate, &QPushButton::clicked, this, &ConnectionDialog::duplicate);
    connect(m_remove, &QPushButton::clicked, this, &ConnectionDialog::remove);
    return result;
}

QWidget *ConnectionDialog::formColumn()
{
    auto *result = new QWidget;
    auto *column = new QVBoxLayout(result);
    column->setContentsMargins(0, 0, 0, 0);
    m_complaint->setObjectName(QStringLiteral("complaint"));
    m_connect->setProperty("primary", true);
    m_connect->setDefault(true);
    auto *scroll = new QScrollArea;
    scroll->setWidget(m_ladder);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    auto *row = new QHBoxLayout;
    row->addWidget(widgets::sentence(tr("Connecting only reads. HOLD: Pause key."), ui::Role::Text2), 1);
    row->addWidget(m_save);
    row->addWidget(m_connect);
    column->addWidget(new widgets::ScrollColumn(m_form), 3);
    column->addWidget(m_complaint);
    column->addLayout(row);
    column->addWidget(scroll, 1);
    connect(m_save, &QPushButton::clicked, this, &ConnectionDialog::save);
    connect(m_connect, &QPushButton::clicked, this, &ConnectionDialog::connectNow);
    return result;
}

void ConnectionDialog::fill(const QString &selected)
{
    m_list->clear();
    const auto profiles = m_store.profiles();
    for (const Profile &profile : profiles) {
        auto *item = new QListWidgetItem(profile.name, m_list);
        item->setToolTip(profile.host);
        if (profile.name == selected)
            m_list->setCurrentItem(item);
    }
    if (m_list->currentRow() < 0 && m_list->count() > 0)
        m_list->setCurrentRow(0);
    onSelected();
}

QString ConnectionDialog::selectedName() const
{
    return m_list->currentItem() ? m_list->currentItem()->text() : QString();
}

void ConnectionDialog::onSelected()
{
    m_form->setProfile(m_store.find(selectedName()).value_or(Profile {}));
    for (QPushButton *each : {m_duplicate, m_remove})
        each->setEnabled(!selectedName().isEmpty());
    onEdited();
}

/// What is wrong is said while it is typed, and nothing that is wrong can be saved.
void ConnectionDialog::onEdited()
{
    const QString trouble = complaint(m_form->profile());
    m_complaint->setText(trouble);
    m_save->setEnabled(trouble.isEmpty());
    m_connect->setEnabled(trouble.isEmpty());
}

QString ConnectionDialog::complaint(const Profile &profile) const
{
    QString trouble = settings::complaint(profile);
    if (!trouble.isEmpty())
        return trouble;
    if (!motion::limits(profile.motion))
        return tr("A motion limit must be a number above 0, and each side of the box must begin before it ends.");
    if (profile.name != selectedName() && m_store.find(profile.name))
        return tr("There is another controller with the name “%1”.").arg(profile.name);
    return {};
}

QString ConnectionDialog::unusedName(const QString &wish) const
{
    QString name = wish;
    for (int i = 2; m_store.find(name); ++i)
        name = tr("%1 (%2)").arg(wish).arg(i);
    return name;
}

void ConnectionDialog::add()
{
    m_list->setCurrentRow(-1);
    Profile profile;
    profile.name = unusedName(tr("New controller"));
    m_form->setProfile(profile);
    onEdited();
    m_form->setFocus();
}

void ConnectionDialog::duplicate()
{
    Profile copy = m_form->profile();
    copy.name = unusedName(copy.name);
    copy.id = {};
    copy.folder.clear();
    copy.formerNames.clear();
    m_store.save(copy);
    fill(copy.name);
}

void ConnectionDialog::remove()
{
    m_store.remove(selectedName());
    fill({});
}

bool ConnectionDialog::save()
{
    const Profile profile = m_form->profile();
    if (!complaint(profile).isEmpty())
        return false;
    m_store.save(profile);
    fill(profile.name);
    return true;
}

void ConnectionDialog::connectNow()
{
    if (!save())
        return;
    const Profile profile = m_form->profile(); // with its id
    m_ladder->diagnose(profile);
    Q_EMIT connectRequested(profile);
}

} // namespace dialogs
