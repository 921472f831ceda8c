// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "desk.h"

#include "protocol/codes.h"
#include "protocol/requests.h"
#include "robot/policies.h"
#include <QHostInfo>

using values::Error;
using values::ErrorKind;
using values::Result;

namespace pendeskctl {

namespace {

Result<void> mayChange(const Result<values::Status> &status)
{
    if (!status)
        return tl::unexpected(status.error());
    if (status->data1.testFlag(values::Status::Running))
        return values::failure(ErrorKind::NotSent, tr("A job is running; files are not changed meanwhile."));
    return {};
}

} // namespace

Desk::Desk(const Call &call, const QHostAddress &address)
    : m_call {call},
      m_robotTransport {address, call.profile.port},
      m_fileTransport {address, call.profile.filePort},
      m_robot {m_robotTransport, robot::policyOf(call.profile)},
      m_files {m_fileTransport, robot::filePolicyOf(call.profile)}
{
}

files::Guard Desk::guard()
{
    return [this](QObject *context, const std::function<void(const Result<void> &)> &handler) {
        m_robot.send(protocol::ReadStatus {}, context,
            [handler](const Result<values::Status> &status) { handler(mayChange(status)); });
    };
}

void Desk::finish(ExitCode code)
{
    showProgress(m_call, {});
    QCoreApplication::exit(code);
}

void Desk::complainOf(const Error &error, const QString &subject) const
{
    showProgress(m_call, {});
    const bool isOurs =
        error.kind == ErrorKind::NotSent || error.kind == ErrorKind::LocalFile || error.kind == ErrorKind::BadInput;
    const QString words = isOurs && !error.detail.isEmpty() ? error.detail : protocol::explain(error);
    complain(QStringLiteral("%1: %2").arg(subject.isEmpty() ? m_call.profile.host : subject, words));
}

void Desk::fail(const Error &error)
{
    complainOf(error);
    finish(exitCodeOf(error));
}

int run(const Call &call, const std::function<void(Desk &)> &begin)
{
    const auto addresses = QHostInfo::fromName(call.profile.host).addresses();
    const auto ipv4 = std::ranges::find(addresses, QAbstractSocket::IPv4Protocol, &QHostAddress::protocol);
    if (ipv4 == addresses.end()) {
        complain(tr("The name “%1” has no IPv4 address.").arg(call.profile.host));
        return NoAnswer;
    }
    Desk desk {call, *ipv4};
    QMetaObject::invokeMethod(
        &desk, [&] { begin(desk); }, Qt::QueuedConnection);
    return QCoreApplication::exec();
}

} // namespace pendeskctl
