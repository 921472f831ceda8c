// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/widgets/line.h"

class QHBoxLayout;

namespace widgets {

/// The line at the top of a page: its name, what its values are of, and its tools at the right. It never goes away and
/// never changes its height.
class PageLine : public QWidget
{
    Q_OBJECT

public:
    explicit PageLine(QWidget *parent = nullptr);

    void setName(const QString &name);
    /// What the values are of: "live", "last values, read before 12:03:04". The tool tip says more than there is room
    /// for.
    void setSubject(const Shown &subject);
    void addTool(QWidget *tool);

private:
    QLabel *m_name;
    Line *m_subject;
    QHBoxLayout *m_tools;
};

} // namespace widgets
