// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "cellfiles/variablefile.h"

#include "cellfiles/sentences.h"
#include "cellfiles/signalnames.h"
#include <cmath>

using variables::Kind;
using variables::Reference;

namespace cellfiles {

namespace {

struct Limits {
    Kind kind;
    qint64 least;
    qint64 most;
};
constexpr std::array limits {
    Limits {Kind::B, 0, 255}, Limits {Kind::I, -32768, 32767}, Limits {Kind::D, -2147483648LL, 2147483647LL}};

constexpr QByteArrayView unused = "\"UNUSED\"";
constexpr QByteArrayView pulse = "\"PULSE\"";
constexpr QByteArrayView cartesian = "\"RECTAN\"";
constexpr qsizetype formSize = 24;
constexpr qsizetype headFields = 6; ///< f0, user, tool, form, f4, type

std::optional<quint32> formFrom(QByteArrayView text)
{
    quint32 form = 0;
    for (qsizetype bit = 0; bit < text.size(); ++bit) {
        if (text[bit] != '0' && text[bit] != '1')
            return std::nullopt;
        form |= quint32(text[bit] - '0') << bit;
    }
    return text.size() == formSize ? std::optional {form} : std::nullopt;
}

std::optional<PositionFrame> frameFrom(QByteArrayView text, bool isPulse)
{
    const auto type = wordFrom(text);
    if (!type || isPulse != (*type == 0) || (*type != 0 && (*type < 16 || *type > 20)))
        return std::nullopt;
    return PositionFrame(*type);
}

bool readAxes(const QList<QByteArrayView> &fields, FilePosition &position)
{
    for (qsizetype axis = 0; axis < qsizetype(position.axes.size()) && headFields + axis < fields.size(); ++axis) {
        const int decimals = position.isPulse() ? 0 : axis < 3 ? 3 : 4;
        const auto value = fixedFrom(fields[headFields + axis], decimals);
        if (!value)
            return false;
        position.axes[std::size_t(axis)] = *value;
    }
    return true;
}

std::optional<FilePosition> positionFrom(QByteArrayView line)
{
    const bool isPulse = line.startsWith(pulse);
    if (!isPulse && !line.startsWith(cartesian))
        return std::nullopt;
    const auto fields = fieldsOf(line.sliced(isPulse ? pulse.size() : cartesian.size()));
    if (fields.size() < headFields + qsizetype(std::tuple_size_v<decltype(FilePosition::axes)>))
        return std::nullopt;
    const auto user = wordFrom(fields[1]);
    const auto tool = wordFrom(fields[2]);
    const auto form = formFrom(fields[3]);
    const auto frame = frameFrom(fields[5], isPulse);
    if (!user || !tool || !form || !frame)
        return std::nullopt;
    FilePosition position {*frame, *user, *tool, *form, {}};
    return readAxes(fields, position) ? std::optional {position} : std::nullopt;
}

class VariableReader
{
public:
    explicit VariableReader(Parsed<VariableFile> &result) : m_result {result} { }

    void take(const Block &block)
    {
        if (block.word == "PFNUM")
            m_result.value.axisCounts = integersFrom(block.text).value_or(QList<qint64> {});
        else if (block.word == "SHARE")
            m_result.value.shares = sharesFrom(block.text, block.line, m_result.warnings);
        else if (const auto kind = sectionKind(block.word))
            takeSection(block, *kind);
    }

    void finish()
    {
        for (const Kind kind : sharedKinds)
            compareCount(kind);
    }

private:
    void takeSection(const Block &block, Kind kind)
    {
        m_lines[kind] = block.line;
        for (const Line &row : block.rows) {
            if (kind == Kind::S)
                m_result.value.strings << row.text.toByteArray();
            else if (variables::isPosition(kind))
                takePosition(row, kind);
            else
                takeNumbers(row, kind);
        }
    }

    void takeNumbers(const Line &row, Kind kind)
    {
        auto fields = fieldsOf(row.text);
        if (!row.isWhole)
            fields.removeLast(); // its digits may be cut
        for (const QByteArrayView field : fields) {
            if (kind == Kind::R)
                takeReal(row, field.trimmed());
            else
                takeInteger(row, kind, field);
        }
    }

    void takeReal(const Line &row, QByteArrayView field)
    {
        bool isNumber = false;
        const double value = field.toByteArray().toDouble(&isNumber);
        isNumber = isNumber && std::isfinite(value);
        m_result.value.reals << (isNumber ? field.toByteArray() : QByteArray {});
        if (!isNumber)
            unread(row, {Kind::R, int(m_result.value.reals.size()) - 1});
    }

    void takeInteger(const Line &row, Kind kind, QByteArrayView field)
    {
        const auto range = std::ranges::find(limits, kind, &Limits::kind);
        auto value = integerFrom(field);
        if (value && (*value < range->least || *value > range->most))
            value.reset();
        auto &values = m_result.value.integers[kind];
        values << value;
        if (!value)
            unread(row, {kind, int(values.size()) - 1});
    }

    void takePosition(const Line &row, Kind kind)
    {
        auto &list = m_result.value.positions[kind];
        const auto position = row.isWhole ? positionFrom(row.text) : std::nullopt;
        if (row.isWhole && row.text == unused)
            list << PositionSlot {Slot::Unused};
        else
            list << PositionSlot {position ? Slot::Used : Slot::Unread, position.value_or(FilePosition {})};
        if (list.last().slot == Slot::Unread)
            unread(row, {kind, int(list.size()) - 1});
    }

    void unread(const Line &row, const Reference &variable)
    {
        m_result.warnings.add(row.number, Sentences::tr("The value of %1 could not be read.").arg(toString(variable)));
    }

    [[nodiscard]] int countOf(Kind kind) const
    {
        const VariableFile &file = m_result.value;
        const qsizetype count = kind == Kind::R ? file.reals.size()
            : kind == Kind::S                   ? file.strings.size()
            : variables::isPosition(kind)       ? file.positions.value(kind).size()
                                                : file.integers.value(kind).size();
        return int(count);
    }

    void compareCount(Kind kind)
    {
        const int announced = m_result.value.shares.value(kind, -1);
        if (announced >= 0 && countOf(kind) != announced)
            m_result.warnings.add(m_lines.value(kind),
                Sentences::tr("The file announces %1 variables %2 and has %3; the others are not known.")
                    .arg(announced)
                    .arg(letters(kind))
                    .arg(countOf(kind)));
    }

    Parsed<VariableFile> &m_result;
    QHash<Kind, int> m_lines;
};

} // namespace

QString toString(PositionFrame frame)
{
    switch (frame) {
    case PositionFrame::Pulse: return Sentences::tr("pulse");
    case PositionFrame::Base: return Sentences::tr("base coordinates");
    case PositionFrame::Robot: return Sentences::tr("robot coordinates");
    case PositionFrame::Tool: return Sentences::tr("tool coordinates");
    case PositionFrame::User: return Sentences::tr("user coordinates");
    case PositionFrame::MasterTool: return Sentences::tr("master tool coordinates");
    }
    return {};
}

Parsed<VariableFile> variablesFrom(QByteArrayView file)
{
    Parsed<VariableFile> result;
    const Outline outline =
        outlineOf(file, result.warnings, {"VAR", "PFNUM", "SHARE", "B", "I", "D", "R", "S", "P", "BP", "EX"});
    VariableReader reader {result};
    for (const Block &block : outline.blocks)
        reader.take(block);
    reader.finish();
    return result;
}

} // namespace cellfiles
