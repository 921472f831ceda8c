// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "names/names.h"

#include <algorithm>

namespace names {

namespace {

template <typename Key> void writeTo(QJsonObject &json, const QHash<Key, QString> &names)
{
    for (auto name = names.begin(); name != names.end(); ++name)
        json[toString(name.key())] = name.value();
}

bool holds(const QString &text, const QStringList &words)
{
    return std::ranges::all_of(words, [&](const QString &word) { return text.contains(word, Qt::CaseInsensitive); });
}

template <typename Key>
QList<Key> findIn(const QHash<Key, QString> &own, const QHash<Key, QString> &local, const QString &text, int most)
{
    const QStringList words = text.split(u' ', Qt::SkipEmptyParts);
    QList<Key> found;
    for (const auto *names : {&local, &own}) {
        for (auto name = names->begin(); name != names->end(); ++name) {
            const bool isHidden = names == &own && local.contains(name.key());
            if (!isHidden && holds(toString(name.key()) + u' ' + name.value(), words))
                found += name.key();
        }
    }
    std::ranges::sort(found);
    return found.first(std::min<qsizetype>(found.size(), most));
}

} // namespace

QJsonObject Names::localNames() const
{
    QJsonObject json;
    writeTo(json, m_local.signalNames);
    writeTo(json, m_local.variableNames);
    return json;
}

void Names::setLocalNames(const QJsonObject &json, const protocol::Dialect &dialect)
{
    m_local = {};
    for (auto entry = json.begin(); entry != json.end(); ++entry) {
        if (const auto signal = signalFromText(entry.key(), dialect))
            setLocal(*signal, entry.value().toString());
        else if (const auto variable = variables::referenceFromText(entry.key(), dialect))
            setLocal(*variable, entry.value().toString());
    }
}

QList<Signal> Names::findSignals(const QString &text, int most) const
{
    return findIn(m_own.signalNames, m_local.signalNames, text, most);
}

QList<variables::Reference> Names::findVariables(const QString &text, int most) const
{
    return findIn(m_own.variableNames, m_local.variableNames, text, most);
}

} // namespace names
