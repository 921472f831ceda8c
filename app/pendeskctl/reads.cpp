// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "verbs.h"

#include "desk.h"
#include "protocol/fields.h"
#include "protocol/payloads.h"
#include "protocol/requests.h"
#include "robot/snapshot.h"
#include <QJsonArray>
#include <memory>

using values::Error;
using values::Result;

namespace pendeskctl {

namespace {

/// The named fields of a value, as `pendeskctl decode` names them.
template <typename Value> protocol::Fields fieldsOf(const Value &value, const Desk &desk)
{
    const QByteArray payload = protocol::encode(value);
    protocol::FieldReader reader {payload, 0, desk.codec()};
    Value copy = value;
    protocol::Layout<Value>::describe(reader, copy);
    return reader.fields();
}

QString textOf(const QJsonValue &value)
{
    if (!value.isArray())
        return value.toVariant().toString();
    QStringList parts;
    for (const QJsonValue part : value.toArray())
        parts << part.toVariant().toString();
    return parts.join(QStringLiteral(", "));
}

QJsonObject jsonOf(const protocol::Fields &fields)
{
    QJsonObject json;
    for (const protocol::Field &field : fields)
        json.insert(field.name, field.value);
    return json;
}

void printFields(const Desk &desk, const protocol::Fields &fields)
{
    if (desk.call().isJson)
        return print(QJsonValue {jsonOf(fields)});
    for (const protocol::Field &field : fields)
        print(QStringLiteral("%1  %2").arg(field.name, textOf(field.value)));
}

/// The axes with their names and units, then what else tells where that is.
void printPosition(Desk &desk, const values::Position &position, const values::AxisNames &names)
{
    const protocol::Fields fields = fieldsOf(position, desk);
    if (desk.call().isJson)
        return printFields(desk, fields);
    for (const QString &word : robot::axisWords(position, names))
        print(word);
    const bool isPulse = values::axisUnit(position.type, 0) == values::AxisUnit::Pulse;
    for (const protocol::Field &field : fields) {
        if (field.name == u"tool" || (!isPulse && field.name == u"form_words"))
            print(QStringLiteral("%1: %2").arg(QString {field.name}.replace(u'_', u' '), textOf(field.value)));
    }
}

void readPosition(Desk &desk, values::ControlGroup group)
{
    desk.robot().send(protocol::ReadAxisNames {group}, &desk, [&desk, group](const Result<values::AxisNames> &names) {
        desk.robot().send(
            protocol::ReadPosition {group}, &desk, [&desk, names](const Result<values::Position> &position) {
                if (!position)
                    return desk.fail(position.error());
                printPosition(desk, *position, names.value_or(values::AxisNames {}));
                desk.finish(Done);
            });
    });
}

using values::AlarmHistoryClass;

std::optional<AlarmHistoryClass> findHistory(const QString &name)
{
    const std::pair<QStringView, AlarmHistoryClass> rows[] {{u"major", AlarmHistoryClass::Major},
        {u"minor", AlarmHistoryClass::Minor}, {u"system", AlarmHistoryClass::UserSystem},
        {u"user", AlarmHistoryClass::User}, {u"offline", AlarmHistoryClass::Offline}};
    for (const auto &[key, list] : rows) {
        if (name == key)
            return list;
    }
    return std::nullopt;
}

/// Reads alarms from the newest on until there are no more.
struct AlarmReader : std::enable_shared_from_this<AlarmReader> {
    AlarmReader(Desk &someDesk, std::optional<AlarmHistoryClass> someList) : desk {someDesk}, list {someList} { }

    void next()
    {
        const int last = list ? values::alarmHistoryLength : values::activeAlarmCount;
        if (++entry > last)
            return end();
        const auto take = [self = shared_from_this()](const Result<values::Alarm> &alarm) { self->take(alarm); };
        if (list)
            desk.robot().send(protocol::ReadAlarmHistory {*list, entry}, &desk, take);
        else
            desk.robot().send(protocol::ReadAlarm {entry}, &desk, take);
    }

    void take(const Result<values::Alarm> &alarm)
    {
        if (!alarm)
            return desk.fail(alarm.error());
        if (alarm->isEmpty())
            return end();
        QJsonObject json = jsonOf(fieldsOf(*alarm, desk));
        const QString line = QStringLiteral("%1  %2  %3  %4")
                                 .arg(desk.codec().decode(alarm->time.bytes()))
                                 .arg(alarm->code, 4, 10, QLatin1Char('0'))
                                 .arg(desk.codec().decode(alarm->name.bytes()), alarm->data.toString());
        if (!desk.call().isJson)
            print(line.trimmed());
        alarms << json;
        next();
    }

    void end()
    {
        if (desk.call().isJson)
            print(QJsonValue {alarms});
        else if (alarms.isEmpty() && !desk.call().isQuiet)
            complain(tr("There are no alarms."));
        desk.finish(Done);
    }

    Desk &desk;
    std::optional<AlarmHistoryClass> list;
    int entry = 0;
    QJsonArray alarms;
};

/// The group that "R1", "B1" or "S1" names, in the coordinates that are read of it.
std::optional<values::ControlGroup> findGroup(const QString &name, bool inPulses, const protocol::Dialect &dialect)
{
    using values::ControlGroup;
    bool isNumber = false;
    const int number = name.mid(1).toInt(&isNumber);
    const auto isUpTo = [&](int last) { return isNumber && number >= 1 && number <= last; };
    switch (name.isEmpty() ? u' ' : name[0].toUpper().unicode()) {
    case u'R':
        if (!isUpTo(dialect.robots))
            return std::nullopt;
        return inPulses ? ControlGroup::robotPulse(number) : ControlGroup::robotCartesian(number);
    case u'B': return isUpTo(dialect.bases) ? std::optional {ControlGroup::basePulse(number)} : std::nullopt;
    case u'S': return isUpTo(dialect.stations) ? std::optional {ControlGroup::stationPulse(number)} : std::nullopt;
    default: return std::nullopt;
    }
}

} // namespace

int runInfo(const QStringList &arguments)
{
    Call call;
    QCommandLineParser parser;
    if (const auto end = read(call, parser, {tr("Reads model, system software and parameter version."), {}}, arguments))
        return *end;
    return run(call, [](Desk &desk) {
        desk.robot().send(
            protocol::ReadSystemInformation::robot(1), &desk, [&desk](const Result<values::SystemInformation> &system) {
                if (!system)
                    return desk.fail(system.error());
                printFields(desk, fieldsOf(*system, desk));
                desk.finish(Done);
            });
    });
}

int runPosition(const QStringList &arguments)
{
    Call call;
    QCommandLineParser parser;
    const QCommandLineOption pulse {QStringLiteral("pulse"), tr("In pulses instead of the base frame.")};
    const VerbHelp help {tr("Reads where a control group stands: the first robot, or R2, B1, S1."),
        QStringLiteral("[GROUP]"), {pulse}, true, 0, 1};
    if (const auto end = read(call, parser, help, arguments))
        return *end;
    const QString name = call.words.value(0, QStringLiteral("R1"));
    const auto group = findGroup(name, parser.isSet(pulse), call.profile.dialect());
    if (!group)
        return mistake(tr("“%1” is no control group of a %2: say R1, B1 or S1.")
                           .arg(name, QLatin1String(call.profile.dialect().name)));
    return run(call, [group](Desk &desk) { readPosition(desk, *group); });
}

int runAlarms(const QStringList &arguments)
{
    Call call;
    QCommandLineParser parser;
    const QCommandLineOption history {QStringLiteral("history"),
        tr("A list of the history instead: major, minor, user, system or offline."), QStringLiteral("LIST")};
    if (const auto end = read(call, parser, {tr("Reads the active alarms, newest first."), {}, {history}}, arguments))
        return *end;
    const auto list = findHistory(parser.value(history));
    if (parser.isSet(history) && !list)
        return mistake(tr("--history takes major, minor, user, system or offline."));
    return run(call, [list](Desk &desk) { std::make_shared<AlarmReader>(desk, list)->next(); });
}

} // namespace pendeskctl
