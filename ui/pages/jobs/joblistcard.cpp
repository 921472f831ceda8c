// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/jobs/joblistcard.h"

#include "protocol/codes.h"
#include "settings/profilestore.h"
#include "ui/widgets/flow.h"
#include <QGridLayout>
#include <QJsonArray>
#include <QLineEdit>
#include <QListView>
#include <QPushButton>

namespace pages {

using models::JobListModel;
using values::FileName;

namespace {

const QString favouritesSubject = QStringLiteral("favourite jobs");
const QString favouritesKey = QStringLiteral("names");

/// Names are bytes in the controller's encoding; in the settings they stand as hex, so that none is lost.
QSet<QByteArray> readFavourites(const settings::Notes &notes)
{
    QSet<QByteArray> result;
    for (const QJsonValue name : notes.read(favouritesSubject).value(favouritesKey).toArray())
        result << QByteArray::fromHex(name.toString().toLatin1());
    return result;
}

void writeFavourites(settings::Notes notes, const QSet<QByteArray> &favourites)
{
    QStringList sorted;
    for (const QByteArray &name : favourites)
        sorted << QString::fromLatin1(name.toHex());
    sorted.sort();
    notes.write(favouritesSubject,
        sorted.isEmpty() ? QJsonObject {} : QJsonObject {{favouritesKey, QJsonArray::fromStringList(sorted)}});
}

} // namespace

JobListCard::JobListCard(const Context &context, robot::JobLibrary &library, QWidget *parent)
    : Card(tr("Jobs on the controller"), parent),
      m_state {context.station.state()},
      m_library {library},
      m_model {new JobListModel(context.station.profile().encoding, this)},
      m_filter {new models::JobFilter(m_model, this)},
      m_text {new QLineEdit},
      m_view {new QListView},
      m_empty {widgets::sentence({}, ui::Role::Text2)},
      m_favourite {new QPushButton(tr("★ Favourite"))},
      m_read {new QPushButton(tr("Read again"))}
{
    makeWidgets();
    connect(m_text, &QLineEdit::textChanged, this, [this](const QString &text) {
        m_filter->setText(text);
        showList();
    });
    connect(m_view->selectionModel(), &QItemSelectionModel::currentChanged, this, &JobListCard::onCurrentChanged);
    connect(m_view, &QListView::clicked, this, &JobListCard::onCurrentChanged); // again, after another was followed
    connect(m_favourite, &QPushButton::clicked, this, &JobListCard::toggleFavourite);
    connect(m_read, &QPushButton::clicked, &library, &robot::JobLibrary::readList);
    connect(&library, &robot::JobLibrary::listChanged, this, &JobListCard::showList);
    connect(&m_state, &robot::RobotState::changed, this, &JobListCard::showExecuting);
    m_model->setFavourites(readFavourites(context.station.notes()));
    connect(m_model, &JobListModel::favouritesChanged, this,
        [this, notes = context.station.notes()] { writeFavourites(notes, m_model->favourites()); });
    showList();
    onCurrentChanged({});
}

void JobListCard::makeWidgets()
{
    m_text->setObjectName(QStringLiteral("jobFilter"));
    m_text->setPlaceholderText(tr("Filter"));
    m_text->setAccessibleName(tr("Filter jobs by name"));
    m_text->setClearButtonEnabled(true);
    m_view->setObjectName(QStringLiteral("jobList"));
    m_view->setAccessibleName(tr("Jobs on the controller"));
    m_view->setModel(m_filter);
    m_view->setUniformItemSizes(true);
    m_view->setFrameShape(QFrame::NoFrame);
    m_empty->setObjectName(QStringLiteral("jobListEmpty"));
    m_favourite->setObjectName(QStringLiteral("favourite"));
    m_favourite->setCheckable(true);
    m_read->setObjectName(QStringLiteral("readJobs"));
    auto *buttons = new widgets::Flow;
    buttons->addWidget(m_favourite);
    buttons->addStretch();
    buttons->addWidget(m_read);
    auto *place = new QGridLayout; // the words stand where the list does: nothing moves when it comes
    place->addWidget(m_view, 0, 0);
    place->addWidget(m_empty, 0, 0, Qt::AlignTop);
    m_empty->setAttribute(Qt::WA_TransparentForMouseEvents);
    body()->addWidget(m_text);
    body()->addLayout(place, 1);
    body()->addLayout(buttons);
}

void JobListCard::showList()
{
    const auto &list = m_library.list();
    if (list.value)
        m_model->setJobs(*list.value);
    setNote(note());
    m_read->setEnabled(!m_library.isListing());
    const auto &trouble = m_library.listTrouble();
    setReason(trouble ? tr("The list could not be read: %1.").arg(protocol::explain(*trouble)) : age());
    if (m_library.isListing() && !list.value)
        m_empty->setText(tr("Reading the list…"));
    else if (!list.value)
        m_empty->setText(tr("The list was not read yet."));
    else if (list.value->isEmpty())
        m_empty->setText(tr("There is no job on the controller."));
    else
        m_empty->setText(tr("No job has “%1” in its name.").arg(m_text->text()));
    m_empty->setVisible(m_filter->rowCount() == 0);
}

QString JobListCard::note() const
{
    const auto &list = m_library.list();
    if (m_library.isListing())
        return tr("reading…");
    if (!list.value)
        return {};
    return tr("%n job(s)", nullptr, int(list.value->size()));
}

/// Of a list that may be another one by now.
QString JobListCard::age() const
{
    const auto &list = m_library.list();
    return list.value && m_library.isListOld() ? tr("%1, read at %2").arg(note(), list.clock.toString(u"HH:mm:ss"))
                                               : QString();
}

void JobListCard::showExecuting()
{
    const auto &status = m_state.status();
    const bool isRunning = status.value && status.value->isRunning() && m_state.job().value;
    m_model->setExecuting(isRunning ? m_state.job().value->name.bytes().toByteArray() : QByteArray());
}

void JobListCard::choose(QByteArrayView base)
{
    const int row = m_model->rowOf(base);
    if (row >= 0)
        m_view->setCurrentIndex(m_filter->mapFromSource(m_model->index(row)));
}

void JobListCard::onCurrentChanged(const QModelIndex &current)
{
    m_favourite->setEnabled(current.isValid());
    m_favourite->setChecked(current.data(JobListModel::FavouriteRole).toBool());
    if (current.isValid())
        Q_EMIT chosen(m_model->job(m_filter->mapToSource(current).row()));
}

void JobListCard::toggleFavourite()
{
    const QModelIndex source = m_filter->mapToSource(m_view->currentIndex());
    if (source.isValid())
        m_model->setFavourite(source.row(), m_favourite->isChecked());
}

} // namespace pages
