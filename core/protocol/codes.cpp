// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "protocol/codes.h"

#include "protocol/fields.h"
#include <QCoreApplication>
#include <algorithm>
#include <array>

using values::Error;
using values::ErrorKind;

namespace protocol {

namespace {

constexpr std::array<quint16, 5> busyCodes {0x2090, 0xD8F1, 0xD8FA, 0xE444, 0xFFF6};

QString translated(const char *text) { return QCoreApplication::translate("protocol", text); }

/// What a status means that carries no code of its own (reference §1.6); 0 where nothing is known.
quint16 codeOfBareStatus(quint8 status)
{
    switch (status) {
    case 0x08: return 0xA000;
    case 0x09: return 0xA002;
    case 0x28: return 0xA001;
    default: return 0;
    }
}

QString explainRefusal(const Error &refusal)
{
    const quint16 code = effectiveCode(refusal);
    if (code == 0)
        return translated(QT_TRANSLATE_NOOP("protocol", "refused with status %1, which is not in the code list"))
            .arg(hexWord(refusal.status, 2));
    const StatusCode *row = findStatusCode(code);
    if (!row)
        return translated(QT_TRANSLATE_NOOP("protocol", "%1 refused, with a code that is not in the code list"))
            .arg(hexWord(code, 4));
    if (!*row->remedy)
        return QStringLiteral("%1 %2").arg(hexWord(code, 4), translated(row->meaning));
    return QStringLiteral("%1 %2 — %3").arg(hexWord(code, 4), translated(row->meaning), translated(row->remedy));
}

const char *sentence(ErrorKind kind)
{
    switch (kind) {
    case ErrorKind::Refused: break;
    case ErrorKind::NoAnswer:
        return QT_TRANSLATE_NOOP("protocol", "the controller did not answer; nothing was changed");
    case ErrorKind::UnknownOutcome:
        return QT_TRANSLATE_NOOP("protocol", "no answer: it may or may not have happened — look at the robot");
    case ErrorKind::Malformed: return QT_TRANSLATE_NOOP("protocol", "the answer does not fit the question");
    case ErrorKind::NotSent: return QT_TRANSLATE_NOOP("protocol", "nothing was sent");
    case ErrorKind::Network: return QT_TRANSLATE_NOOP("protocol", "this computer's network refused");
    case ErrorKind::BadInput: return QT_TRANSLATE_NOOP("protocol", "this cannot be sent to a controller");
    case ErrorKind::LocalFile:
        return QT_TRANSLATE_NOOP("protocol", "a file on this computer could not be read or written");
    case ErrorKind::Cancelled: return QT_TRANSLATE_NOOP("protocol", "cancelled");
    }
    return "";
}

} // namespace

const StatusCode *findStatusCode(quint16 code)
{
    const auto rows = statusCodes();
    const auto found = std::ranges::lower_bound(rows, code, {}, &StatusCode::code);
    return found != rows.end() && found->code == code ? &*found : nullptr;
}

bool isNotTaught(const Error &error)
{
    const quint16 code = effectiveCode(error);
    return error.kind == ErrorKind::Refused && (code == 0xB001 || code == 0xB005);
}

quint16 effectiveCode(const Error &refusal)
{
    return refusal.addedStatus ? refusal.addedStatus : codeOfBareStatus(refusal.status);
}

bool isBusy(const Error &error)
{
    return error.kind == ErrorKind::Refused && std::ranges::find(busyCodes, effectiveCode(error)) != busyCodes.end();
}

QString explain(const Error &error)
{
    if (error.kind == ErrorKind::Refused)
        return explainRefusal(error);
    const QString text = translated(sentence(error.kind));
    return error.detail.isEmpty() ? text : QStringLiteral("%1 (%2)").arg(text, error.detail);
}

} // namespace protocol
