// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "desk.h"

#include "protocol/codes.h"
#include "protocol/requests.h"
#include "robot/policies.h"
#include "settings/settingsfile.h"
#include <QHostInfo>

using values::Error;
using values::ErrorKind;
using values::Result;

namespace pendeskctl {

/// What the window shares among its stations, for the one of this call.
struct Desk::Site {
    explicit Site(const settings::Profile &profile) : station {profile, {store, rules, arming, journal}}
    {
        QObject::connect(&journal, &journal::Store::failed, &complain);
    }

    settings::SettingsFile file;
    settings::ProfileStore store {file};
    robot::AccessRules rules; // without a passcode: nobody is here to be asked
    robot::Arming arming;
    journal::Store journal;
    station::Station station;
};

Desk::Desk(const Call &call, const QHostAddress &address)
    : m_call {call},
      m_robotTransport {address, call.profile.port},
      m_fileTransport {address, call.profile.filePort},
      m_robot {m_robotTransport, robot::policyOf(call.profile)},
      m_files {m_fileTransport, robot::filePolicyOf(call.profile)}
{
}

Desk::~Desk() = default;

station::Station &Desk::station() const { return m_site->station; }

void Desk::identify(const std::function<void()> &next)
{
    if (m_call.hasModel)
        return next();
    m_robot.send(
        protocol::ReadSystemInformation::robot(1), this, [this, next](const Result<values::SystemInformation> &system) {
            if (!system && system.error().kind != ErrorKind::Refused)
                return fail(system.error());
            const auto model = system ? protocol::modelOfSoftware(system->software.bytes()) : std::nullopt;
            m_call.profile.model = model.value_or(m_call.profile.model);
            next();
        });
}

void Desk::openStation(const std::function<void()> &next)
{
    m_site = std::make_unique<Site>(m_call.profile);
    station().access.enter(robot::Level::Engineer);
    robot::Controller &controller = station().controller;
    connect(&controller, &robot::Controller::troubleChanged, this, [this, &controller] {
        if (controller.trouble())
            fail(*controller.trouble());
    });
    connect(
        &controller, &robot::Controller::linkStateChanged, this,
        [this, &controller, next] {
            if (controller.linkState() != robot::LinkState::Monitoring)
                return;
            controller.disconnect(this);
            if (m_call.hasNumbering)
                station().orders.setNumberingVerified(true);
            next();
        },
        Qt::QueuedConnection); // when the station knows it too
    controller.open();
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
        &desk, [&] { desk.identify([&] { begin(desk); }); }, Qt::QueuedConnection);
    return QCoreApplication::exec();
}

int change(const Call &call, const std::function<void(Desk &)> &begin)
{
    return run(call, [begin](Desk &desk) { desk.openStation([&desk, begin] { begin(desk); }); });
}

} // namespace pendeskctl
