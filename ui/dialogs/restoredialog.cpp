// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/dialogs/restoredialog.h"

#include "protocol/codes.h"
#include "ui/widgets/rowdelegate.h"
#include "ui/widgets/text.h"
#include <QHBoxLayout>
#include <QHeaderView>
#include <QPushButton>
#include <QTreeWidget>

using files::OperationState;
using files::RestoreItem;
using files::RestoreStep;

namespace dialogs {

namespace {

QPushButton *restoreButton(const QString &text, const char *name)
{
    auto *result = new QPushButton(text);
    result->setObjectName(QLatin1String(name));
    result->setAutoDefault(false);
    return result;
}

} // namespace

RestoreDialog::RestoreDialog(
    const settings::Profile &profile, const QDateTime &taken, const QList<RestoreItem> &plan, QWidget *parent)
    : DialogSheet(parent),
      m_profile {profile},
      m_plan {plan},
      m_identity {widgets::sentence({}, ui::Role::Text1)},
      m_items {new QTreeWidget},
      m_state {widgets::sentence({}, ui::Role::Text1)},
      m_go {restoreButton({}, "startRestore")},
      m_putBack {restoreButton(tr("Put that file back"), "putBack")},
      m_close {restoreButton(tr("Close"), "closeRestore")}
{
    setObjectName(QStringLiteral("restoreDialog"));
    const QString time = QLocale().toString(taken.toLocalTime(), QLocale::ShortFormat);
    setWindowTitle(tr("Restore %1 from %2").arg(profile.name, time));
    resize(760, 560);
    m_items->setObjectName(QStringLiteral("restorePlan"));
    m_items->setAccessibleName(tr("What would be done"));
    m_items->setHeaderLabels({tr("File"), tr("What is done"), tr("Reason")});
    m_items->setRootIsDecorated(false);
    widgets::RowDelegate::dress(m_items);
    m_items->setColumnWidth(0, 200);
    m_items->setColumnWidth(1, 200);
    m_items->header()->setFont(ui::font(ui::Type::Label));
    m_state->setObjectName(QStringLiteral("restoreState"));
    auto *buttons = new QHBoxLayout;
    buttons->addWidget(m_putBack);
    buttons->addStretch();
    buttons->addWidget(m_go);
    buttons->addWidget(m_close);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(ui::space::page, ui::space::page, ui::space::page, ui::space::page);
    column->setSpacing(ui::space::gap);
    column->addWidget(
        widgets::sentence(tr("A fresh backup of %1 is made first. Then the files below are sent one by one "
                             "and read back. A refused file is left out; it stops at any other error.")
                              .arg(profile.name),
            ui::Role::Text2));
    m_identity->setObjectName(QStringLiteral("restoreIdentity"));
    m_identity->setTextFormat(Qt::PlainText);
    m_identity->hide();
    column->addWidget(m_identity);
    column->addWidget(m_items, 1);
    column->addWidget(m_state);
    column->addLayout(buttons);
    for (const RestoreItem &item : plan)
        addItem(item);
    widgets::writing(m_go);
    widgets::writing(m_putBack);
    m_putBack->hide();
    m_close->setFocus();
    connect(m_items, &QTreeWidget::itemChanged, this, &RestoreDialog::countChosen);
    connect(m_close, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_putBack, &QPushButton::clicked, this, &RestoreDialog::putBack);
    connect(m_go, &QPushButton::clicked, this, [this] { Q_EMIT confirmed(chosenPlan()); });
    countChosen();
}

void RestoreDialog::addItem(const RestoreItem &item)
{
    const QString words[] {tr("+ new: it is sent"), tr("≠ changed: it is replaced"), tr("= same: left alone"),
        tr("▲ not allowed: left alone")};
    const QString name = protocol::TextCodec {m_profile.encoding}.decode(item.name.bytes());
    auto *row = new QTreeWidgetItem({name, words[int(item.step)], item.reason});
    row->setToolTip(2, item.reason);
    if (item.isSent())
        row->setCheckState(0, item.needsCare ? Qt::Unchecked : Qt::Checked);
    m_items->addTopLevelItem(row);
    row->setHidden(item.step == RestoreStep::Same);
}

void RestoreDialog::showIdentity(const QList<files::IdentityRow> &rows)
{
    QStringList lines;
    for (const files::IdentityRow &row : rows) {
        if (!row.isSame)
            lines << tr("%1: the backup is of %2, the controller is %3.").arg(row.title, row.backup, row.controller);
    }
    if (files::isAnotherRobot(rows))
        lines.prepend(QStringLiteral("▲ ") + tr("This is the backup of another robot: nothing of it is sent."));
    m_identity->setText(lines.join(u'\n'));
    m_identity->setVisible(!lines.isEmpty());
}

QList<RestoreItem> RestoreDialog::chosenPlan() const
{
    QList<RestoreItem> plan;
    for (int row = 0; row < m_plan.size(); ++row) {
        if (!m_plan[row].isSent() || m_items->topLevelItem(row)->checkState(0) == Qt::Checked)
            plan << m_plan[row];
    }
    return plan;
}

void RestoreDialog::countChosen()
{
    const auto plan = chosenPlan();
    const int count = int(std::ranges::count_if(plan, &RestoreItem::isSent));
    const int same = int(std::ranges::count(m_plan, RestoreStep::Same, &RestoreItem::step));
    m_go->setText(tr("Back up, then restore %n file(s)", nullptr, count));
    m_go->setEnabled(count > 0);
    m_state->setText(tr("%n file(s) are the same and not listed.", nullptr, same));
}

void RestoreDialog::follow(std::shared_ptr<files::Restore> restore)
{
    m_restore = std::move(restore);
    m_go->setEnabled(false);
    m_items->setEnabled(false);
    m_close->setText(tr("Cancel"));
    connect(m_restore.get(), &files::Operation::progressed, this, &RestoreDialog::showProgress);
    connect(m_restore.get(), &files::Operation::finished, this, &RestoreDialog::onFinished);
    m_restore->start();
    showProgress();
}

void RestoreDialog::reject()
{
    if (m_restore && !m_restore->isOver())
        m_restore->cancel();
    else
        QDialog::reject();
}

void RestoreDialog::showProgress()
{
    const auto current = m_restore->current();
    const auto &backup = m_restore->backup();
    if (current)
        m_state->setText(tr("Sending file %1 of %2…").arg(m_restore->filesDone() + 1).arg(m_restore->filesTotal()));
    else
        m_state->setText(tr("Fresh backup: file %1 of %2…").arg(backup.filesDone()).arg(backup.filesTotal()));
}

void RestoreDialog::onFinished()
{
    m_close->setText(tr("Close"));
    if (m_restore->state() == OperationState::Done) {
        m_state->setText(tr("%n file(s) were restored and read back.", nullptr, m_restore->filesDone()));
        return;
    }
    const QString done = tr("%n file(s) were restored before that.", nullptr, m_restore->filesDone());
    const QString why = m_restore->error() ? protocol::explain(*m_restore->error()) : tr("It was cancelled.");
    const auto current = m_restore->current();
    const QString where = current
        ? tr("Stopped at %1.").arg(protocol::TextCodec {m_profile.encoding}.decode(current->bytes()))
        : tr("Nothing was sent.");
    QStringList lines {QStringLiteral("▲ ") + where, why, done};
    if (const auto refused = m_restore->refusals(); !refused.isEmpty())
        lines = QStringList {QStringLiteral("▲ ") + refusedText(refused), why, done};
    m_state->setText(lines.join(u'\n'));
    m_putBack->setVisible(m_restore->canPutBack());
}

QString RestoreDialog::refusedText(const QList<files::FileResult> &refused) const
{
    QStringList names;
    for (const files::FileResult &result : refused)
        names << protocol::TextCodec {m_profile.encoding}.decode(result.name);
    return tr("The controller refused %1; the other files were sent.").arg(names.join(QStringLiteral(", ")));
}

void RestoreDialog::putBack()
{
    m_back = m_restore->putBack();
    if (!m_back)
        return;
    m_putBack->setEnabled(false);
    connect(m_back.get(), &files::Operation::finished, this, [this] {
        Q_EMIT tried(m_back.get());
        const bool isBack = m_back->state() == OperationState::Done && m_back->readBack() == files::ReadBack::Identical;
        m_state->setText(isBack ? tr("The file is as it was before.")
                                : tr("▲ The file could not be put back. Look at the controller."));
    });
    m_back->start();
}

} // namespace dialogs
