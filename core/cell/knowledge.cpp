// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "cell/knowledge.h"

#include "cell/sentences.h"
#include <set>

using variables::Reference;

namespace cell {

namespace {

QString withName(const QString &number, const QString &name)
{
    return name.isEmpty() ? number : QStringLiteral("%1 “%2”").arg(number, name);
}

/// Counts the tools and user frames that the positions of a job name, each once a job.
void countUses(QByteArrayView job, Knowledge &knowledge)
{
    cellfiles::Warnings ignored;
    std::set<int> tools;
    std::set<int> frames;
    for (const cellfiles::Block &block : cellfiles::outlineOf(job, ignored, {"TOOL", "USER", "INST"}).blocks) {
        if (block.word == "INST")
            break;
        if (const auto number = cellfiles::wordFrom(cellfiles::fieldsOf(block.text)[0]))
            (block.word == "TOOL" ? tools : frames).insert(*number);
    }
    for (const int tool : tools)
        ++knowledge.toolJobs[tool];
    for (const int frame : frames)
        ++knowledge.frameJobs[frame];
}

class Joiner
{
public:
    Joiner(const FileReader &read, const protocol::TextCodec &codec) : m_read {read}, m_codec {codec} { }

    [[nodiscard]] Knowledge join(const QByteArrayList &names)
    {
        for (const char *file : {"IONAME.DAT", "EXIONAME.DAT"})
            m_knowledge.signalNames.insert(cellfiles::signalNamesFrom(bytes(file), m_codec).value.names);
        m_knowledge.variableNames = cellfiles::variableNamesFrom(bytes("VARNAME.DAT"), m_codec).value.byVariable();
        const auto registers = cellfiles::registerNamesFrom(bytes("IOMNAME.DAT"), m_codec).value.names;
        for (auto name = registers.begin(); name != registers.end(); ++name)
            m_knowledge.variableNames.insert({variables::Kind::M, name.key()}, name.value());
        readArms(names);
        for (const QByteArray &name : names) {
            if (name.endsWith(".JBI"))
                countUses(bytes(name), m_knowledge);
        }
        return m_knowledge;
    }

private:
    [[nodiscard]] QByteArray bytes(const QByteArray &name) const { return m_read(name).value_or(QByteArray {}); }

    /// From the single files where they are there: ALL.PRM repeats them, at thirty times the size.
    void readArms(const QByteArrayList &names)
    {
        const bool hasSingle = names.contains("RC.PRM");
        const QByteArray first = bytes(hasSingle ? "RC.PRM" : "ALL.PRM");
        cellfiles::Parameters parameters = cellfiles::parametersFrom(first).value;
        if (hasSingle)
            parameters.sections.insert(cellfiles::parametersFrom(bytes("SV.PRM")).value.sections);
        for (int robot = 0; robot < Knowledge::robots; ++robot)
            m_knowledge.arms[std::size_t(robot)] = cellfiles::armOf(parameters, robot + 1);
    }

    const FileReader &m_read;
    const protocol::TextCodec &m_codec;
    Knowledge m_knowledge;
};

} // namespace

QString Knowledge::text(const Reference &variable) const
{
    return withName(toString(variable), variableNames.value(variable));
}

QString Knowledge::signalText(int logicalNumber) const
{
    return withName(cellfiles::signalText(logicalNumber), signalNames.value(logicalNumber));
}

Knowledge knowledgeOf(const QByteArrayList &names, const FileReader &read, const protocol::TextCodec &codec)
{
    return Joiner {read, codec}.join(names);
}

} // namespace cell
