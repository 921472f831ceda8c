// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "cellfiles/parameters.h"

#include "cellfiles/sentences.h"
#include <QRegularExpression>

namespace cellfiles {

namespace {

/// The sections below a file; RS, CIO and FD have none.
bool isSection(QByteArrayView word, QByteArrayView file)
{
    static const QRegularExpression known {QStringLiteral(
        "^(RCD|RC\\d+G|S\\dD|RO\\d+G|S1C\\d+G|S\\dC|A\\dP|S\\dE|SVD|SV\\d+G|SVM\\d+G|AMC\\d+G|SVP\\d+G|MF\\d+G|"
        "SVS\\d+B|SVC\\d+B|RE\\d+G|FMS\\d+B)$")};
    const bool isFlat = file == "RS" || file == "CIO" || file == "FD";
    return !isFlat && known.match(QString::fromLatin1(word)).hasMatch();
}

bool isCheckLine(QByteArrayView row)
{
    return row.size() == 16 && std::ranges::all_of(row, [](char c) { return std::isxdigit(quint8(c)) != 0; });
}

class Reader
{
public:
    explicit Reader(Parsed<Parameters> &result) : m_result {result} { }

    void take(const Block &block)
    {
        if (block.level == 1)
            m_result.value.tag = block.text.toByteArray();
        else if (block.level == 2)
            beginFile(block);
        else if (block.level == 3)
            beginSection(block);
        for (const Line &row : block.rows)
            takeRow(row);
    }

private:
    void beginFile(const Block &block)
    {
        m_file = block.word.toByteArray();
        m_section = m_file;
        m_result.value.files << m_file;
        if (!block.text.isEmpty())
            m_result.value.tag = block.text.toByteArray();
    }

    void beginSection(const Block &block)
    {
        m_section = block.word.toByteArray();
        if (!isSection(block.word, m_file)) {
            m_section += block.text.isEmpty() ? QByteArray {} : ' ' + block.text.toByteArray();
            m_result.warnings.add(block.line,
                Sentences::tr("%1 has no section “%2”; the rows below it are not understood.")
                    .arg(QString::fromLatin1(m_file), QString::fromLatin1(m_section)));
        }
        m_result.value.sections[m_section].line = block.line;
    }

    void takeRow(const Line &row)
    {
        if (row.text.isEmpty())
            return;
        if (m_file == "FD" && isCheckLine(row.text)) {
            m_result.value.checkLine = row.text.toByteArray();
            return;
        }
        ParameterSection &section = m_result.value.sections[m_section];
        const std::size_t start = section.values.size();
        section.values.resize(start + ParameterSection::columns);
        takeValues(row, section.values, start);
    }

    void takeValues(const Line &row, std::vector<std::optional<qint32>> &values, std::size_t start)
    {
        const auto fields = fieldsOf(row.text);
        const qsizetype known = row.isWhole ? fields.size() : fields.size() - 1; // the last value of a cut line
        if (fields.size() != ParameterSection::columns && !m_section.startsWith("RO"))
            m_result.warnings.add(row.number,
                Sentences::tr("The row has %1 instead of 10 values; the missing ones of %2 are unknown.")
                    .arg(fields.size())
                    .arg(parameterName(m_section, int(start))));
        for (qsizetype column = 0; column < std::min<qsizetype>(known, ParameterSection::columns); ++column) {
            values[start + std::size_t(column)] = wordFrom(fields[column]);
            if (!values[start + std::size_t(column)])
                m_result.warnings.add(row.number,
                    Sentences::tr("%1 is no number of 32 bits.")
                        .arg(parameterName(m_section, int(start) + int(column))));
        }
    }

    Parsed<Parameters> &m_result;
    QByteArray m_file;
    QByteArray m_section;
};

constexpr std::array meanings {
    ParameterMeaning {
        "RS", 0, 0, QT_TRANSLATE_NOOP("cellfiles::Sentences", "data transmission; 2 is over the network")},
    ParameterMeaning {"RS", 22, 22,
        QT_TRANSLATE_NOOP("cellfiles::Sentences",
            "numbering of variables for network clients; 1: by their number, 0: by their number plus one")},
    ParameterMeaning {
        "RS", 29, 29, QT_TRANSLATE_NOOP("cellfiles::Sentences", "1 permits network clients to overwrite files")},
    ParameterMeaning {"RS", 30, 38,
        QT_TRANSLATE_NOOP("cellfiles::Sentences", "serial transmission: data bits, parity, stop, speed, timers")},
    ParameterMeaning {"RS", 50, 58,
        QT_TRANSLATE_NOOP("cellfiles::Sentences", "serial transmission: data bits, parity, stop, speed, timers")},
    ParameterMeaning {
        "RS", 59, 59, QT_TRANSLATE_NOOP("cellfiles::Sentences", "3 permits overwriting when loading from USB")},
    ParameterMeaning {
        "RS", 70, 77, QT_TRANSLATE_NOOP("cellfiles::Sentences", "address and mask of the controller"), true},
    ParameterMeaning {"RS", 89, 89, QT_TRANSLATE_NOOP("cellfiles::Sentences", "1 permits FTP")},
    ParameterMeaning {"RS", 214, 214,
        QT_TRANSLATE_NOOP(
            "cellfiles::Sentences", "1 permits network clients to overwrite files; the meaning of 2 is not known")},
    ParameterMeaning {"RS", 530, 549, QT_TRANSLATE_NOOP("cellfiles::Sentences", "addresses and masks"), true},
    ParameterMeaning {
        "S2C", 224, 224, QT_TRANSLATE_NOOP("cellfiles::Sentences", "0 permits selecting jobs in remote and play")},
    ParameterMeaning {"S2C", 230, 230,
        QT_TRANSLATE_NOOP("cellfiles::Sentences", "pendant operation in remote; 63 permits starts and edits")},
    ParameterMeaning {
        "S2C", 395, 396, QT_TRANSLATE_NOOP("cellfiles::Sentences", "alias function; 0 permits loading own names")},
    ParameterMeaning {"S2C", 541, 542, QT_TRANSLATE_NOOP("cellfiles::Sentences", "drivers that start motion need 0")},
    ParameterMeaning {"S2C", 1100, 1119, QT_TRANSLATE_NOOP("cellfiles::Sentences", "MotoPlus and telnet settings")},
    ParameterMeaning {"S2D", 10, 18, QT_TRANSLATE_NOOP("cellfiles::Sentences", "number of variables of each kind")},
    ParameterMeaning {"S3D", 0, 32, QT_TRANSLATE_NOOP("cellfiles::Sentences", "control groups and their axes")},
    ParameterMeaning {"CIO", 1450, 1459, QT_TRANSLATE_NOOP("cellfiles::Sentences", "pseudo input signals")},
};

} // namespace

Parsed<Parameters> parametersFrom(QByteArrayView file)
{
    Parsed<Parameters> result;
    Reader reader {result};
    const Outline outline = outlineOf(file, result.warnings);
    for (const Block &block : outline.blocks)
        reader.take(block);
    return result;
}

std::optional<qint32> Parameters::value(const QByteArray &section, int number) const
{
    const auto found = sections.find(section);
    return found == sections.end() ? std::nullopt : found->at(number);
}

const ParameterMeaning *findMeaning(const QByteArray &section, int number)
{
    const auto found = std::ranges::find_if(meanings, [&](const ParameterMeaning &meaning) {
        return section == meaning.section && number >= meaning.first && number <= meaning.last;
    });
    return found == meanings.end() ? nullptr : &*found;
}

QString meaningOf(const QByteArray &section, int number)
{
    const ParameterMeaning *meaning = findMeaning(section, number);
    return meaning ? Sentences::tr(meaning->text) : QString {};
}

QString parameterName(const QByteArray &section, int number)
{
    return QString::fromLatin1(section) + QStringLiteral("%1").arg(number, 3, 10, QLatin1Char {'0'});
}

} // namespace cellfiles
