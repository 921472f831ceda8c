// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "cellfiles/views.h"
#include <QRegularExpression>
#include <span>

namespace cellfiles {

namespace {

/// The names of the fields of one row below a block's header, rows counted from 0 over all parts of the block.
struct RowNames {
    int row;
    std::array<const char *, 8> fields;
};

constexpr std::array weaving {
    RowNames {0, {"form", "smoothing", "speed kind"}},
    RowNames {1, {"flags"}},
    RowNames {2, {"vertical mm", "horizontal mm", "angle deg", "travel angle deg", "amplitude mm", "frequency Hz"}},
};
constexpr std::array arc {
    RowNames {2, {"flag", "speed"}},
    RowNames {4, {"current 1", "current 2", "current 3", "current 4"}},
};
constexpr std::array welder {
    RowNames {2, {"wire diameter mm", "gas", "stick-out mm", "time s", "time s 2"}},
};
constexpr std::array shape {
    RowNames {0, {"kind", "diameter mm"}},
};
constexpr std::array signalGroup {
    RowNames {0, {"kind", "bits", "first"}},
};
constexpr std::array speedLimit {
    RowNames {0, {"date", "time"}},
    RowNames {1, {"active"}},
    RowNames {2, {"speed mm/s"}},
};

using IsSecret = bool (*)(const Block &block, const Line &row);

/// A table of what stands where: "WEAV 2" | "amplitude mm" | "1.500". Rows whose fields have no names are one value.
class BlockTable
{
public:
    BlockTable(const Codec &codec, std::span<const RowNames> names, IsSecret isSecret)
        : m_codec {codec}, m_names {names}, m_isSecret {isSecret}
    {
    }

    [[nodiscard]] View view(QByteArrayView file)
    {
        View result;
        const Outline outline = outlineOf(file, result.warnings);
        for (const Block &block : outline.blocks)
            take(block);
        result.tables << std::move(m_table);
        return result;
    }

private:
    void take(const Block &block)
    {
        const QString header = m_codec.decode(block.word) + u' ' + m_codec.decode(block.text);
        if (block.level <= 2) {
            m_where = header.trimmed();
            m_row = 0;
        } else if (!block.text.isEmpty()) {
            add(block.line, m_codec.decode(block.word), m_codec.decode(block.text), m_isSecret(block, {}));
        }
        const QString part = block.level > 2 ? m_codec.decode(block.word) + u' ' : QString {};
        int inPart = 0;
        for (const Line &row : block.rows)
            takeRow(block, row, part + QString::number(++inPart));
    }

    void takeRow(const Block &block, const Line &row, const QString &label)
    {
        const auto names = std::ranges::find(m_names, m_row++, &RowNames::row);
        const bool isSecret = m_isSecret(block, row);
        if (names == m_names.end())
            return add(row.number, label, m_codec.decode(row.text), isSecret);
        const auto fields = fieldsOf(row.text);
        for (qsizetype field = 0; field < fields.size(); ++field) {
            const char *name = std::size_t(field) < names->fields.size() ? names->fields[std::size_t(field)] : nullptr;
            add(row.number, name ? title(name) : label + u'.' + QString::number(field + 1),
                m_codec.decode(fields[field]), isSecret);
        }
    }

    void add(int line, const QString &what, const QString &value, bool isSecret)
    {
        m_table.add(line, {m_where, what, value}, isSecret);
    }

    const Codec &m_codec;
    std::span<const RowNames> m_names;
    IsSecret m_isSecret;
    Table m_table {QT_TRANSLATE_NOOP("cellfiles::Sentences", "values"),
        {{QT_TRANSLATE_NOOP("cellfiles::Sentences", "block")}, {QT_TRANSLATE_NOOP("cellfiles::Sentences", "entry")},
            {QT_TRANSLATE_NOOP("cellfiles::Sentences", "value")}},
        {}, 2};
    QString m_where;
    int m_row = 0;
};

bool isOpen(const Block &, const Line &) { return false; }
bool isAllSecret(const Block &, const Line &) { return true; }

bool hasAddress(const Block &, const Line &row)
{
    static const QRegularExpression address {
        QStringLiteral("\\b\\d{1,3}(\\.\\d{1,3}){3}\\b|([0-9A-Fa-f]{2}:){5}[0-9A-Fa-f]{2}")};
    return address.match(QString::fromLatin1(row.text)).hasMatch();
}

/// HOST and the settings of time zones may be seen.
bool isNetworkSecret(const Block &block, const Line &row)
{
    constexpr std::array<QByteArrayView, 7> secret {"IP", "DGW", "SR", "DNSC", "SNTPC", "FTPC", "SERVER"};
    return std::ranges::find(secret, block.word) != secret.end() || hasAddress(block, row);
}

View named(QByteArrayView file, const Codec &codec, std::span<const RowNames> names)
{
    return BlockTable {codec, names, isOpen}.view(file);
}

} // namespace

View blockView(QByteArrayView file, const Codec &codec) { return named(file, codec, {}); }
View weavingView(QByteArrayView file, const Codec &codec) { return named(file, codec, weaving); }
View arcView(QByteArrayView file, const Codec &codec) { return named(file, codec, arc); }
View welderView(QByteArrayView file, const Codec &codec) { return named(file, codec, welder); }
View shapeView(QByteArrayView file, const Codec &codec) { return named(file, codec, shape); }
View signalGroupView(QByteArrayView file, const Codec &codec) { return named(file, codec, signalGroup); }
View speedLimitView(QByteArrayView file, const Codec &codec) { return named(file, codec, speedLimit); }
View addressView(QByteArrayView file, const Codec &codec) { return BlockTable {codec, {}, hasAddress}.view(file); }
View networkView(QByteArrayView file, const Codec &codec) { return BlockTable {codec, {}, isNetworkSecret}.view(file); }
View secretView(QByteArrayView file, const Codec &codec) { return BlockTable {codec, {}, isAllSecret}.view(file); }

View jobView(QByteArrayView file, const Codec &codec)
{
    View result;
    Table table {QT_TRANSLATE_NOOP("cellfiles::Sentences", "job"),
        {{QT_TRANSLATE_NOOP("cellfiles::Sentences", "line"), true},
            {QT_TRANSLATE_NOOP("cellfiles::Sentences", "text")}}};
    const Outline outline = outlineOf(file, result.warnings, {QByteArrayView {"\x01"}}); // no line is a header
    for (const Block &block : outline.blocks) {
        for (const Line &row : block.rows)
            table.add(row.number, {QString::number(row.number), codec.decode(row.text)});
    }
    result.tables << table;
    return result;
}

View shockView(QByteArrayView file, const Codec &codec)
{
    View result;
    Table table {QT_TRANSLATE_NOOP("cellfiles::Sentences", "collision detection"),
        {{QT_TRANSLATE_NOOP("cellfiles::Sentences", "set"), true},
            {QT_TRANSLATE_NOOP("cellfiles::Sentences", "group"), true},
            {QT_TRANSLATE_NOOP("cellfiles::Sentences", "on"), true},
            {QT_TRANSLATE_NOOP("cellfiles::Sentences", "level"), true}},
        {}, 2};
    const Outline outline = outlineOf(file, result.warnings);
    for (const Block &block : outline.blocks) {
        int group = 0;
        for (const Line &row : block.word == "SHOCKLVL" ? block.rows : std::vector<Line> {}) {
            const auto fields = fieldsOf(row.text);
            table.add(row.number,
                {codec.decode(block.text), QString::number(++group), codec.decode(fields[0]).trimmed(),
                    codec.decode(fields.value(1)).trimmed()});
        }
    }
    result.tables << table;
    return result;
}

View stopReasonView(QByteArrayView file, const Codec &codec)
{
    View result;
    Table table {QT_TRANSLATE_NOOP("cellfiles::Sentences", "reasons of stops"),
        {{QT_TRANSLATE_NOOP("cellfiles::Sentences", "number"), true},
            {QT_TRANSLATE_NOOP("cellfiles::Sentences", "date")},
            {QT_TRANSLATE_NOOP("cellfiles::Sentences", "reasons")}}};
    const Outline outline = outlineOf(file, result.warnings);
    for (const Block &block : outline.blocks) {
        if (block.word != "FCTRHIST" || block.rows.empty())
            continue;
        QStringList reasons;
        for (const Line &row : std::span {block.rows}.subspan(1)) {
            const QString reason = codec.decode(fieldsOf(row.text)[0]).trimmed();
            if (!reason.isEmpty() && reason != u"NONE")
                reasons << reason;
        }
        const QString date = codec.decode(fieldsOf(block.rows.front().text)[0]);
        table.add(block.line, {codec.decode(block.text), date, reasons.join(QStringLiteral(", "))});
    }
    result.tables << table;
    return result;
}

} // namespace cellfiles
