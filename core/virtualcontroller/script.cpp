// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "virtualcontroller/script.h"

#include "virtualcontroller/alarms.h"
#include "virtualcontroller/machine.h"
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>

using protocol::IoArea;
using values::Status;

namespace virtualcontroller {

namespace {

/// Seconds of a script; whoever waits longer than a year waits for ever.
Time seconds(const QJsonValue &value) { return Time {qint64(std::clamp(value.toDouble(), 0.0, 3e7) * 1000)}; }

using Happening = std::function<void(Memory &)>;
/// Makes what happens of an event, empty if a value is wrong.
using Maker = Happening (*)(const QJsonValue &, const QJsonObject &);

Happening alarm(const QJsonValue &value, const QJsonObject &event)
{
    const int code = value.toInt();
    if (code < 1 || code > 9999)
        return {};
    values::AlarmWithTexts raised;
    raised.alarm.code = quint32(code);
    raised.alarm.name = values::FixedText<32> {event.value(u"name").toString().toLatin1()};
    raised.alarm.data = {quint32(event.value(u"data").toInt()), values::AlarmDataType(event.value(u"type").toInt())};
    return [raised, hasCause = event.value(u"cause").toBool()](Memory &m) { raiseAlarm(m, raised, hasCause); };
}

Happening causeRemoval(const QJsonValue &value, const QJsonObject &)
{
    return [code = quint32(value.toInt())](Memory &m) { removeCause(m, code); };
}

Happening error(const QJsonValue &value, const QJsonObject &) { return value.toBool() ? raiseError : cancelError; }

Happening input(const QJsonValue &value, const QJsonObject &event)
{
    if (value.toInt() < 1 || !event.value(u"on").isBool())
        return {};
    return [number = value.toInt(), on = event.value(u"on").toBool()](
               Memory &m) { m.setSignal(IoArea::UserInput, number, on); };
}

Happening mode(const QJsonValue &value, const QJsonObject &)
{
    const QString name = value.toString();
    if (name == u"teach")
        return setTeachMode;
    if (name == u"play")
        return setPlayMode;
    if (name == u"remote" || name == u"local")
        return [on = name == u"remote"](Memory &m) { setRemote(m, on); };
    return {};
}

Happening hold(const QJsonValue &value, const QJsonObject &event)
{
    static const std::map<QString, Status::Data2Flag> sources {{QStringLiteral("pendant"), Status::HeldByPendant},
        {QStringLiteral("external"), Status::HeldExternally}, {QStringLiteral("command"), Status::HeldByCommand}};
    const auto source = sources.find(value.toString());
    if (source == sources.end() || !event.value(u"on").isBool())
        return {};
    return [flag = source->second, on = event.value(u"on").toBool()](Memory &m) { setHold(m, flag, on); };
}

Happening servo(const QJsonValue &value, const QJsonObject &)
{
    return [on = value.toBool()](Memory &m) { switchServo(m, on); };
}

Happening safety(const QJsonValue &value, const QJsonObject &)
{
    return [isClosed = value.toBool()](Memory &m) {
        m.interlocks.isSafetyChainClosed = isClosed;
        if (!isClosed)
            switchServo(m, false);
    };
}

Happening silence(const QJsonValue &value, const QJsonObject &)
{
    return [time = seconds(value)](Memory &m) { m.silentUntil = m.now + time; };
}

const std::map<QString, Maker> &makers()
{
    static const std::map<QString, Maker> table {{QStringLiteral("alarm"), alarm},
        {QStringLiteral("removeCause"), causeRemoval}, {QStringLiteral("error"), error},
        {QStringLiteral("input"), input}, {QStringLiteral("mode"), mode}, {QStringLiteral("hold"), hold},
        {QStringLiteral("servo"), servo}, {QStringLiteral("safety"), safety}, {QStringLiteral("silence"), silence}};
    return table;
}

tl::unexpected<values::Error> wrong(qsizetype index, const QString &what)
{
    return values::badInput(QStringLiteral("Event %1 of the script: %2.").arg(index + 1).arg(what));
}

values::Result<Script::Event> parseEvent(qsizetype index, const QJsonObject &object)
{
    const QJsonValue at = object.value(u"at");
    if (!at.isDouble() || at.toDouble() < 0)
        return wrong(index, QStringLiteral("\"at\" is not a time in seconds"));
    for (const auto &[key, maker] : makers()) {
        if (!object.contains(key))
            continue;
        if (Happening happening = maker(object.value(key), object))
            return Script::Event {seconds(at), std::move(happening)};
        return wrong(index, QStringLiteral("\"%1\" cannot be like that").arg(key));
    }
    return wrong(index, QStringLiteral("it has no key that says what happens"));
}

} // namespace

Script::Script(std::vector<Event> events) : m_events {std::move(events)}
{
    std::ranges::stable_sort(m_events, {}, &Event::at);
}

values::Result<Script> Script::parse(const QByteArray &json)
{
    QJsonParseError fault;
    const QJsonDocument document = QJsonDocument::fromJson(json, &fault);
    if (!document.isArray())
        return values::badInput(
            QStringLiteral("The script is not a JSON array of events: %1.").arg(fault.errorString()));
    std::vector<Event> events;
    const QJsonArray array = document.array();
    for (qsizetype index = 0; index < array.size(); ++index) {
        auto event = parseEvent(index, array[index].toObject());
        if (!event)
            return tl::unexpected(event.error());
        events.push_back(std::move(*event));
    }
    return Script {std::move(events)};
}

void Script::run(Memory &memory, Time now)
{
    while (m_done < m_events.size() && m_events[m_done].at <= now) {
        advanceTo(memory, m_events[m_done].at);
        m_events[m_done++].happen(memory);
    }
    advanceTo(memory, now);
}

std::optional<Time> Script::next() const
{
    return m_done < m_events.size() ? std::optional {m_events[m_done].at} : std::nullopt;
}

} // namespace virtualcontroller
