// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "robot/diagnosis.h"

#include "protocol/codes.h"
#include "session/session.h"
#include "session/udptransport.h"
#include <QHostInfo>
#include <QUdpSocket>

using namespace std::chrono_literals;
using protocol::Request;
using protocol::Service;
using values::Error;
using values::ErrorKind;
using values::Result;

namespace robot {

namespace {

constexpr auto filePatience = 1s;

/// The rungs in the order they are climbed.
constexpr std::array rungTitles {
    QT_TRANSLATE_NOOP("robot::Diagnosis", "Host name"),
    QT_TRANSLATE_NOOP("robot::Diagnosis", "Way to the host"),
    QT_TRANSLATE_NOOP("robot::Diagnosis", "Robot port"),
    QT_TRANSLATE_NOOP("robot::Diagnosis", "System information"),
    QT_TRANSLATE_NOOP("robot::Diagnosis", "File port"),
};

} // namespace

Diagnosis::Diagnosis(settings::Profile profile, QObject *parent) : QObject {parent}, m_profile {std::move(profile)} { }

Diagnosis::~Diagnosis() = default;

void Diagnosis::add(Rung::Outcome outcome, const QString &sentence, const QString &remedy)
{
    m_rungs.append({tr(rungTitles[std::size_t(m_rungs.size())]), outcome, sentence, remedy});
    Q_EMIT rungFinished(m_rungs.last());
}

void Diagnosis::finish()
{
    while (m_rungs.size() < qsizetype(rungTitles.size()))
        add(Rung::Outcome::Skipped, tr("Not looked at, because the step before it failed."));
    Q_EMIT finished();
}

void Diagnosis::start() { resolve(); }

void Diagnosis::resolve()
{
    QHostInfo::lookupHost(m_profile.host, this, [this](const QHostInfo &found) {
        for (const QHostAddress &address : found.addresses()) {
            if (address.protocol() == QAbstractSocket::IPv4Protocol && !m_address)
                m_address = std::make_unique<QHostAddress>(address);
        }
        if (!m_address) {
            add(Rung::Outcome::Failed, tr("The name “%1” has no IPv4 address on this computer.").arg(m_profile.host),
                tr("Check the spelling, or enter the controller's IPv4 address as the pendant shows it."));
            return finish();
        }
        add(Rung::Outcome::Passed, tr("%1 is %2.").arg(m_profile.host, m_address->toString()));
        route();
    });
}

/// A connected socket hears what an unconnected one does not: that there is no way, or that nobody listens at the port.
void Diagnosis::route()
{
    m_probe = std::make_unique<QUdpSocket>();
    const auto fail = [this] {
        add(Rung::Outcome::Failed,
            tr("This computer cannot send to %1: %2.").arg(m_address->toString(), m_probe->errorString()),
            tr("Check the cable and this computer's IPv4 address: it must be in the controller's network."));
        finish();
    };
    m_probe->connectToHost(*m_address, m_profile.port);
    if (m_probe->state() != QAbstractSocket::ConnectedState)
        return fail();
    const QByteArray status = protocol::encode(protocol::ReadStatus {}.request(), protocol::Framing {});
    if (m_probe->write(status) != status.size())
        return fail();
    connect(m_probe.get(), &QUdpSocket::errorOccurred, this, [this] { m_probeError = m_probe->errorString(); });
    connect(m_probe.get(), &QUdpSocket::readyRead, this, [this] {
        char ignored = 0;
        m_probe->readDatagram(&ignored, 1); // reading is what makes the socket report the network's answer
    });
    add(Rung::Outcome::Passed, tr("This computer can send to %1.").arg(m_address->toString()));
    ask();
}

void Diagnosis::ask()
{
    session::Policy policy;
    policy.timeout = m_profile.readTimeout;
    policy.repeats = m_profile.readRepeats;
    m_transport = std::make_unique<session::UdpTransport>(*m_address, m_profile.port);
    m_session = std::make_unique<session::Session>(*m_transport, policy);
    m_session->send(protocol::ReadStatus {}, this, [this](const Result<values::Status> &status) { onStatus(status); });
}

void Diagnosis::onStatus(const Result<values::Status> &status)
{
    if (status) {
        add(Rung::Outcome::Passed, tr("Port %1 answers with a status.").arg(m_profile.port));
        return identify();
    }
    if (status.error().kind == ErrorKind::Refused) {
        add(Rung::Outcome::Failed,
            tr("Port %1 answers but refuses to tell the status: %2")
                .arg(m_profile.port)
                .arg(protocol::explain(status.error())),
            tr("Check on the pendant that the network function server is enabled for this computer."));
    } else {
        explainSilence();
    }
    finish();
}

void Diagnosis::explainSilence()
{
    const session::Counters heard = m_session->statistics().counters;
    if (heard.strangers > 0) {
        add(Rung::Outcome::Failed,
            tr("Answers come from another address than %1; they are ignored.").arg(m_address->toString()),
            tr("Look for a second network card or an address translation between this computer and the controller."));
    } else if (heard.malformed + heard.mismatched > 0) {
        add(Rung::Outcome::Failed, tr("Something answers at port %1, but not with HSES.").arg(m_profile.port),
            tr("Check the address and the port: HSES is UDP %1 on a controller.").arg(protocol::robotPort));
    } else if (!m_probeError.isEmpty()) {
        add(Rung::Outcome::Failed, tr("The host rejects port %1: %2.").arg(m_profile.port).arg(m_probeError),
            tr("The host is there, but no HSES server: enable the Ethernet server function on the controller."));
    } else {
        add(Rung::Outcome::Failed, tr("Port %1 stays silent.").arg(m_profile.port),
            tr("Check that the controller is on, that its Ethernet server function is enabled and that no firewall "
               "drops UDP %1.")
                .arg(m_profile.port));
    }
}

void Diagnosis::identify()
{
    m_session->send(
        protocol::ReadSystemInformation::robot(1), this, [this](const Result<values::SystemInformation> &information) {
            if (information) {
                add(Rung::Outcome::Passed,
                    tr("The controller runs %1.").arg(QString::fromLatin1(information->software.bytes())));
                return knockAtFiles();
            }
            add(Rung::Outcome::Failed,
                tr("The controller does not tell its system information: %1")
                    .arg(protocol::explain(information.error())),
                tr("Pendesk monitors only a controller that says what it is. Ask its maker for the HSES option."));
            finish();
        });
}

/// A list is the one file service that needs no name and changes nothing.
void Diagnosis::knockAtFiles()
{
    m_files = std::make_unique<QUdpSocket>();
    m_files->connectToHost(*m_address, m_profile.filePort);
    connect(m_files.get(), &QUdpSocket::readyRead, this, &Diagnosis::hearFiles);
    const Request list {0, 0, 0, Service::ListFiles, QByteArrayLiteral("*.JBI")};
    m_files->write(protocol::encode(list, {protocol::Division::File, false, 1, 0}));
    QTimer::singleShot(filePatience, this, [this] {
        if (m_rungs.size() == qsizetype(rungTitles.size()))
            return;
        add(Rung::Outcome::Failed,
            tr("Port %1 stays silent: files are unavailable, monitoring works.").arg(m_profile.filePort),
            tr("Check that no firewall drops UDP %1.").arg(m_profile.filePort));
        finish();
    });
}

void Diagnosis::hearFiles()
{
    while (m_files->hasPendingDatagrams()) {
        QByteArray datagram(2048, Qt::Uninitialized);
        datagram.resize(std::max<qsizetype>(0, m_files->readDatagram(datagram.data(), datagram.size())));
        const auto reply = protocol::parseReply(datagram);
        if (!reply)
            continue;
        if (!reply->isRefusal()) { // take the list to its end, so that the controller's transfer is not left open
            const Request acknowledgement {0, 0, 0, Service::ListFiles};
            m_files->write(
                protocol::encode(acknowledgement, {protocol::Division::File, true, 1, reply->framing.block}));
        }
        if (m_rungs.size() == qsizetype(rungTitles.size()))
            continue;
        add(Rung::Outcome::Passed, tr("Port %1 answers.").arg(m_profile.filePort));
        finish();
    }
}

} // namespace robot
