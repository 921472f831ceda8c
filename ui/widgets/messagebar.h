// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/widgets/lamp.h"
#include <QWidget>

class QLabel;
class QPushButton;

namespace widgets {

enum class Severity { Notice, Warning, Alarm };

/// What the bar says: what happened, since when, and one link.
struct Message {
    Severity severity = Severity::Notice;
    QString text;
    QString link; ///< Empty: no link.

    bool operator==(const Message &) const = default;
};

/// A mark, what happened, one link, and ✕ where it may be closed. Polling errors never open a box; they end in one of
/// these, one at a time.
class MessageBar : public QWidget
{
    Q_OBJECT

public:
    explicit MessageBar(QWidget *parent = nullptr);

    /// Closed, it comes back with the next message that is another.
    void setClosable(bool closable);
    /// An empty text hides the bar.
    void show(const Message &message);
    [[nodiscard]] const Message &message() const { return m_message; }

Q_SIGNALS:
    void linkActivated();
    /// It came into view, went, or says something else.
    void changed();
    /// Assistive technology was told: once for each message that comes in view.
    void announced(const QString &words);

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    Message m_message;
    QLabel *m_text;
    QPushButton *m_link;
    QPushButton *m_close;
};

} // namespace widgets
