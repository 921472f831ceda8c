// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "cellfiles/logs.h"

#include "cellfiles/sentences.h"
#include <QRegularExpression>

namespace cellfiles {

namespace {

constexpr qsizetype keyWidth = 18;

QDateTime dateFrom(const QString &text)
{
    return QDateTime::fromString(text.trimmed(), QStringLiteral("yyyy/MM/dd HH:mm:ss"));
}

/// A row "KEY               :value"; a key alone begins a block; other rows belong to the block.
void addRow(const Line &row, const protocol::TextCodec &codec, QList<LogField> &fields)
{
    const QByteArrayView key = row.text.first(std::min(keyWidth, row.text.size()));
    const bool hasKey = !key.startsWith(' ');
    if (hasKey && row.text.size() > keyWidth && row.text[keyWidth] == ':')
        fields << LogField {codec.decode(key).trimmed(), codec.decode(row.text.sliced(keyWidth + 1)).trimmed()};
    else if (hasKey)
        fields << LogField {codec.decode(key).trimmed(), {}, {codec.decode(row.text.sliced(key.size())).trimmed()}};
    else if (!fields.isEmpty())
        fields.last().block << codec.decode(row.text).trimmed();
    if (!fields.isEmpty())
        fields.last().block.removeAll(QString {});
}

LogEntry entryFrom(const Block &block, const protocol::TextCodec &codec)
{
    QList<LogField> fields;
    LogEntry entry;
    entry.line = block.line;
    entry.isWhole = false;
    for (const Line &row : block.rows) {
        if (row.text.trimmed().isEmpty())
            entry.isWhole = row.isWhole; // an empty line ends an entry
        else
            addRow(row, codec, fields);
    }
    const auto takeFirst = [&fields] { return fields.isEmpty() ? QString {} : fields.takeFirst().value; };
    entry.date = dateFrom(takeFirst());
    entry.event = takeFirst();
    entry.login = takeFirst();
    entry.fields = fields;
    return entry;
}

bool isDate(QByteArrayView row)
{
    static const QRegularExpression date {QStringLiteral("^\\d{4}/\\d\\d/\\d\\d \\d\\d:\\d\\d(:\\d\\d)?\\s*$")};
    return row.size() >= 16 && date.match(QString::fromLatin1(row)).hasMatch();
}

/// "1377,NAME,ROBOT1,[SLURBT],[100000],PLAY,": code, name, group, axes or sub code, mask, mode.
bool readHead(const Line &row, const protocol::TextCodec &codec, AlarmRecord &record)
{
    const auto fields = fieldsOf(row.text);
    const auto code = wordFrom(fields[0]);
    if (!code || fields.size() < 3)
        return false;
    record.code = *code;
    record.name = codec.decode(fields[1]);
    record.group = codec.decode(fields[2]);
    record.detail = codec.decode(fields.value(3));
    record.mode = codec.decode(fields.value(5));
    return true;
}

void readJob(const Line &row, const protocol::TextCodec &codec, AlarmRecord &record)
{
    const auto fields = fieldsOf(row.text);
    record.job = codec.decode(fields[0]);
    record.jobLine = wordFrom(fields.value(1)).value_or(0);
    record.step = wordFrom(fields.value(2)).value_or(0);
    record.state = codec.decode(fields.value(3)).remove(u'*');
}

/// A record ends with its date. In front of the head stands a row for the task, which a DX100 does not have.
class AlarmReader
{
public:
    AlarmReader(const protocol::TextCodec &codec, Parsed<QList<AlarmRecord>> &result)
        : m_codec {codec}, m_result {result}
    {
    }

    void take(const Block &block)
    {
        std::vector<Line> rows;
        qsizetype before = m_result.value.size();
        for (std::size_t index = 2; index < block.rows.size(); ++index) { // behind count and place in the ring
            rows.push_back(block.rows[index]);
            if (isDate(block.rows[index].text))
                takeRecord(block, std::exchange(rows, {}));
        }
        checkEnd(block, rows, int(m_result.value.size() - before));
    }

private:
    void takeRecord(const Block &block, const std::vector<Line> &rows)
    {
        AlarmRecord record;
        record.section = block.word.toByteArray();
        std::size_t head = 0;
        while (head < rows.size() && !readHead(rows[head], m_codec, record)) {
            if (!rows[head].text.trimmed().isEmpty())
                record.task = m_codec.decode(rows[head].text).trimmed();
            ++head;
        }
        if (head + 2 >= rows.size()) {
            m_result.warnings.add(
                rows.back().number, Sentences::tr("The record in front of this date is not understood."));
            return;
        }
        record.line = rows[head].number;
        readJob(rows[head + 1], m_codec, record);
        record.date = m_codec.decode(rows.back().text).trimmed();
        m_result.value << record;
    }

    void checkEnd(const Block &block, const std::vector<Line> &rest, int records)
    {
        const auto count = block.rows.empty() ? std::optional<qint32> {0} : wordFrom(block.rows.front().text);
        const bool hasRest = std::ranges::any_of(rest, [](const Line &row) { return !row.text.trimmed().isEmpty(); });
        if (hasRest)
            m_result.warnings.add(rest.front().number, Sentences::tr("The record that begins here is not complete."));
        if (count.value_or(-1) != records && !(block.rows.size() == 1 && block.rows.front().text.trimmed().isEmpty()))
            m_result.warnings.add(block.line,
                Sentences::tr("The section %1 announces %2 records and holds %3.")
                    .arg(QString::fromLatin1(block.word), count ? QString::number(*count) : QStringLiteral("?"))
                    .arg(records));
    }

    const protocol::TextCodec &m_codec;
    Parsed<QList<AlarmRecord>> &m_result;
};

} // namespace

QString LogEntry::value(QStringView key) const
{
    const auto found = std::ranges::find(fields, key, &LogField::key);
    return found == fields.end() ? QString {} : found->value;
}

bool LogEntry::isNoise() const { return value(u"FILE NAME") == u"REGENERATION UNIT INFO"; }

QString LogEntry::text() const
{
    QStringList parts;
    for (const LogField &field : fields) {
        if (!field.value.isEmpty())
            parts << field.key + u' ' + field.value;
        parts += field.block;
    }
    return parts.isEmpty() ? event : event + QStringLiteral(": ") + parts.join(QStringLiteral(", "));
}

Parsed<QList<LogEntry>> logFrom(QByteArrayView file, const protocol::TextCodec &codec)
{
    Parsed<QList<LogEntry>> result;
    const Outline outline = outlineOf(file, result.warnings, {"LOGDATA", "INDEX"});
    int index = 0;
    for (const Block &block : outline.blocks) {
        if (block.word != "INDEX")
            continue;
        ++index;
        if (wordFrom(block.text) != std::optional {index})
            result.warnings.add(block.line,
                Sentences::tr("The entry is numbered %1 and is number %2 by its place.")
                    .arg(QString::fromLatin1(block.text))
                    .arg(index));
        result.value << entryFrom(block, codec);
        if (!result.value.last().isWhole)
            result.warnings.add(block.line, Sentences::tr("The entry is not complete."));
    }
    return result;
}

bool AlarmRecord::isSameAs(const AlarmRecord &other) const
{
    return section == other.section && code == other.code && detail == other.detail && date == other.date
        && group == other.group;
}

Parsed<QList<AlarmRecord>> alarmHistoryFrom(QByteArrayView file, const protocol::TextCodec &codec)
{
    Parsed<QList<AlarmRecord>> result;
    const Outline outline =
        outlineOf(file, result.warnings, {"ALMHIST", "MAJOR", "MINOR", "IO_SYS", "IO_USR", "OFFLINE"});
    AlarmReader reader {codec, result};
    for (const Block &block : outline.blocks) {
        if (block.level == 3)
            reader.take(block);
    }
    return result;
}

} // namespace cellfiles
