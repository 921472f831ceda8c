// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "cellfiles/systemfile.h"

#include "cellfiles/sentences.h"
#include <QRegularExpression>

namespace cellfiles {

namespace {

struct Prefix {
    QLatin1StringView text;
    protocol::Model model;
};
constexpr std::array prefixes {
    Prefix {QLatin1StringView {"DS"}, protocol::Model::DX100},
    Prefix {QLatin1StringView {"DN"}, protocol::Model::DX200},
    Prefix {QLatin1StringView {"FS"}, protocol::Model::FS100},
    Prefix {QLatin1StringView {"YAS"}, protocol::Model::YRC1000},
    Prefix {QLatin1StringView {"YBS"}, protocol::Model::YRC1000micro},
};

/// "0011_1111": the lowest bit, at the right end, is the first axis.
int axesFrom(QStringView mask) { return mask.toString().remove(u'_').toInt(nullptr, 2); }

/// What stands behind the colon of "//DATE      : 2024/03/05 15:00:12".
QString valueOf(const Block &block, const protocol::TextCodec &codec)
{
    const QString text = codec.decode(block.text);
    return text.mid(text.indexOf(u':') + 1).trimmed();
}

/// "R1 : MODEL   0011_1111,  B1 : MODEL  0000_0001" or, on a DX100, "MODEL  0111_1111   BS 0000_0001".
void readMechanisms(const QString &row, int robot, QList<Mechanism> &mechanisms)
{
    static const QRegularExpression unit {
        QStringLiteral("[,\\s]*(?:([RBS]\\d+)\\s*:\\s*)?([^\\s,].*?)\\s+([01]{4}_[01]{4})")};
    for (auto match = unit.globalMatch(row); match.hasNext();) {
        const auto found = match.next();
        QString group = found.captured(1);
        QString model = found.captured(2);
        if (group.isEmpty())
            group = (model == u"BS" ? u'B' : u'R') + QString::number(robot);
        mechanisms << Mechanism {group, model == u"BS" ? QString {} : model, axesFrom(found.captured(3))};
    }
}

/// "R1    : 2024/01/08 09:15,00118:04'59"
std::optional<HourCounter> hoursFrom(const QString &title, const QString &row)
{
    static const QRegularExpression counter {QStringLiteral("^(\\S+)\\s*:.*,\\s*(\\d{1,7}):(\\d\\d)'(\\d\\d)\\s*$")};
    const auto match = counter.match(row);
    if (!match.hasMatch())
        return std::nullopt;
    return HourCounter {title, match.captured(1),
        std::chrono::hours {match.captured(2).toInt()} + std::chrono::minutes {match.captured(3).toInt()}
            + std::chrono::seconds {match.captured(4).toInt()}};
}

class SystemReader
{
public:
    SystemReader(const protocol::TextCodec &codec, System &system, Warnings &warnings)
        : m_codec {codec}, m_system {system}, m_warnings {warnings}
    {
    }

    void take(const Block &block)
    {
        const QString title = titleOf(block);
        if (block.level == 1)
            m_system.format = wordFrom(block.text).value_or(0);
        else if (title == u"DATE")
            m_system.date = QDateTime::fromString(valueOf(block, m_codec), QStringLiteral("yyyy/MM/dd HH:mm:ss"));
        else if (title == u"SYSTEM NO")
            m_system.version = valueOf(block, m_codec);
        else if (title.startsWith(u"PARAM"))
            m_system.parameters = valueOf(block, m_codec);
        else if (title == u"APPLI")
            readApplications(valueOf(block, m_codec));
        readRows(block, title);
    }

private:
    /// "DATE", "SYSTEM NO": the header up to the colon.
    [[nodiscard]] QString titleOf(const Block &block) const
    {
        const QString all = m_codec.decode(block.word) + u' ' + m_codec.decode(block.text);
        return all.section(u':', 0, 0).trimmed();
    }

    void readApplications(const QString &text)
    {
        for (const QString &name : text.split(u','))
            m_system.applications << name.trimmed();
        m_system.applications.removeAll(QString {});
        m_system.applications.removeDuplicates();
    }

    void readRows(const Block &block, const QString &title)
    {
        int robot = 0;
        for (const Line &row : block.rows) {
            if (row.text.contains('\0'))
                continue;
            const QString text = m_codec.decode(row.text);
            if (title == u"REVISION")
                m_system.revisions << text.trimmed();
            else if (title == u"ROBOT NAME")
                readMechanisms(text, ++robot, m_system.mechanisms);
            else if (title.endsWith(u" POWER") || title.endsWith(u" TIME"))
                readHours(row, title, text);
        }
    }

    void readHours(const Line &row, const QString &title, const QString &text)
    {
        if (const auto counter = hoursFrom(title, text))
            m_system.hours << *counter;
        else if (!text.trimmed().isEmpty())
            m_warnings.add(row.number, Sentences::tr("The hours could not be read."));
    }

    const protocol::TextCodec &m_codec;
    System &m_system;
    Warnings &m_warnings;
};

/// A rule of '=' or '-' across the page.
bool isRule(const QString &row, QChar character)
{
    return row.size() >= 40 && std::ranges::all_of(row, [character](QChar c) { return c == character; });
}

/// "* 066 CUBIC ARM INTERFERENCE CHK FUNC.NOT USED": the state begins at column 38, a full name leaves no blank.
std::optional<PanelOption> optionFrom(const QString &row)
{
    constexpr int stateColumn = 38;
    static const QRegularExpression head {QStringLiteral("^\\* (\\d{3}) ")};
    const auto match = head.match(row);
    if (!match.hasMatch() || row.size() <= stateColumn)
        return std::nullopt;
    const auto length = match.capturedLength();
    return PanelOption {
        match.captured(1).toInt(), row.mid(length, stateColumn - length).trimmed(), row.mid(stateColumn).trimmed()};
}

void readPanelRows(const QStringList &rows, PanelBox &panel)
{
    bool isTitle = false;
    for (const QString &row : rows) {
        if (isRule(row, u'=')) {
            isTitle = true;
        } else if (isTitle && !isRule(row, u'-')) {
            panel.blocks << PanelBlock {row.trimmed(), {}};
            isTitle = false;
        } else if (isRule(row, u'-')) {
            if (std::exchange(isTitle, false))
                panel.blocks << PanelBlock {}; // a block without a title
        } else if (!panel.blocks.isEmpty() && !row.trimmed().isEmpty()) {
            panel.blocks.last().rows << row;
        }
    }
}

} // namespace

std::optional<protocol::Model> System::generation() const
{
    for (const auto &[text, model] : prefixes) {
        if (version.startsWith(text))
            return model;
    }
    return std::nullopt;
}

std::optional<std::chrono::seconds> System::hoursOf(QStringView title, QStringView group) const
{
    for (const HourCounter &counter : hours) {
        if (counter.title == title && counter.group == group)
            return counter.value;
    }
    return std::nullopt;
}

Parsed<System> systemFrom(QByteArrayView file, const protocol::TextCodec &codec)
{
    Parsed<System> result;
    SystemReader reader {codec, result.value, result.warnings};
    const Outline outline = outlineOf(file, result.warnings);
    for (const Block &block : outline.blocks)
        reader.take(block);
    if (result.value.version.isEmpty())
        result.warnings.add(0, Sentences::tr("The file does not say the version of the system software."));
    return result;
}

Parsed<PanelBox> panelBoxFrom(QByteArrayView file, const protocol::TextCodec &codec)
{
    Parsed<PanelBox> result;
    SystemReader reader {codec, result.value.system, result.warnings};
    const Outline outline = outlineOf(file, result.warnings);
    for (const Block &block : outline.blocks) {
        reader.take(block);
        if (block.word != "CONTROLLER")
            continue;
        QStringList rows;
        for (const Line &row : block.rows)
            rows << codec.decode(row.text);
        readPanelRows(rows, result.value);
    }
    for (const PanelBlock &block : result.value.blocks) {
        for (const QString &row : block.rows) {
            if (const auto option = optionFrom(row))
                result.value.options << *option;
        }
    }
    return result;
}

} // namespace cellfiles
