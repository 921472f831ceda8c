// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QByteArrayList>
#include <QSet>
#include <QString>
#include <span>

namespace files {

/// A kind of difference that says nothing about what the robot does.
struct NoiseRule {
    const char *key; ///< For settings and the command line.
    const char *title; ///< Translated by title().
    const char *pattern; ///< Regular expression over the bytes of one line; every match counts as equal.
};

[[nodiscard]] std::span<const NoiseRule> noiseRules();
[[nodiscard]] QString title(const NoiseRule &rule);

/// The rules that are in force.
class NoiseFilter
{
public:
    /// All of them.
    NoiseFilter();
    /// Those with these keys; unknown keys mean nothing.
    explicit NoiseFilter(const QSet<QString> &keys) : m_keys {keys} { }
    [[nodiscard]] static NoiseFilter none() { return NoiseFilter {QSet<QString> {}}; }

    [[nodiscard]] bool isOn(const NoiseRule &rule) const { return m_keys.contains(QString::fromLatin1(rule.key)); }
    /// The line with all noise replaced by the same mark.
    [[nodiscard]] QByteArray clean(const QByteArray &line) const;
    /// Each line of a file, clean. Line endings are part of a line unless their rule is on.
    [[nodiscard]] QByteArrayList cleanLines(const QByteArray &content) const;

private:
    QSet<QString> m_keys;
};

} // namespace files
