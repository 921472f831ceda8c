// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "cellfiles/ladder.h"
#include "cellfiles/logs.h"
#include "cellfiles/parameters.h"
#include "cellfiles/sentences.h"
#include "cellfiles/systemfile.h"
#include "cellfiles/views.h"
#include <bit>

namespace cellfiles {

namespace {

QString dateText(const QDateTime &date) { return date.toString(QStringLiteral("yyyy-MM-dd HH:mm:ss")); }

/// "412:33:07"
QString hoursText(std::chrono::seconds value)
{
    const auto count = value.count();
    return QStringLiteral("%1:%2:%3")
        .arg(count / 3600)
        .arg(count / 60 % 60, 2, 10, QLatin1Char {'0'})
        .arg(count % 60, 2, 10, QLatin1Char {'0'});
}

QList<Table> systemTables(const System &system)
{
    Table facts {QT_TRANSLATE_NOOP("cellfiles::Sentences", "system"),
        {{QT_TRANSLATE_NOOP("cellfiles::Sentences", "entry")}, {QT_TRANSLATE_NOOP("cellfiles::Sentences", "value")}}};
    const auto generation = system.generation();
    facts.add(0,
        {Sentences::tr("model"),
            generation ? QString::fromLatin1(protocol::dialect(*generation).name) : QStringLiteral("—")});
    facts.add(0, {Sentences::tr("software"), system.version});
    facts.add(0, {Sentences::tr("parameters"), system.parameters});
    facts.add(0, {Sentences::tr("date"), dateText(system.date)});
    facts.add(0, {Sentences::tr("application"), system.applications.join(QStringLiteral(", "))});
    for (const Mechanism &mechanism : system.mechanisms)
        facts.add(0,
            {mechanism.group,
                Sentences::tr("%1, %n axis/axes", nullptr, std::popcount(unsigned(mechanism.axes)))
                    .arg(mechanism.model)});
    Table boards {
        QT_TRANSLATE_NOOP("cellfiles::Sentences", "boards"), {{QT_TRANSLATE_NOOP("cellfiles::Sentences", "board")}}};
    for (const QString &revision : system.revisions)
        boards.add(0, {revision});
    Table hours {QT_TRANSLATE_NOOP("cellfiles::Sentences", "hours"),
        {{QT_TRANSLATE_NOOP("cellfiles::Sentences", "counter")}, {QT_TRANSLATE_NOOP("cellfiles::Sentences", "group")},
            {QT_TRANSLATE_NOOP("cellfiles::Sentences", "hours")}},
        {}, 2};
    for (const HourCounter &counter : system.hours)
        hours.add(0, {counter.title, counter.group, hoursText(counter.value)});
    return {facts, boards, hours};
}

} // namespace

View systemView(QByteArrayView file, const Codec &codec)
{
    const auto parsed = systemFrom(file, codec);
    return {systemTables(parsed.value), parsed.warnings};
}

View panelBoxView(QByteArrayView file, const Codec &codec)
{
    const auto parsed = panelBoxFrom(file, codec);
    View view {systemTables(parsed.value.system), parsed.warnings};
    Table options {QT_TRANSLATE_NOOP("cellfiles::Sentences", "options"),
        {{QT_TRANSLATE_NOOP("cellfiles::Sentences", "number"), true},
            {QT_TRANSLATE_NOOP("cellfiles::Sentences", "name")}, {QT_TRANSLATE_NOOP("cellfiles::Sentences", "state")}},
        {}, 2};
    for (const PanelOption &option : parsed.value.options)
        options.add(0, {QString::number(option.number), option.name, option.state});
    Table rest {QT_TRANSLATE_NOOP("cellfiles::Sentences", "settings"),
        {{QT_TRANSLATE_NOOP("cellfiles::Sentences", "block")}, {QT_TRANSLATE_NOOP("cellfiles::Sentences", "value")}}};
    for (const PanelBlock &block : parsed.value.blocks) {
        const bool isSecret = block.title.startsWith(QStringLiteral("INSPECTION"));
        for (const QString &row :
            block.title.startsWith(QStringLiteral("OPTION FUNCTION")) ? QStringList {} : block.rows)
            rest.add(0, {block.title, row.trimmed()}, isSecret);
    }
    view.tables << options << rest;
    return view;
}

View parameterView(QByteArrayView file, const Codec &)
{
    const auto parsed = parametersFrom(file);
    Table table {QT_TRANSLATE_NOOP("cellfiles::Sentences", "parameters"),
        {{QT_TRANSLATE_NOOP("cellfiles::Sentences", "parameter")},
            {QT_TRANSLATE_NOOP("cellfiles::Sentences", "value"), true},
            {QT_TRANSLATE_NOOP("cellfiles::Sentences", "meaning"), false, true}}};
    for (auto section = parsed.value.sections.begin(); section != parsed.value.sections.end(); ++section) {
        for (int number = 0; std::size_t(number) < section->values.size(); ++number) {
            const auto value = section->at(number);
            const ParameterMeaning *meaning = findMeaning(section.key(), number);
            if (value == 0 && !meaning)
                continue; // thousands of them
            table.add(section->line + 1 + number / ParameterSection::columns,
                {parameterName(section.key(), number), value ? QString::number(*value) : QStringLiteral("—"),
                    meaning ? meaningOf(section.key(), number) : QString {}},
                meaning && meaning->isSecret);
        }
    }
    return {{table}, parsed.warnings};
}

View ladderView(QByteArrayView file, const Codec &codec)
{
    const auto parsed = ladderFrom(file, codec);
    Table code {QT_TRANSLATE_NOOP("cellfiles::Sentences", "ladder"),
        {{QT_TRANSLATE_NOOP("cellfiles::Sentences", "number"), true},
            {QT_TRANSLATE_NOOP("cellfiles::Sentences", "part"), true},
            {QT_TRANSLATE_NOOP("cellfiles::Sentences", "instruction")}}};
    int number = 0;
    for (const LadderInstruction &instruction : parsed.value.instructions)
        code.add(instruction.line,
            {QString::number(++number), QString::number(instruction.part), codec.decode(instruction.text())});
    Table messages {QT_TRANSLATE_NOOP("cellfiles::Sentences", "texts"),
        {{QT_TRANSLATE_NOOP("cellfiles::Sentences", "table")},
            {QT_TRANSLATE_NOOP("cellfiles::Sentences", "number"), true},
            {QT_TRANSLATE_NOOP("cellfiles::Sentences", "text")}},
        {}, 2};
    for (auto table = parsed.value.texts.begin(); table != parsed.value.texts.end(); ++table) {
        const int first = table.key().startsWith("ALARM") ? Ladder::firstAlarm : 0;
        for (auto text = table->begin(); text != table->end(); ++text)
            messages.add(0, {QString::fromLatin1(table.key()), QString::number(first + text.key()), text.value()});
    }
    return {{code, messages}, parsed.warnings};
}

View logView(QByteArrayView file, const Codec &codec)
{
    const auto parsed = logFrom(file, codec);
    Table table {QT_TRANSLATE_NOOP("cellfiles::Sentences", "operation log"),
        {{QT_TRANSLATE_NOOP("cellfiles::Sentences", "date")}, {QT_TRANSLATE_NOOP("cellfiles::Sentences", "event")}}};
    for (const LogEntry &entry : parsed.value)
        table.add(entry.line, {dateText(entry.date), entry.text()});
    return {{table}, parsed.warnings};
}

View alarmView(QByteArrayView file, const Codec &codec)
{
    const auto parsed = alarmHistoryFrom(file, codec);
    Table table {QT_TRANSLATE_NOOP("cellfiles::Sentences", "alarm history"),
        {{QT_TRANSLATE_NOOP("cellfiles::Sentences", "class")}, {QT_TRANSLATE_NOOP("cellfiles::Sentences", "date")},
            {QT_TRANSLATE_NOOP("cellfiles::Sentences", "code"), true},
            {QT_TRANSLATE_NOOP("cellfiles::Sentences", "name")}, {QT_TRANSLATE_NOOP("cellfiles::Sentences", "group")},
            {QT_TRANSLATE_NOOP("cellfiles::Sentences", "detail")}, {QT_TRANSLATE_NOOP("cellfiles::Sentences", "mode")},
            {QT_TRANSLATE_NOOP("cellfiles::Sentences", "job")},
            {QT_TRANSLATE_NOOP("cellfiles::Sentences", "line"), true}}};
    for (const AlarmRecord &record : parsed.value)
        table.add(record.line,
            {QString::fromLatin1(record.section), record.date, QString::number(record.code), record.name, record.group,
                record.detail, record.mode, record.job, QString::number(record.jobLine)});
    return {{table}, parsed.warnings};
}

} // namespace cellfiles
