// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "names/namefile.h"

#include "names/sentences.h"
#include <variant>

using protocol::IoArea;

namespace names {

namespace {

struct SignalSection {
    const char *name;
    IoArea area;
};
constexpr std::array signalSections {
    SignalSection {"IN", IoArea::UserInput},
    SignalSection {"OUT", IoArea::UserOutput},
};

/// What the lines of a section are numbers of.
using Section = std::variant<std::monostate, IoArea, variables::Kind>;

/// Takes lines off a file. CR LF, LF and CR end one.
class Lines
{
public:
    explicit Lines(QByteArrayView file) : m_rest {file} { }

    [[nodiscard]] bool isAtEnd() const { return m_rest.isEmpty(); }
    [[nodiscard]] QByteArrayView next()
    {
        const auto end = std::ranges::find_if(m_rest, [](char byte) { return byte == '\n' || byte == '\r'; });
        const QByteArrayView line = m_rest.first(end - m_rest.begin());
        m_rest = m_rest.sliced(line.size());
        m_rest = m_rest.sliced(m_rest.startsWith("\r\n") ? 2 : m_rest.isEmpty() ? 0 : 1);
        return line;
    }

private:
    QByteArrayView m_rest;
};

class Reader
{
public:
    Reader(const protocol::TextCodec &codec, const protocol::Dialect &dialect)
        : m_codec {codec}, m_dialect {dialect} { }

    void take(QByteArrayView line)
    {
        ++m_line;
        if (line.trimmed().isEmpty())
            return;
        if (line.startsWith("///"))
            beginSection(line.sliced(3).trimmed());
        else if (line.startsWith("//"))
            m_section = {};
        else
            takeName(line);
    }

    [[nodiscard]] NameFile result() && { return std::move(m_file); }

private:
    void remark(const QString &reason)
    {
        if (++m_file.remarkCount <= NameFile::maxRemarks)
            m_file.remarks += Remark {m_line, reason};
    }

    /// The word before the first blank names the section; others than these hold no names.
    void beginSection(QByteArrayView header)
    {
        const auto end = std::ranges::find(header, ' ');
        const QString word = QString::fromLatin1(header.first(end - header.begin()));
        m_section = {};
        for (const auto &[name, area] : signalSections) {
            if (word == QLatin1StringView(name))
                m_section = area;
        }
        if (const auto kind = variables::findKind(word))
            m_section = *kind;
    }

    void takeName(QByteArrayView line)
    {
        const qsizetype comma = line.indexOf(',');
        bool isNumber = false;
        const uint number = line.first(std::max<qsizetype>(comma, 0)).trimmed().toUInt(&isNumber, 10);
        if (!isNumber)
            return remark(Sentences::tr("The line is not a number, a comma and a name."));
        if (std::holds_alternative<std::monostate>(m_section))
            return remark(Sentences::tr("The line stands in a section that names neither signals nor variables."));
        const QByteArrayView bytes = line.sliced(comma + 1).trimmed();
        if (bytes.isEmpty())
            return; // no name was given
        const QString name = m_codec.decode(bytes);
        if (!store(number, name))
            return remark(Sentences::tr("This controller has no number %1 there.").arg(number));
        if (name.contains(u'⟨'))
            remark(Sentences::tr("The name “%1” holds bytes that the text encoding does not know.").arg(name));
    }

    bool store(uint number, const QString &name)
    {
        if (const auto *kind = std::get_if<variables::Kind>(&m_section)) {
            const bool exists = number < uint(variables::countOf(*kind, m_dialect));
            if (exists)
                insert(m_file.variableNames, {*kind, int(number)}, name);
            return exists;
        }
        const auto signal = signalOf(std::get<IoArea>(m_section), int(std::min(number, 100'000U)), m_dialect);
        if (signal)
            insert(m_file.signalNames, *signal, name);
        return signal.has_value();
    }

    template <typename Key> void insert(QHash<Key, QString> &names, const Key &key, const QString &name)
    {
        if (const auto before = names.constFind(key); before != names.cend())
            remark(Sentences::tr("The number was named “%1” before; the last name counts.").arg(*before));
        names.insert(key, name);
    }

    const protocol::TextCodec &m_codec;
    const protocol::Dialect &m_dialect;
    Section m_section;
    int m_line = 0;
    NameFile m_file;
};

} // namespace

NameFile readNames(QByteArrayView file, const protocol::TextCodec &codec, const protocol::Dialect &dialect)
{
    Reader reader {codec, dialect};
    for (Lines lines {file}; !lines.isAtEnd();)
        reader.take(lines.next());
    return std::move(reader).result();
}

} // namespace names
