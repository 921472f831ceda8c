// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "cell/subject.h"

#include "cellfiles/signalnames.h"
#include <QRegularExpression>
#include <array>
#include <limits>

namespace cell {

namespace {

using Kind = Subject::Kind;
constexpr int most = std::numeric_limits<int>::max();
constexpr int areaSize = 10'000;

constexpr std::array<std::pair<QByteArrayView, Kind>, 8> variableKinds {{{"B", Kind::B}, {"I", Kind::I}, {"D", Kind::D},
    {"R", Kind::R}, {"S", Kind::S}, {"P", Kind::P}, {"BP", Kind::BP}, {"EX", Kind::EX}}};

/// A notation of jobs for signals (INFORM reference §5.2): where its area begins, and how many signals a number is.
struct SignalNotation {
    QByteArrayView type;
    int area;
    int width;
};
constexpr std::array signalNotations {
    SignalNotation {"IN", 0, 1},
    SignalNotation {"OT", 10'000, 1},
    SignalNotation {"SIN", 40'000, 1},
    SignalNotation {"SOUT", 50'000, 1},
    SignalNotation {"IG", 0, 8},
    SignalNotation {"OG", 10'000, 8},
    SignalNotation {"IGH", 0, 4},
    SignalNotation {"OGH", 10'000, 4},
};

const SignalNotation *findNotation(QByteArrayView type)
{
    const auto found = std::ranges::find(signalNotations, type, &SignalNotation::type);
    return found == signalNotations.end() ? nullptr : &*found;
}

std::optional<Kind> numberedKind(QByteArrayView type)
{
    if (type == "TL")
        return Kind::Tool;
    if (type == "UF")
        return Kind::UserFrame;
    if (type == "MREG")
        return Kind::Register;
    if (type == "MJ")
        return Kind::Macro;
    if (type == "STEP" || type == "IARG")
        return std::nullopt; // of one job
    return Kind::Numbered;
}

QList<Subject> signalsOf(const SignalNotation &notation, int number)
{
    QList<Subject> subjects;
    if (number < 1 || number > areaSize)
        return subjects;
    const int first = (number - 1) * notation.width + 1;
    for (int index = first; index < first + notation.width; ++index)
        subjects << Subject {Kind::Signal, cellfiles::logicalNumber(notation.area, index)};
    return subjects;
}

Subject numbered(Kind kind, QByteArrayView type, int number)
{
    return {kind, number, kind == Kind::Numbered ? type.toByteArray() : QByteArray {}};
}

QString padded(QLatin1StringView letters, int number)
{
    return letters + QString::number(number).rightJustified(3, u'0');
}

/// "IN#(5)" for what jobs can name, else the logical number.
QString signalText(int number)
{
    const int area = number / areaSize * areaSize;
    const int index = ((number - area) / 10 - 1) * 8 + number % 10 + 1;
    if (index >= 1 && area <= 10'000)
        return (area == 0 ? QStringLiteral("IN#(%1)") : QStringLiteral("OT#(%1)")).arg(index);
    return u'#' + QString::number(number).rightJustified(5, u'0');
}

} // namespace

QString toString(const Subject &subject)
{
    if (isVariable(subject.kind))
        return padded(QLatin1StringView {variableKinds[std::size_t(subject.kind)].first}, subject.number);
    switch (subject.kind) {
    case Kind::Register: return padded(QLatin1StringView {"M"}, subject.number);
    case Kind::Signal: return signalText(subject.number);
    case Kind::Tool: return QStringLiteral("TOOL %1").arg(subject.number);
    case Kind::UserFrame: return QStringLiteral("UF#(%1)").arg(subject.number);
    case Kind::Macro: return QStringLiteral("MJ#(%1)").arg(subject.number);
    case Kind::Numbered: return QStringLiteral("%1#(%2)").arg(QLatin1StringView {subject.name}).arg(subject.number);
    case Kind::Alarm: return QString::number(subject.number);
    default: return QString::fromLatin1(subject.name);
    }
}

std::optional<Subject> subjectFromText(QStringView text)
{
    static const QRegularExpression variable {
        QStringLiteral("^(B|I|D|R|S|P|BP|EX|M)\\s*0*(\\d{1,5})$"), QRegularExpression::CaseInsensitiveOption};
    static const QRegularExpression logical {QStringLiteral("^#0*(\\d{1,5})$")};
    static const QRegularExpression alarm {QStringLiteral("^[89]\\d{3}$")};
    static const QRegularExpression numberedForm {
        QStringLiteral("^(TOOL|UF|TL|MJ|IN|OUT|OT|[A-Z]{2,5}#)\\s*#?\\s*\\(?\\s*(\\d{1,5})\\s*\\)?$"),
        QRegularExpression::CaseInsensitiveOption};
    const QString trimmed = text.trimmed().toString();
    if (trimmed.isEmpty())
        return std::nullopt;
    if (const auto match = variable.match(trimmed); match.hasMatch()) {
        const QByteArray letters = match.captured(1).toUpper().toLatin1();
        const auto kind =
            std::ranges::find(variableKinds, QByteArrayView {letters}, &std::pair<QByteArrayView, Kind>::first);
        return Subject {kind == variableKinds.end() ? Kind::Register : kind->second, match.captured(2).toInt()};
    }
    if (const auto match = logical.match(trimmed); match.hasMatch())
        return Subject {Kind::Signal, match.captured(1).toInt()};
    if (alarm.match(trimmed).hasMatch())
        return Subject {Kind::Alarm, trimmed.toInt()};
    if (const auto match = numberedForm.match(trimmed); match.hasMatch()) {
        QByteArray type = match.captured(1).toUpper().toLatin1();
        if (type.endsWith('#'))
            type.chop(1);
        type = type == "OUT" ? "OT" : type == "TOOL" ? "TL" : type;
        const QList<Subject> found = subjectsOf(type + "#(" + match.captured(2).toLatin1() + ')');
        if (!found.isEmpty())
            return found.first();
    }
    if (trimmed.startsWith(u'$'))
        return Subject {Kind::System, 0, trimmed.toUpper().toLatin1()};
    return Subject {Kind::Job, 0, trimmed.toLatin1()};
}

QList<Subject> subjectsOf(QByteArrayView reference)
{
    if (reference.startsWith('$'))
        return {{Kind::System, 0, reference.toByteArray()}};
    if (reference.startsWith("alarm "))
        return {{Kind::Alarm, reference.sliced(6).toInt()}};
    if (const qsizetype hash = reference.indexOf('#'); hash > 0) {
        const QByteArrayView type = reference.first(hash);
        const int number = reference.sliced(hash + 1).chopped(1).sliced(1).toInt();
        if (const auto *notation = findNotation(type))
            return signalsOf(*notation, number);
        const auto kind = numberedKind(type);
        return kind ? QList<Subject> {numbered(*kind, type, number)} : QList<Subject> {};
    }
    const auto name = inform::variableName(reference);
    if (!name || name->isLocal || name->number < 0)
        return {};
    const auto kind = std::ranges::find(variableKinds, name->type, &std::pair<QByteArrayView, Kind>::first);
    return kind == variableKinds.end() ? QList<Subject> {} : QList<Subject> {{kind->second, name->number}};
}

std::optional<AnyOf> anyOf(QByteArrayView reference)
{
    if (const qsizetype hash = reference.indexOf('#'); hash > 0) {
        const QByteArrayView type = reference.first(hash);
        if (const auto *notation = findNotation(type))
            return AnyOf {Kind::Signal, {}, notation->area, notation->area + areaSize - 1};
        const auto kind = numberedKind(type);
        return kind ? std::optional {AnyOf {*kind, numbered(*kind, type, 0).name, 0, most}} : std::nullopt;
    }
    const auto kind = std::ranges::find(variableKinds, reference, &std::pair<QByteArrayView, Kind>::first);
    return kind == variableKinds.end() ? std::nullopt : std::optional {AnyOf {kind->second, {}, 0, most}};
}

} // namespace cell
