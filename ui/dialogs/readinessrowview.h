// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/readiness.h"
#include <QWidget>

class QLabel;

namespace widgets {
class ValueLabel;
}

namespace dialogs {

/// One subject of the readiness sheet: how it stands, in shape and word, what that rests on, and what helps.
class ReadinessRowView : public QWidget
{
    Q_OBJECT

public:
    explicit ReadinessRowView(robot::Subject subject, QWidget *parent = nullptr);

    /// `staleNote` tells when the status was seen last; empty while it is live.
    void show(const robot::ReadinessRow &row, const robot::ReadinessFacts &facts, const QString &staleNote);
    using QWidget::show;

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    QLabel *m_sentence;
    QLabel *m_remedy;
    widgets::ValueLabel *m_allowance;
    QLabel *m_evidence;
};

} // namespace dialogs
