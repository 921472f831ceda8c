// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "names/signal.h"
#include "variables/reference.h"
#include <QHash>
#include <QJsonObject>

namespace names {

/// A name, and whose it is.
struct Name {
    QString text; ///< Empty: there is none.
    bool isLocal = false; ///< Given on this computer, not by the controller.

    bool operator==(const Name &) const = default;
};

/// What the signals and variables of one controller are called: by its own files, and by people at this computer, whose
/// names come first and are kept apart.
class Names
{
public:
    [[nodiscard]] Name of(const Signal &signal) const { return find(m_own.signalNames, m_local.signalNames, signal); }
    [[nodiscard]] Name of(const variables::Reference &variable) const
    {
        return find(m_own.variableNames, m_local.variableNames, variable);
    }
    /// What the controller itself says; empty if nothing.
    [[nodiscard]] QString own(const Signal &signal) const { return m_own.signalNames.value(signal); }
    [[nodiscard]] QString own(const variables::Reference &variable) const
    {
        return m_own.variableNames.value(variable);
    }

    /// An empty or blank text takes the local name away.
    void setLocal(const Signal &signal, const QString &text) { set(m_local.signalNames, signal, text); }
    void setLocal(const variables::Reference &variable, const QString &text)
    {
        set(m_local.variableNames, variable, text);
    }

    /// Replaces what the controller says of its signals, or of its variables and registers.
    void takeSignalNames(QHash<Signal, QString> names) { m_own.signalNames = std::move(names); }
    void takeVariableNames(QHash<variables::Reference, QString> names) { m_own.variableNames = std::move(names); }

    /// The local names, as they are kept in the settings: {"#00010": "DOOR", "B000": "PARTS"}.
    [[nodiscard]] QJsonObject localNames() const;
    /// Keys that this controller does not have are left out.
    void setLocalNames(const QJsonObject &json, const protocol::Dialect &dialect);

    /// Signals and variables whose name or number holds every word of `text`, any case; at most `most`.
    [[nodiscard]] QList<Signal> findSignals(const QString &text, int most) const;
    [[nodiscard]] QList<variables::Reference> findVariables(const QString &text, int most) const;

private:
    struct Tables {
        QHash<Signal, QString> signalNames;
        QHash<variables::Reference, QString> variableNames;
    };

    template <typename Key>
    static Name find(const QHash<Key, QString> &own, const QHash<Key, QString> &local, const Key &key)
    {
        if (const auto found = local.find(key); found != local.end())
            return {*found, true};
        return {own.value(key), false};
    }

    template <typename Key> static void set(QHash<Key, QString> &local, const Key &key, const QString &text)
    {
        if (const QString name = text.trimmed(); name.isEmpty())
            local.remove(key);
        else
            local.insert(key, name);
    }

    Tables m_own;
    Tables m_local;
};

} // namespace names
