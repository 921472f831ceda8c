// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "named.h"

#include "names/signal.h"
#include "protocol/datarequests.h"
#include "variables/text.h"
#include <QJsonArray>
#include <QRegularExpression>
#include <cmath>
#include <memory>

using protocol::Chunk;
using values::ErrorKind;
using values::Result;
using variables::Kind;
using variables::Value;

namespace pendeskctl {

namespace {

template <typename Item> using ItemsHandler = std::function<void(const Result<QList<Item>> &)>;

/// Reads the chunks of a range one after the other.
template <typename Item> class RangeReader : public std::enable_shared_from_this<RangeReader<Item>>
{
public:
    RangeReader(Desk &desk, protocol::InstanceRange range, quint16 lastOfArea, ItemsHandler<Item> handler)
        : m_desk {desk},
          m_chunks {protocol::chunksToRead(protocol::pluralRule<Item>(), range, lastOfArea)},
          m_handler {std::move(handler)}
    {
    }

    void next()
    {
        if (m_chunks.isEmpty())
            return m_handler(m_items);
        const Chunk chunk = m_chunks.takeFirst();
        const auto self = this->shared_from_this();
        if (chunk.isSingle())
            m_desk.robot().send(protocol::ReadItem<Item> {chunk.first}, &m_desk, [self](const Result<Item> &item) {
                self->take(item.map([](const Item &value) { return QList<Item> {value}; }), 1);
            });
        else
            m_desk.robot().send(*protocol::ReadItems<Item>::create(chunk.first, chunk.count), &m_desk,
                [self, chunk](const Result<QList<Item>> &items) { self->take(items, chunk.wanted); });
    }

private:
    void take(const Result<QList<Item>> &items, int wanted)
    {
        if (!items)
            return m_handler(items);
        m_items << items->first(wanted);
        next();
    }

    Desk &m_desk;
    QList<Chunk> m_chunks;
    ItemsHandler<Item> m_handler;
    QList<Item> m_items;
};

template <typename Item>
void readRange(Desk &desk, int first, int last, int lastOfArea, const ItemsHandler<Item> &handler)
{
    const protocol::InstanceRange range {quint16(first), quint16(last)};
    std::make_shared<RangeReader<Item>>(desk, range, quint16(lastOfArea), handler)->next();
}

variables::Format formatOf(const Desk &desk)
{
    variables::Format format;
    format.codec = desk.codec();
    format.stringSize = desk.dialect().stringSize;
    return format;
}

QJsonValue jsonOf(const Value &value, const QString &text)
{
    switch (variables::kindOf(value)) {
    case Kind::B:
    case Kind::I:
    case Kind::D:
    case Kind::R:
    case Kind::M: break;
    default: return text;
    }
    bool isNumber = false;
    const double number = text.toDouble(&isNumber);
    return isNumber && std::isfinite(number) ? QJsonValue {number} : QJsonValue {}; // JSON has no NaN and no infinity
}

NamedValue named(const variables::Reference &reference, const Value &value, const Desk &desk)
{
    const QString text = toText(value, formatOf(desk));
    return {toString(reference), text, jsonOf(value, text)};
}

quint16 instanceOf(Kind kind, int number, const protocol::Dialect &dialect)
{
    return kind == Kind::M ? quint16(number) : protocol::variableInstance(number, dialect.numbering);
}

template <typename Wire, Kind kind> void readVariables(Desk &desk, const variables::Range &range, ValuesHandler handler)
{
    const auto dialect = desk.dialect();
    const auto take = [&desk, range, handler = std::move(handler)](const Result<QList<Wire>> &items) {
        if (!items)
            return handler(tl::unexpected(items.error()));
        QList<NamedValue> result;
        for (int index = 0; index < items->size(); ++index) {
            variables::ValueOf<kind> value {};
            if constexpr (std::is_same_v<Wire, values::StringVariable16>)
                value.value = values::FixedText<32> {(*items)[index].value.bytes()};
            else
                value = (*items)[index];
            result << named({kind, range.first + index}, Value {value}, desk);
        }
        handler(result);
    };
    // Beyond the standard ones nobody knows which is the last: then not one more is asked for than is wanted.
    const int last = std::max(range.last, countOf(kind, dialect) - 1);
    readRange<Wire>(desk, instanceOf(kind, range.first, dialect), instanceOf(kind, range.last, dialect),
        instanceOf(kind, last, dialect), take);
}

void readVariables(Desk &desk, const variables::Range &range, const ValuesHandler &handler)
{
    using namespace values;
    switch (range.kind) {
    case Kind::B: return readVariables<ByteVariable, Kind::B>(desk, range, handler);
    case Kind::I: return readVariables<IntegerVariable, Kind::I>(desk, range, handler);
    case Kind::D: return readVariables<DoubleVariable, Kind::D>(desk, range, handler);
    case Kind::R: return readVariables<RealVariable, Kind::R>(desk, range, handler);
    case Kind::S:
        return desk.dialect().stringSize == 16 ? readVariables<StringVariable16, Kind::S>(desk, range, handler)
                                               : readVariables<StringVariable32, Kind::S>(desk, range, handler);
    case Kind::P: return readVariables<PositionVariable, Kind::P>(desk, range, handler);
    case Kind::BP: return readVariables<BasePosition, Kind::BP>(desk, range, handler);
    case Kind::EX: return readVariables<ExternalPosition, Kind::EX>(desk, range, handler);
    case Kind::M: return readVariables<Register, Kind::M>(desk, range, handler);
    }
}

NamedValue named(int group, values::IoGroup value)
{
    QStringList bits;
    QJsonArray json;
    for (int bit = 0; bit < names::signalsPerGroup; ++bit) {
        bits << QString::number(int(value.isOn(bit)));
        json << int(value.isOn(bit));
    }
    return {QString::number(group), bits.join(u' '), json};
}

void readGroups(Desk &desk, const Selection &selection, const ValuesHandler &handler)
{
    const auto area = desk.dialect().ioArea(quint32(selection.first));
    const int last = desk.dialect().ioRange(*area).last;
    readRange<values::IoGroup>(
        desk, selection.first, selection.last, last, [selection, handler](const Result<QList<values::IoGroup>> &items) {
            handler(items.map([&](const QList<values::IoGroup> &groups) {
                QList<NamedValue> result;
                for (int index = 0; index < groups.size(); ++index)
                    result << named(selection.first + index, groups[index]);
                return result;
            }));
        });
}

void readSignal(Desk &desk, const Selection &selection, const ValuesHandler &handler)
{
    const protocol::ReadItem<values::IoGroup> order {quint16(selection.first)};
    desk.robot().send(order, &desk, [selection, handler](const Result<values::IoGroup> &group) {
        handler(group.map([&](values::IoGroup value) {
            const bool isOn = value.isOn(selection.bit);
            const QString name = names::toString(names::Signal {selection.first, selection.bit});
            return QList<NamedValue> {{name, QString::number(int(isOn)), int(isOn)}};
        }));
    });
}

void read(Desk &desk, const Selection &selection, const ValuesHandler &handler)
{
    switch (selection.what) {
    case Selection::What::Variables: return readVariables(desk, selection.range, handler);
    case Selection::What::Groups: return readGroups(desk, selection, handler);
    case Selection::What::Signal: return readSignal(desk, selection, handler);
    }
}

} // namespace

Result<Selection> selectionFromText(const QString &text, const protocol::Dialect &dialect)
{
    static const QRegularExpression groups {QStringLiteral("^(\\d{1,4})(?:\\.\\.(\\d{1,4}))?$")};
    static const QRegularExpression signal {
        QStringLiteral("^(#?\\d{5}|(IN|OT|OUT)#?\\(?\\d+\\)?)$"), QRegularExpression::CaseInsensitiveOption};
    Selection selection;
    if (const auto match = groups.match(text); match.hasMatch()) {
        selection.what = Selection::What::Groups;
        selection.first = match.captured(1).toInt();
        selection.last = match.captured(2).isEmpty() ? selection.first : match.captured(2).toInt();
        const auto area = dialect.ioArea(quint32(selection.first));
        if (!area || selection.last < selection.first || dialect.ioArea(quint32(selection.last)) != area)
            return values::failure(
                ErrorKind::BadInput, tr("%1: the controller has no such row of I/O groups.").arg(text));
        return selection;
    }
    if (signal.match(text).hasMatch()) {
        return names::signalFromText(text, dialect).map([&](const names::Signal &found) {
            selection.what = Selection::What::Signal;
            selection.first = found.group;
            selection.bit = found.bit;
            return selection;
        });
    }
    return variables::rangeFromText(text, dialect).map([&](const variables::Range &range) {
        selection.range = range;
        return selection;
    });
}

void readAll(Desk &desk, const QList<Selection> &selections, const ValuesHandler &handler)
{
    if (selections.isEmpty())
        return handler(QList<NamedValue> {});
    read(
        desk, selections.first(), [&desk, rest = selections.sliced(1), handler](const Result<QList<NamedValue>> &head) {
            if (!head)
                return handler(head);
            readAll(desk, rest, [head, handler](const Result<QList<NamedValue>> &tail) {
                handler(tail.map([&](const QList<NamedValue> &values) { return *head + values; }));
            });
        });
}

void write(Desk &desk, const variables::Reference &reference, const QString &typed,
    const std::function<void(const Result<NamedValue> &)> &handler)
{
    const auto value = variables::fromText(reference.kind, typed, formatOf(desk));
    if (!value)
        return handler(tl::unexpected(value.error()));
    robot::Edits &edits = desk.station().edits;
    QObject::connect(&edits, &robot::Edits::applied, &desk, [&desk, &edits, reference, value = *value, handler] {
        const variables::Edit *left = edits.staged().find(reference);
        if (!left)
            return handler(named(reference, value, desk));
        if (left->readBack)
            return handler(values::failure(ErrorKind::Malformed, toText(*left->readBack, formatOf(desk))));
        handler(tl::unexpected(left->error.value_or(values::Error {ErrorKind::UnknownOutcome})));
    });
    edits.stage(reference, *value);
    edits.apply();
}

void print(const Call &call, const QList<NamedValue> &values)
{
    QJsonObject json;
    for (const NamedValue &value : values) {
        if (call.isJson)
            json.insert(value.name, value.json);
        if (call.isJson && value.json.isNull())
            json.insert(value.name + QStringLiteral("_text"), value.text);
        if (!call.isJson)
            print(QStringLiteral("%1  %2").arg(value.name, value.text));
    }
    if (call.isJson)
        print(QJsonValue {json});
}

namespace {

/// Where nobody has compared a variable with the pendant, its neighbour may be shown.
void remarkOnNumbering(const Call &call, const QList<Selection> &selections)
{
    const bool isSettled = call.hasNumbering || call.profile.numberingVerified.isValid();
    const bool hasVariables = std::ranges::any_of(selections, [](const Selection &selection) {
        return selection.what == Selection::What::Variables && selection.range.kind != variables::Kind::M;
    });
    if (hasVariables && !isSettled && !call.isQuiet)
        complain(tr("Nobody has verified how this controller numbers its variables (parameter RS022), so these may be "
                    "their neighbours. --numbering 0 or --numbering 1 settles it."));
}

} // namespace

protocol::Dialect askedDialect(const Call &call)
{
    constexpr int most = 10'000;
    protocol::Dialect dialect = call.profile.dialect();
    dialect.variables = most;
    dialect.positionVariables = most;
    return dialect;
}

std::optional<QList<Selection>> selectionsFromText(const Call &call, const QStringList &words)
{
    QList<Selection> result;
    for (const QString &word : words) {
        const auto selection = selectionFromText(word, askedDialect(call));
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
    remarkOnNumbering(call, result);
    return result;
}

} // namespace pendeskctl
