// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "settings/profile.h"
#include "values/error.h"
#include "values/status.h"
#include <QObject>
#include <memory>

class QHostAddress;
class QUdpSocket;

namespace session {
class Session;
class UdpTransport;
} // namespace session

namespace robot {

/// One step of the diagnosis, in words for the person at the desk.
struct Rung {
    enum class Outcome { Passed, Failed, Skipped };

    QString title; ///< What was looked at: "Host name".
    Outcome outcome = Outcome::Skipped;
    QString sentence; ///< What was found.
    QString remedy; ///< What to do; empty where nothing is wrong.

    bool operator==(const Rung &) const = default;
};

/// Why does this controller not answer? Climbs from the name to the files, one rung after the other, and stops at the
/// first that fails, but for the file port, without which monitoring still works. It only reads. Deleting it cancels
/// it.
class Diagnosis : public QObject
{
    Q_OBJECT

public:
    explicit Diagnosis(settings::Profile profile, QObject *parent = nullptr);
    ~Diagnosis() override;

    /// Takes about as long as a read may take; a few seconds at the most.
    void start();
    /// The rungs so far, in order.
    [[nodiscard]] const QList<Rung> &rungs() const { return m_rungs; }

Q_SIGNALS:
    void rungFinished(const robot::Rung &rung);
    /// All rungs are told, the ones that could not be reached as skipped.
    void finished();

private:
    void resolve();
    void route();
    void ask();
    void onStatus(const values::Result<values::Status> &status);
    void identify();
    void knockAtFiles();
    void hearFiles();
    void add(Rung::Outcome outcome, const QString &sentence, const QString &remedy = {});
    void explainSilence();
    void finish();

    settings::Profile m_profile;
    std::unique_ptr<QHostAddress> m_address; ///< None until the name is resolved.
    std::unique_ptr<session::UdpTransport> m_transport;
    std::unique_ptr<session::Session> m_session;
    std::unique_ptr<QUdpSocket> m_probe; ///< Connected, so that it hears what the network says of an address.
    std::unique_ptr<QUdpSocket> m_files;
    QString m_probeError;
    QList<Rung> m_rungs;
};

} // namespace robot
