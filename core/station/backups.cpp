// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "station/backups.h"

namespace station {

namespace {

bool isUnderWay(const files::Operation *operation)
{
    return operation && operation->state() == files::OperationState::Running;
}

} // namespace

Backups::Backups(FileOrders &orders, const robot::Controller &controller, settings::Notes notes, QObject *parent)
    : QObject {parent},
      m_orders {orders},
      m_controller {controller},
      m_notes {notes},
      m_choices {readBackupChoices(notes)}
{
}

Backups::~Backups() = default;

void Backups::setChoices(const BackupChoices &choices)
{
    m_choices = choices;
    writeBackupChoices(m_notes, choices);
}

files::Archive Backups::archive() const { return {m_choices.folder, m_controller.profile().folderName()}; }

bool Backups::isBusy() const
{
    return isUnderWay(m_backup.get()) || isUnderWay(m_snapshot.get()) || isUnderWay(m_restore.get());
}

files::BackupOrder Backups::order(const files::Retention &retention) const
{
    files::BackupOrder order;
    order.root = m_choices.folder;
    order.retention = retention;
    const settings::Profile &profile = m_controller.profile();
    order.info.controller = profile.folderName();
    order.info.host = profile.host;
    if (const auto &system = m_controller.state().systemInformation().value) {
        order.info.model = QString::fromLatin1(system->model.bytes());
        order.info.software = QString::fromLatin1(system->software.bytes());
        order.info.parameterVersion = QString::fromLatin1(system->parameters.bytes());
    }
    return order;
}

bool Backups::backUp()
{
    session::FileSession *session = m_controller.files();
    if (!session || isBusy())
        return false;
    m_backup = std::make_unique<files::Backup>(*session, order(m_choices.retention));
    connect(m_backup.get(), &files::Operation::progressed, this, &Backups::progressed);
    connect(m_backup.get(), &files::Operation::finished, this, [this] {
        Q_EMIT progressed();
        Q_EMIT backedUp();
    });
    m_backup->start();
    Q_EMIT progressed();
    return true;
}

bool Backups::read(QObject *context, FilesHandler handler)
{
    session::FileSession *session = m_controller.files();
    if (!session || isBusy())
        return false;
    m_snapshot = std::make_unique<files::Snapshot>(*session);
    connect(m_snapshot.get(), &files::Operation::progressed, this, &Backups::progressed);
    connect(m_snapshot.get(), &files::Operation::finished, this, &Backups::progressed);
    connect(m_snapshot.get(), &files::Operation::finished, context, [this, handler = std::move(handler)] {
        if (const auto &error = m_snapshot->error())
            handler(tl::unexpected(*error));
        else
            handler(m_snapshot->files());
    });
    m_snapshot->start();
    Q_EMIT progressed();
    return true;
}

std::shared_ptr<files::Restore> Backups::restore(const files::FileSet &bag, const QList<files::RestoreItem> &plan)
{
    session::FileSession *session = m_controller.files();
    if (!session || isBusy())
        return nullptr;
    using robot::Act;
    m_restore = std::make_shared<files::Restore>(*session, bag, plan, order({}), m_orders.guard(Act::Restore));
    connect(m_restore.get(), &files::Restore::tried, &m_orders,
        [this](const files::Upload *upload) { m_orders.note(*upload, Act::Upload); });
    connect(m_restore.get(), &files::Operation::progressed, this, &Backups::progressed);
    connect(m_restore.get(), &files::Operation::finished, this, &Backups::progressed);
    return m_restore;
}

} // namespace station
