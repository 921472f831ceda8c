// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "cell/cell.h"

#include <algorithm>
#include <array>

namespace cell {

namespace {

using Kind = Subject::Kind;

/// Puts what a parser gives where it belongs, and keeps its warnings.
class Reader
{
public:
    explicit Reader(const protocol::TextCodec &codec) { cell.codec = codec; }

    void take(const File &file)
    {
        const QByteArray name = file.name.toUpper();
        cell.files << file.name;
        const auto read = std::ranges::find(readers, QByteArrayView {name}, &NamedReader::file);
        if (read != readers.end())
            read->read(*this, file);
        else if (name.endsWith(".JBI"))
            takeJob(file);
    }

    Cell cell;

private:
    using Read = void (*)(Reader &, const File &);
    struct NamedReader {
        QByteArrayView file;
        Read read;
    };
    static const std::array<NamedReader, 8> readers;

    template <typename Value> Value keep(const File &file, cellfiles::Parsed<Value> parsed)
    {
        if (!parsed.warnings.isEmpty())
            cell.troubles << Trouble {file.name, parsed.warnings.list()};
        return std::move(parsed.value);
    }

    void takeSignals(const File &file)
    {
        const auto names = keep(file, cellfiles::signalNamesFrom(file.content, cell.codec));
        cell.signalNames.names.insert(names.names);
        cell.signalNames.lines.insert(names.lines);
    }

    void takeJob(const File &file)
    {
        inform::Job job = inform::parse(file.content);
        const QByteArray name = job.name.isEmpty() ? file.name.chopped(4) : job.name;
        if (!cell.jobs.try_emplace(name, Cell::JobFile {file.name, std::move(job), file.at}).second)
            cell.doubles << file.name;
    }
};

const std::array<Reader::NamedReader, 8> Reader::readers {{
    {"IONAME.DAT", [](Reader &r, const File &f) { r.takeSignals(f); }},
    {"EXIONAME.DAT", [](Reader &r, const File &f) { r.takeSignals(f); }},
    {"IOMNAME.DAT",
        [](Reader &r, const File &f) {
            r.cell.registerNames = r.keep(f, cellfiles::registerNamesFrom(f.content, r.cell.codec));
        }},
    {"VARNAME.DAT",
        [](Reader &r, const File &f) {
            r.cell.variableNames = r.keep(f, cellfiles::variableNamesFrom(f.content, r.cell.codec));
        }},
    {"CIOPRG.LST",
        [](Reader &r, const File &f) { r.cell.ladder = r.keep(f, cellfiles::ladderFrom(f.content, r.cell.codec)); }},
    {"MACRO.DAT", [](Reader &r, const File &f) { r.cell.macros = r.keep(f, cellfiles::macrosFrom(f.content)); }},
    {"TOOL.CND",
        [](Reader &r, const File &f) { r.cell.tools = r.keep(f, cellfiles::toolsFrom(f.content, r.cell.codec)); }},
    {"UFRAME.CND",
        [](Reader &r, const File &f) {
            r.cell.userFrames = r.keep(f, cellfiles::userFramesFrom(f.content, r.cell.codec));
        }},
}};

template <typename List> QString nameIn(const List &list, int number)
{
    const auto found = std::ranges::find_if(list, [number](const auto &each) { return each.number == number; });
    return found == list.end() ? QString {} : found->name;
}

/// The texts of the ladder's alarms are in the display's language (ALARM1) and a second one.
QString alarmText(const cellfiles::Ladder &ladder, int number)
{
    return ladder.texts.value("ALARM1").value(number - cellfiles::Ladder::firstAlarm);
}

QString variableText(const cellfiles::VariableNames &names, const Subject &subject)
{
    QStringList found;
    for (const cellfiles::VariableName &each : names.names) {
        if (int(each.variable.kind) == int(subject.kind) && each.variable.number == subject.number)
            found << each.name;
    }
    return found.join(QStringLiteral(" / "));
}

} // namespace

bool Cell::has(QByteArrayView file) const
{
    return std::ranges::any_of(
        files, [file](const QByteArray &name) { return name.compare(file, Qt::CaseInsensitive) == 0; });
}

QString Cell::nameOf(const Subject &subject) const
{
    if (isVariable(subject.kind))
        return variableText(variableNames, subject);
    switch (subject.kind) {
    case Kind::Signal: return signalNames.names.value(subject.number);
    case Kind::Register: return registerNames.names.value(subject.number);
    case Kind::Tool: return nameIn(tools, subject.number);
    case Kind::UserFrame: return nameIn(userFrames, subject.number);
    case Kind::Alarm: return alarmText(ladder, subject.number);
    case Kind::Job: {
        const auto found = jobs.find(subject.name);
        return found == jobs.end() ? QString {} : codec.decode(found->second.job.comment);
    }
    default: return {};
    }
}

Cell cellOf(const QList<File> &files, const protocol::TextCodec &codec)
{
    Reader reader {codec};
    for (const File &file : files)
        reader.take(file);
    return std::move(reader.cell);
}

} // namespace cell
