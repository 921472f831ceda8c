// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "variables/sheet.h"

#include "values/plaintext.h"
#include "variables/sentences.h"
#include <QHash>

using protocol::Dialect;
using values::ErrorKind;
using values::failure;
using values::Position;
using values::PositionType;
using values::Result;

namespace variables {

namespace {

// Words of the file, never translated.
const QString variableColumn = QStringLiteral("variable");
const QString nameColumn = QStringLiteral("name");
const QString valueColumn = QStringLiteral("value");
const QString typeColumn = QStringLiteral("type");

struct TypeWord {
    PositionType type;
    const char *word;
};
constexpr std::array typeWords {
    TypeWord {PositionType::Pulse, "pulse"},
    TypeWord {PositionType::Base, "base"},
    TypeWord {PositionType::Robot, "robot"},
    TypeWord {PositionType::User, "user"},
    TypeWord {PositionType::Tool, "tool"},
};

/// The whole numbers of a position, which only P has.
struct Part {
    const char *column;
    quint32 Position::*member;
    quint32 most;
};
constexpr std::array positionParts {
    Part {"tool", &Position::tool, 63},
    Part {"frame", &Position::userFrame, 63},
    Part {"form", &Position::form, 0xFF},
    Part {"extended form", &Position::extendedForm, 0x1F},
};

QString axisColumn(int axis) { return QStringLiteral("axis %1").arg(axis + 1); }

/// One line with the names of its columns.
class Row
{
public:
    Row(const QHash<QString, qsizetype> &columns, const Line &line) : m_columns {columns}, m_line {line} { }

    [[nodiscard]] QString operator[](const QString &column) const
    {
        const auto found = m_columns.find(column);
        return found == m_columns.end() ? QString() : m_line.cells.value(*found);
    }

private:
    const QHash<QString, qsizetype> &m_columns;
    const Line &m_line;
};

Result<void> takeType(Position &position, Kind kind, const QString &cell)
{
    const QString word = values::plainText(cell).toLower();
    const auto found =
        std::ranges::find_if(typeWords, [&](const TypeWord &row) { return word == QLatin1StringView(row.word); });
    if (found == typeWords.end() || !positionTypes(kind).contains(found->type))
        return values::badInput(Sentences::tr("“%1” is not a type that %2 has.").arg(cell, letters(kind)));
    if (position.type != found->type)
        position.axes = {}; // words of another unit mean nothing now
    position.axes.resize(values::maxAxes);
    position.type = found->type;
    return {};
}

Result<void> takeParts(Position &position, const Row &row)
{
    for (const auto &[column, member, most] : positionParts) {
        const QString cell = row[QString::fromLatin1(column)];
        if (cell.isEmpty())
            continue;
        const auto number = wholeNumber(cell, 0, most);
        if (!number)
            return values::badInput(
                Sentences::tr("%1: %2", "column: reason").arg(QLatin1StringView(column), number.error().detail));
        position.*member = quint32(*number);
    }
    return {};
}

Result<void> takeAxes(Position &position, const Row &row)
{
    for (int axis = 0; axis < values::maxAxes; ++axis) {
        const QString cell = row[axisColumn(axis)];
        if (cell.isEmpty())
            continue;
        const auto word = axisFromText(cell, axisUnit(position.type, axis));
        if (!word)
            return values::badInput(
                Sentences::tr("%1: %2", "column: reason").arg(axisColumn(axis), word.error().detail));
        position.axes[axis] = *word;
    }
    return {};
}

/// Where nothing stands yet, the axes must be given.
Result<void> checkAxesGiven(Kind kind, const Row &row)
{
    for (int axis = 0; axis < usualAxes(kind); ++axis) {
        if (row[axisColumn(axis)].isEmpty())
            return values::badInput(
                Sentences::tr("%1 is missing, and no value of this type was read.").arg(axisColumn(axis)));
    }
    return {};
}

Result<Value> positionFrom(Kind kind, const Row &row, const std::optional<Value> &now)
{
    Position position = now ? *positionOf(*now) : Position {};
    position.axes.resize(values::maxAxes);
    const PositionType before = position.type;
    const QString type = row[typeColumn];
    if (type.isEmpty() && !now)
        return values::badInput(Sentences::tr("The type is missing, and none was read."));
    Result<void> taken {};
    if (!type.isEmpty())
        taken = takeType(position, kind, type);
    if (taken && (!now || position.type != before))
        taken = checkAxesGiven(kind, row);
    if (taken)
        taken = takeParts(position, row);
    if (taken)
        taken = takeAxes(position, row);
    return taken.map([&] { return valueWith(kind, position); });
}

/// Collects what the lines say, and what is wrong with them.
class Reader
{
public:
    Reader(const Format &format, const Dialect &dialect, const Lookup &now)
        : m_format {format}, m_dialect {dialect}, m_now {now}
    {
    }

    void complain(int line, const QString &reason) { m_preview.problems += Problem {line, reason}; }

    void take(int line, const QString &name, const Row &row)
    {
        if (name.trimmed().isEmpty())
            return complain(line, Sentences::tr("The variable is missing."));
        const auto variable = referenceFromText(name, m_dialect);
        if (!variable)
            return complain(line, variable.error().detail);
        if (variable->number >= writableCountOf(variable->kind, m_dialect))
            return complain(line, Sentences::tr("%1 can only be read.").arg(toString(*variable)));
        if (const int before = m_lines.value(*variable); before > 0)
            return complain(line, Sentences::tr("%1 stands in line %2 already.").arg(toString(*variable)).arg(before));
        m_lines.insert(*variable, line);
        const auto now = m_now(*variable);
        add(line, *variable, now,
            isPosition(variable->kind) ? positionFrom(variable->kind, row, now)
                                       : simple(variable->kind, row[valueColumn]));
    }

    [[nodiscard]] Preview result() && { return std::move(m_preview); }

private:
    [[nodiscard]] Result<Value> simple(Kind kind, const QString &cell) const
    {
        if (cell.trimmed().isEmpty() && kind != Kind::S)
            return values::badInput(Sentences::tr("The value is missing."));
        return fromText(kind, cell, m_format);
    }

    void add(int line, const Reference &variable, const std::optional<Value> &now, const Result<Value> &value)
    {
        if (!value)
            complain(line, Sentences::tr("%1: %2", "variable: reason").arg(toString(variable), value.error().detail));
        else if (now && isSame(*now, *value))
            ++m_preview.unchanged;
        else
            m_preview.differences += Difference {line, variable, now, *value};
    }

    const Format &m_format;
    const Dialect &m_dialect;
    const Lookup &m_now;
    QHash<Reference, int> m_lines; ///< Where each variable stood.
    Preview m_preview;
};

/// The columns of a header, by their plain names. A column that stands there twice keeps its first place, and is a
/// complaint.
QHash<QString, qsizetype> columnsOf(const Line &header, Reader *reader = nullptr)
{
    QHash<QString, qsizetype> columns;
    for (qsizetype i = 0; i < header.cells.size(); ++i) {
        const QString name = values::plainText(header.cells[i]).toLower();
        if (!name.isEmpty() && columns.contains(name) && reader)
            reader->complain(header.line, Sentences::tr("The column “%1” stands there twice.").arg(name));
        else
            columns.insert(name, i);
    }
    return columns;
}

bool hasHeader(const Table &table)
{
    return !table.lines.isEmpty() && columnsOf(table.lines.first()).contains(variableColumn);
}

void readLines(Reader &reader, const Table &table)
{
    if (!hasHeader(table)) {
        reader.complain(table.lines.isEmpty() ? 0 : table.lines.first().line,
            Sentences::tr("The header is missing: the first line must name the columns “variable” and “value”."));
        return;
    }
    const auto columns = columnsOf(table.lines.first(), &reader);
    if (!columns.contains(valueColumn) && !columns.contains(axisColumn(0)))
        return reader.complain(
            table.lines.first().line, Sentences::tr("There is neither a column “value” nor “axis 1”."));
    for (const Line &line : table.lines.sliced(1)) {
        const Row row {columns, line};
        if (line.cells.size() > table.lines.first().cells.size())
            reader.complain(line.line, Sentences::tr("The line has more cells than the header."));
        else
            reader.take(line.line, row[variableColumn], row);
    }
}

void readBlock(Reader &reader, const Table &table, const Reference &first)
{
    const QHash<QString, qsizetype> one {{valueColumn, 0}};
    const QHash<QString, qsizetype> two {{variableColumn, 0}, {valueColumn, 1}};
    Reference next = first;
    for (const Line &line : table.lines) {
        if (line.cells.size() > 2)
            reader.complain(line.line, Sentences::tr("A block without a header has one or two columns."));
        else if (line.cells.size() == 2)
            reader.take(line.line, line.cells.first(), Row {two, line});
        else
            reader.take(line.line, toString(next), Row {one, line});
        ++next.number;
    }
}

QStringList positionCells(const ExportRow &row)
{
    const auto position = row.value ? positionOf(*row.value) : std::nullopt;
    if (!position)
        return QStringList(1 + qsizetype(positionParts.size()) + values::maxAxes);
    const auto type = std::ranges::find(typeWords, position->type, &TypeWord::type);
    QStringList cells {type == typeWords.end() ? QString() : QString::fromLatin1(type->word)};
    for (const Part &part : positionParts)
        cells << (row.variable.kind == Kind::P ? QString::number((*position).*part.member) : QString());
    for (int axis = 0; axis < values::maxAxes; ++axis)
        cells << axisText(position->axes[axis], axisUnit(position->type, axis), QLocale::c());
    return cells;
}

QStringList positionHeader()
{
    QStringList cells {typeColumn};
    for (const Part &part : positionParts)
        cells << QString::fromLatin1(part.column);
    for (int axis = 0; axis < values::maxAxes; ++axis)
        cells << axisColumn(axis);
    return cells;
}

} // namespace

Preview preview(const Table &table, const Format &format, const Dialect &dialect, const Lookup &now)
{
    Reader reader {format, dialect, now};
    readLines(reader, table);
    return std::move(reader).result();
}

Preview previewBlock(
    QStringView text, const Reference &first, const Format &format, const Dialect &dialect, const Lookup &now)
{
    Reader reader {format, dialect, now};
    const auto table = readTable(text);
    if (!table)
        reader.complain(0, table.error().detail);
    else if (hasHeader(*table))
        readLines(reader, *table);
    else
        readBlock(reader, *table, first);
    return std::move(reader).result();
}

QString toCsv(const QList<ExportRow> &rows, const Format &format)
{
    Format plain = format;
    plain.locale = QLocale::c();
    const bool hasPositions =
        std::ranges::any_of(rows, [](const ExportRow &row) { return isPosition(row.variable.kind); });
    QStringList header {variableColumn, nameColumn, valueColumn};
    QString text = csvLine(hasPositions ? header + positionHeader() : header);
    for (const ExportRow &row : rows) {
        const bool isText = row.value && !isPosition(row.variable.kind);
        const QStringList cells {toString(row.variable), row.name, isText ? toText(*row.value, plain) : QString()};
        text += csvLine(hasPositions ? cells + positionCells(row) : cells);
    }
    return text;
}

} // namespace variables
