// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/messages.h"

#include "protocol/codes.h"
#include <QCoreApplication>

namespace ui {

using robot::HoldWord;
using robot::LinkState;
using widgets::Severity;

namespace {

struct Messages {
    Q_DECLARE_TR_FUNCTIONS(Messages)
};

QString timeOf(const QDateTime &clock) { return clock.toString(u"HH:mm:ss"); }

Notice plain(Severity severity, const QString &text) { return {{severity, text, {}}, {}}; }

Notice withDiagnosis(Severity severity, const QString &text)
{
    return {{severity, text, Messages::tr("Diagnose…")}, ActionId::Diagnose};
}

Notice holdNotice(const LinkView &link)
{
    if (link.hold.word == HoldWord::Unconfirmed)
        return withDiagnosis(Severity::Alarm, Messages::tr("HOLD not confirmed: use the pendant."));
    if (link.hold.word == HoldWord::Refused)
        return plain(Severity::Alarm,
            Messages::tr("HOLD was refused: %1. Use the pendant.")
                .arg(protocol::explain(link.hold.refusal.value_or(values::Error {}))));
    return {};
}

Notice checkingNotice(const LinkView &link, const settings::Profile &profile)
{
    if (link.trouble)
        return withDiagnosis(Severity::Warning,
            Messages::tr("No contact with %1 yet: %2. Checking goes on by itself.")
                .arg(addressText(profile), protocol::explain(*link.trouble)));
    return withDiagnosis(Severity::Notice,
        Messages::tr("Checking %1: waiting for system information and status.").arg(addressText(profile)));
}

Notice linkNotice(const LinkView &link, const settings::Profile &profile)
{
    switch (link.state) {
    case LinkState::Lost:
        return withDiagnosis(Severity::Warning,
            Messages::tr("Communication lost at %1 — showing the last values read. Reading resumes by itself.")
                .arg(timeOf(link.since)));
    case LinkState::Checking: return checkingNotice(link, profile);
    case LinkState::Monitoring:
        if (link.timesLost > 0)
            return plain(Severity::Notice,
                Messages::tr("Communication restored at %1. Lost %n time(s) since connecting.", nullptr, link.timesLost)
                    .arg(timeOf(link.since)));
        break;
    case LinkState::Disconnected: break;
    }
    return {};
}

} // namespace

Notice noticeOf(const LinkView &link, const settings::Profile &profile)
{
    if (link.state == LinkState::Disconnected)
        return {};
    Notice about = linkNotice(link, profile);
    Notice hold = holdNotice(link);
    if (hold.message.text.isEmpty())
        return about;
    if (about.message.severity != Severity::Notice)
        hold.message.text += u' ' + about.message.text;
    return hold;
}

Notice holdWithoutLink()
{
    return {
        {Severity::Alarm, Messages::tr("HOLD was not sent: there is no connection to a controller. Use the pendant."),
            Messages::tr("Connect…")},
        ActionId::Connect};
}

} // namespace ui
