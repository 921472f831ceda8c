// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "protocol/layout.h"
#include "protocol/text.h"
#include "values/alarm.h"
#include <QJsonArray>
#include <QJsonValue>
#include <QList>

namespace protocol {

/// A named value of a packet, for the field tree and for `pendeskctl decode`.
struct Field {
    QString name;
    QJsonValue value;
    QString words; ///< For people: hex for codes and bits, words for meanings; empty where the value says it all.

    bool operator==(const Field &) const = default;
};
using Fields = QList<Field>;

/// "0x00C2": `digits` at least.
[[nodiscard]] QString hexWord(quint64 number, int digits);

/// How one field is shown; the text encoding matters to text alone.
[[nodiscard]] Field showNumber(const char *name, qint64 value);
[[nodiscard]] Field showReal(const char *name, float value);
[[nodiscard]] Field showWords(const char *name, const QStringList &words);
[[nodiscard]] Field showAxes(const char *name, const values::AxisWords &words);

/// The name of a single axis: "x" to "re" in a frame, "axis_1" to "axis_8" in pulses.
[[nodiscard]] QString axisName(values::PositionType type, int axis);

/// Visits a layout, reads a payload and lists its fields.
class FieldReader
{
public:
    /// `payload` must outlive the reader.
    FieldReader(QByteArrayView payload, int onlyElement, TextCodec codec)
        : m_reader {payload, onlyElement}, m_codec {codec}, m_onlyElement {onlyElement}
    {
    }
    FieldReader(QByteArray &&payload, int onlyElement, TextCodec codec) = delete;

    [[nodiscard]] const Fields &fields() const { return m_fields; }
    [[nodiscard]] bool isComplete() const { return m_reader.isComplete(); }

    template <typename Value> void element(const char *name, Value &value)
    {
        if (m_reader.element(name, value))
            m_fields += show(name, value);
    }

    template <typename Value> void paddedElement(const char *name, Value &value)
    {
        if (m_reader.paddedElement(name, value))
            m_fields += show(name, value);
    }

    /// One list; what is empty at its end is left out.
    void each(const char *name, auto &values)
    {
        QStringList texts;
        for (auto &value : values) {
            if (m_reader.element(name, value))
                texts += m_codec.decode(value.bytes());
        }
        while (!texts.isEmpty() && texts.last().isEmpty())
            texts.removeLast();
        m_fields += showWords(name, texts);
    }

    void axes(const char *name, values::AxisWords &words, values::PositionType type)
    {
        const int before = m_reader.index();
        m_reader.axes(name, words, type);
        addAxes(name, words, type, before);
    }
    void eightAxes(const char *name, values::AxisWords &words, values::PositionType type)
    {
        const int before = m_reader.index();
        m_reader.eightAxes(name, words, type);
        addAxes(name, words, type, before);
    }

    void optional() { m_reader.optional(); }
    void rest() { m_reader.rest(); }

    void derived(const char *name, auto function) { addDerived(name, function()); }

private:
    template <typename Value> Field show(const char *name, const Value &value) const
    {
        if constexpr (std::is_floating_point_v<Value>)
            return showReal(name, value);
        else if constexpr (std::is_enum_v<Value>)
            return {QString::fromLatin1(name), qint64(value), wordsOf(value)};
        else
            return showNumber(name, value);
    }
    template <qsizetype Size> Field show(const char *name, const values::FixedText<Size> &text) const
    {
        return {QString::fromLatin1(name), m_codec.decode(text.bytes()), {}};
    }
    template <typename Enum> Field show(const char *name, QFlags<Enum> flags) const
    {
        return {QString::fromLatin1(name), qint64(flags.toInt()), hexWord(flags.toInt(), 8)};
    }
    template <typename Number, std::size_t Count>
    Field show(const char *name, const std::array<Number, Count> &numbers) const
    {
        QJsonArray list;
        for (const Number number : numbers)
            list += qint64(number);
        return {QString::fromLatin1(name), list, {}};
    }

    static QString wordsOf(values::PositionType type) { return values::toString(type); }
    static QString wordsOf(values::AlarmDataType type) { return values::toString(type); }
    static QString wordsOf(auto) { return {}; }

    /// All axes are one list; a single one is named.
    void addAxes(const char *name, const values::AxisWords &words, values::PositionType type, int before)
    {
        if (m_onlyElement == 0) {
            m_fields += showAxes(name, words);
        } else if (const int axis = m_onlyElement - before - 1; axis >= 0 && axis < values::maxAxes) {
            m_fields += Field {axisName(type, axis), words[axis], {}};
        }
    }
    void addDerived(const char *name, const QStringList &words)
    {
        if (!words.isEmpty())
            m_fields += showWords(name, words);
    }
    void addDerived(const char *name, const QString &text)
    {
        if (!text.isEmpty())
            m_fields += Field {QString::fromLatin1(name), text, {}};
    }
    void addDerived(const char *name, int number) { m_fields += showNumber(name, number); }

    Reader m_reader;
    TextCodec m_codec;
    int m_onlyElement;
    Fields m_fields;
};

} // namespace protocol
