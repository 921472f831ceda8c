// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "virtualcontroller/statereader.h"

#include <algorithm>
#include <cmath>

namespace virtualcontroller {

void StateValue::complain(const QString &what) const
{
    if (m_complaint->isEmpty())
        *m_complaint = QStringLiteral("%1 %2.").arg(m_path, what);
}

qint64 StateValue::number(qint64 first, qint64 last) const
{
    const double value = m_value.toDouble(NAN);
    if (value >= double(first) && value <= double(last) && value == std::floor(value))
        return qint64(value);
    complain(QStringLiteral("is not a whole number from %1 to %2").arg(first).arg(last));
    return std::clamp<qint64>(0, first, last);
}

double StateValue::real() const
{
    if (!m_value.isDouble())
        complain(QStringLiteral("is not a number"));
    return m_value.toDouble();
}

bool StateValue::boolean() const
{
    if (!m_value.isBool())
        complain(QStringLiteral("is neither true nor false"));
    return m_value.toBool();
}

QByteArray StateValue::text(qsizetype size) const
{
    const QByteArray bytes = m_value.toString().toLatin1();
    if (!m_value.isString() || bytes.size() > size)
        complain(QStringLiteral("is not a text of at most %1 characters").arg(size));
    return bytes.first(std::min(size, bytes.size()));
}

qsizetype StateValue::choice(const QStringList &words) const
{
    const qsizetype index = words.indexOf(m_value.toString());
    if (index < 0)
        complain(QStringLiteral("is none of %1").arg(words.join(QStringLiteral(", "))));
    return std::max<qsizetype>(index, 0);
}

std::vector<StateValue> StateValue::items() const
{
    if (!m_value.isArray())
        complain(QStringLiteral("is not a list"));
    std::vector<StateValue> result;
    const QJsonArray array = m_value.toArray();
    for (qsizetype index = 0; index < array.size(); ++index)
        result.emplace_back(array[index], QStringLiteral("%1[%2]").arg(m_path).arg(index), *m_complaint);
    return result;
}

std::vector<std::pair<QString, StateValue>> StateValue::entries() const
{
    if (!m_value.isObject())
        complain(QStringLiteral("is not an object"));
    std::vector<std::pair<QString, StateValue>> result;
    const QJsonObject object = m_value.toObject();
    for (auto entry = object.begin(); entry != object.end(); ++entry) {
        const QString path = m_path.isEmpty() ? entry.key() : m_path + QLatin1Char('.') + entry.key();
        result.emplace_back(entry.key(), StateValue {entry.value(), path, *m_complaint});
    }
    return result;
}

} // namespace virtualcontroller
