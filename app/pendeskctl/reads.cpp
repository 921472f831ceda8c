// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "verbs.h"

#include "named.h"
#include "protocol/fields.h"
#include "protocol/payloads.h"
#include "protocol/requests.h"
#include "writes.h"
#include <QDateTime>
#include <QJsonArray>
#include <QRegularExpression>
#include <QTimer>
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
    for (const QJsonValue &part : value.toArray())
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

/// Sends one read and prints its fields.
template <typename Read> int readAndPrint(const Call &call, const Read &order)
{
    return run(call, [order](Desk &desk) {
        desk.robot().send(order, &desk, [&desk](const Result<typename Read::Reply> &reply) {
            if (!reply)
                return desk.fail(reply.error());
            printFields(desk, fieldsOf(*reply, desk));
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

/// "IN", "0..99", "005" with what `registers` means by them.
QString registerWord(const QString &word) { return word.startsWith(u'M') ? word : u'M' + word; }

std::optional<QList<Selection>> selections(const Call &call, const QStringList &words)
{
    QList<Selection> result;
    for (const QString &word : words) {
        const auto selection = selectionFromText(word, call.profile.dialect());
        if (!selection) {
            complain(selection.error().detail);
            return std::nullopt;
        }
        result << *selection;
    }
    if (result.isEmpty()) {
        complain(tr("Say what to read."));
        return std::nullopt;
    }
    return result;
}

int getNamed(const Call &call, const QStringList &words)
{
    const auto wanted = selections(call, words);
    if (!wanted)
        return Usage;
    return run(call, [wanted](Desk &desk) {
        readAll(desk, *wanted, [&desk](const Result<QList<NamedValue>> &values) {
            if (!values)
                return desk.fail(values.error());
            print(desk.call(), *values);
            desk.finish(Done);
        });
    });
}

using Setter = int (*)(const Call &call, const QString &word, const QString &typed);

int getOrSet(const QStringList &arguments, const VerbHelp &help, QString (*wordOf)(const QString &), Setter set)
{
    Call call;
    QCommandLineParser parser;
    if (const auto end = read(call, parser, help, arguments))
        return *end;
    QStringList words = call.words.mid(1);
    const QString what = call.words.value(0);
    if (what == u"get") {
        for (QString &word : words)
            word = wordOf(word);
        return getNamed(call, words);
    }
    if (what == u"set" && words.size() == 2)
        return set(call, wordOf(words[0]), words[1]);
    return mistake(tr("Say “get NAME…” or “set NAME VALUE”."));
}

QString asItIs(const QString &word) { return word; }

} // namespace

int runInfo(const QStringList &arguments)
{
    Call call;
    QCommandLineParser parser;
    if (const auto end = read(call, parser, {tr("Reads model, system software and parameter version."), {}}, arguments))
        return *end;
    return readAndPrint(call, protocol::ReadSystemInformation::robot(1));
}

int runPosition(const QStringList &arguments)
{
    Call call;
    QCommandLineParser parser;
    const QCommandLineOption pulse {QStringLiteral("pulse"), tr("In pulses instead of the base frame.")};
    if (const auto end = read(call, parser, {tr("Reads where the first robot stands."), {}, {pulse}}, arguments))
        return *end;
    const bool inPulses = parser.isSet(pulse);
    const auto group = inPulses ? values::ControlGroup::robotPulse(1) : values::ControlGroup::robotCartesian(1);
    return readAndPrint(call, protocol::ReadPosition {group});
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

int runIo(const QStringList &arguments)
{
    return getOrSet(arguments,
        {tr("Reads rows of I/O groups (2701..2710) or signals (27010, IN#(1)); writes one network input."),
            QStringLiteral("get GROUP[..GROUP]|SIGNAL… | set SIGNAL 0|1")},
        asItIs, setSignal);
}

int runRegisters(const QStringList &arguments)
{
    return getOrSet(arguments,
        {tr("Reads registers; writes one and reads it back."), QStringLiteral("get N[..N]… | set N VALUE")},
        registerWord, setVariable);
}

int runVar(const QStringList &arguments)
{
    return getOrSet(arguments,
        {tr("Reads variables B I D R S P BP EX; writes one and reads it back."),
            QStringLiteral("get NAME[..NAME]… | set NAME VALUE")},
        asItIs, setVariable);
}

int runWatch(const QStringList &arguments)
{
    Call call;
    QCommandLineParser parser;
    const QCommandLineOption every {QStringLiteral("every"), tr("Time between two readings: 1s, 200ms."),
        QStringLiteral("TIME"), QStringLiteral("1s")};
    const QCommandLineOption count {
        QStringLiteral("count"), tr("End after so many readings."), QStringLiteral("N"), QStringLiteral("0")};
    const VerbHelp help {tr("Reads variables, registers (M005) and I/O again and again, one line of JSON with --json."),
        QStringLiteral("NAME…"), {every, count}};
    if (const auto end = read(call, parser, help, arguments))
        return *end;
    static const QRegularExpression form {QStringLiteral("^(\\d{1,6})(ms|s)$")};
    const auto match = form.match(parser.value(every));
    bool isNumber = false;
    const int readings = parser.value(count).toInt(&isNumber);
    if (!match.hasMatch() || !isNumber || readings < 0)
        return mistake(tr("--every takes a time such as 200ms or 1s, --count a whole number."));
    const std::chrono::milliseconds period {match.captured(1).toInt() * (match.captured(2) == u"s" ? 1000 : 1)};
    const auto wanted = selections(call, call.words);
    if (!wanted)
        return Usage;
    return run(call, [=](Desk &desk) {
        auto *timer = new QTimer {&desk};
        auto left = std::make_shared<int>(readings);
        auto isReading = std::make_shared<bool>(false);
        const auto take = [&desk, left, isReading](const Result<QList<NamedValue>> &values) {
            *isReading = false;
            if (!values)
                return desk.fail(values.error());
            if (!desk.call().isJson)
                print(QDateTime::currentDateTimeUtc().toString(Qt::ISODateWithMs));
            print(desk.call(), *values);
            if (*left > 0 && --*left == 0)
                desk.finish(Done);
        };
        QObject::connect(timer, &QTimer::timeout, &desk, [&desk, wanted, take, isReading] {
            if (!std::exchange(*isReading, true))
                readAll(desk, *wanted, take);
        });
        timer->start(period);
        *isReading = true;
        readAll(desk, *wanted, take);
    });
}

} // namespace pendeskctl
