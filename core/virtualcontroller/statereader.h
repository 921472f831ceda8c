// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QJsonArray>
#include <QJsonObject>
#include <QJsonValue>
#include <optional>

namespace virtualcontroller {

/// A JSON value with its place in the document. All values that come from one StateReader share its list of complaints:
/// reading goes on with a default after a fault, and the first one is told at the end.
class StateValue
{
public:
    StateValue(QJsonValue value, QString path, QString &complaint)
        : m_value {std::move(value)}, m_path {std::move(path)}, m_complaint {&complaint}
    {
    }

    [[nodiscard]] const QString &path() const { return m_path; }
    [[nodiscard]] bool isNull() const { return m_value.isNull(); }

    /// Complains and gives the bound nearest to 0 if it is no whole number in first..last.
    [[nodiscard]] qint64 number(qint64 first, qint64 last) const;
    [[nodiscard]] double real() const;
    [[nodiscard]] bool boolean() const;
    /// Latin-1; complains if it is longer than `size` bytes.
    [[nodiscard]] QByteArray text(qsizetype size) const;
    /// Complains if it is none of `words`, and gives 0.
    [[nodiscard]] qsizetype choice(const QStringList &words) const;
    [[nodiscard]] std::vector<StateValue> items() const;
    /// The keys and values of an object.
    [[nodiscard]] std::vector<std::pair<QString, StateValue>> entries() const;

    /// "path what."
    void complain(const QString &what) const;

private:
    QJsonValue m_value;
    QString m_path;
    QString *m_complaint;
};

} // namespace virtualcontroller
