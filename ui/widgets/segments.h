// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QWidget>

class QButtonGroup;

namespace widgets {

/// A few choices side by side, one of which is chosen: for what people change with one look and one click.
class Segments : public QWidget
{
    Q_OBJECT

public:
    /// `name` becomes the object name, which the place of a choice from 1 follows for its button; `title` is read
    /// aloud.
    Segments(const QString &name, const QString &title, QWidget *parent = nullptr);

    /// Other choices; the first is chosen unless `chosen` is another place.
    void setChoices(const QStringList &words, int chosen = 0);
    /// From 0; -1 without choices.
    [[nodiscard]] int chosen() const;
    void choose(int place);

Q_SIGNALS:
    /// The person chose.
    void changed(int place);

private:
    QString m_title;
    QButtonGroup *m_group;
};

} // namespace widgets
