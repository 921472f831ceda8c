// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "cellfiles/signalnames.h"

#include "cellfiles/sentences.h"

using variables::Kind;
using variables::Reference;

namespace cellfiles {

namespace {

struct Area {
    QByteArrayView word;
    int start;
};
constexpr std::array areas {Area {"IN", 0}, Area {"OUT", 10'000}, Area {"EXIN", 20'000}, Area {"EXOUT", 30'000}};
constexpr int mostSignals = 8192; ///< An area has at most 1,000 groups of eight.
constexpr int mostNumber = 99'999;

const Area *areaOf(const Block &block)
{
    const auto found = std::ranges::find(areas, block.word, &Area::word);
    return block.level == 2 && found != areas.end() ? &*found : nullptr;
}

QString decoded(QByteArrayView bytes, int line, const protocol::TextCodec &codec, Warnings &warnings)
{
    QString name = codec.decode(bytes.trimmed());
    if (name.contains(u'⟨'))
        warnings.add(line, Sentences::tr("The name “%1” holds bytes that the text encoding does not know.").arg(name));
    return name;
}

/// One row after the other, however many names each has.
void readArea(const Block &block, int start, const protocol::TextCodec &codec, Parsed<SignalNames> &result)
{
    int index = 0;
    for (const Line &row : block.rows) {
        const auto names = fieldsOf(row.text);
        if (names.size() > 4)
            result.warnings.add(row.number, Sentences::tr("The row has more than four names."));
        for (int column = 0; column < 4; ++column) {
            if (++index > mostSignals || column >= names.size() || names[column].trimmed().isEmpty())
                continue;
            const int number = logicalNumber(start, index);
            result.value.names[number] = decoded(names[column], row.number, codec, result.warnings);
            result.value.lines[number] = row.number;
        }
    }
    if (index > mostSignals)
        result.warnings.add(block.line, Sentences::tr("There are more names than signals."));
}

void readList(const Block &block, const protocol::TextCodec &codec, Warnings &warnings, QMap<int, QString> &names)
{
    int number = 0;
    for (const Line &row : block.rows) {
        for (const QByteArrayView name : fieldsOf(row.text.endsWith(',') ? row.text.chopped(1) : row.text)) {
            if (!name.trimmed().isEmpty())
                names[number] = decoded(name, row.number, codec, warnings);
            ++number;
        }
    }
}

/// "0007 1,0,MODE"
std::optional<VariableName> variableName(
    const Line &row, Kind kind, const protocol::TextCodec &codec, Warnings &warnings)
{
    const auto blank = row.text.indexOf(' ');
    const auto number = blank < 0 ? std::nullopt : integerFrom(row.text.first(blank));
    const auto first = row.text.indexOf(',');
    const auto second = first < 0 ? -1 : row.text.indexOf(',', first + 1);
    if (!number || *number < 0 || *number > mostNumber || second < 0) {
        warnings.add(row.number, Sentences::tr("The row is not a number, two flags and a name."));
        return std::nullopt;
    }
    const QByteArrayView name = row.text.sliced(second + 1);
    if (name.trimmed().isEmpty())
        return std::nullopt;
    return VariableName {{kind, int(*number)}, decoded(name, row.number, codec, warnings), row.number};
}

void readNames(const Block &block, Kind kind, const protocol::TextCodec &codec, Parsed<VariableNames> &result)
{
    const int share = result.value.shares.value(kind, mostNumber);
    QHash<int, QString> seen;
    for (const Line &row : block.rows) {
        const auto name = row.text.trimmed().isEmpty() ? std::nullopt : variableName(row, kind, codec, result.warnings);
        if (!name)
            continue;
        if (name->variable.number >= share)
            result.warnings.add(row.number,
                Sentences::tr("%1 is beyond the %n variable(s) that the file announces.", nullptr, share)
                    .arg(toString(name->variable)));
        if (seen.contains(name->variable.number))
            result.warnings.add(row.number,
                Sentences::tr("%1 was named “%2” before; which name the pendant shows is not known.")
                    .arg(toString(name->variable), seen.value(name->variable.number)));
        seen.insert(name->variable.number, name->name);
        result.value.names << *name;
    }
}

} // namespace

Parsed<SignalNames> signalNamesFrom(QByteArrayView file, const protocol::TextCodec &codec)
{
    Parsed<SignalNames> result;
    const Outline outline = outlineOf(file, result.warnings, {"IONAME", "EXIONAME", "IN", "OUT", "EXIN", "EXOUT"});
    for (const Block &block : outline.blocks) {
        if (const Area *area = areaOf(block))
            readArea(block, area->start, codec, result);
        else if (!block.rows.empty())
            result.warnings.add(
                block.rows.front().number, Sentences::tr("The line stands in a section that names no signals."));
    }
    return result;
}

QString signalText(int logicalNumber)
{
    const int index = (logicalNumber % 10'000 / 10 - 1) * 8 + logicalNumber % 10 + 1;
    if (logicalNumber < 10'000)
        return QStringLiteral("IN#(%1)").arg(index);
    if (logicalNumber < 20'000)
        return QStringLiteral("OUT#(%1)").arg(index);
    return QStringLiteral("#%1").arg(logicalNumber, 5, 10, QLatin1Char {'0'});
}

Parsed<NameList> registerNamesFrom(QByteArrayView file, const protocol::TextCodec &codec)
{
    Parsed<NameList> result;
    const Outline outline = outlineOf(file, result.warnings, {"IOMNAME", "IOMMAME", "NAME"});
    for (const Block &block : outline.blocks) {
        if (block.word != "NAME")
            continue;
        for (const Line &row : block.rows) {
            if (!row.text.trimmed().isEmpty())
                result.value.names[result.value.rows] = decoded(row.text, row.number, codec, result.warnings);
            ++result.value.rows;
        }
    }
    return result;
}

Parsed<TimerNames> timerNamesFrom(QByteArrayView file, const protocol::TextCodec &codec)
{
    Parsed<TimerNames> result;
    const Outline outline = outlineOf(file, result.warnings, {"TMNAME", "TM", "TF"});
    for (const Block &block : outline.blocks) {
        if (block.word == "TM")
            readList(block, codec, result.warnings, result.value.timers);
        if (block.word == "TF")
            readList(block, codec, result.warnings, result.value.flags);
    }
    return result;
}

QHash<Reference, QString> VariableNames::byVariable() const
{
    QHash<Reference, QString> result;
    for (const VariableName &name : names) {
        QString &text = result[name.variable];
        text = text.isEmpty() ? name.name : text + QStringLiteral(" / ") + name.name;
    }
    return result;
}

Parsed<VariableNames> variableNamesFrom(QByteArrayView file, const protocol::TextCodec &codec)
{
    Parsed<VariableNames> result;
    const Outline outline =
        outlineOf(file, result.warnings, {"VARNAME", "SHARE", "B", "I", "D", "R", "S", "P", "BP", "EX"});
    for (const Block &block : outline.blocks) {
        const auto kind = sectionKind(block.word);
        if (block.word == "SHARE")
            result.value.shares = sharesFrom(block.text, block.line, result.warnings);
        else if (kind && block.level == 3)
            readNames(block, *kind, codec, result);
    }
    return result;
}

std::optional<Kind> sectionKind(QByteArrayView word)
{
    const auto kind = variables::findKind(QString::fromLatin1(word));
    return kind && *kind != Kind::M ? kind : std::nullopt;
}

QHash<Kind, int> sharesFrom(QByteArrayView text, int line, Warnings &warnings)
{
    QHash<Kind, int> shares;
    const auto counts = integersFrom(text);
    if (!counts || counts->size() != qsizetype(sharedKinds.size()))
        warnings.add(line, Sentences::tr("The line does not announce a number for each of the eight kinds."));
    for (std::size_t index = 0; counts && index < sharedKinds.size() && qsizetype(index) < counts->size(); ++index)
        shares[sharedKinds[index]] = int(std::clamp<qint64>((*counts)[qsizetype(index)], 0, mostNumber));
    return shares;
}

} // namespace cellfiles
