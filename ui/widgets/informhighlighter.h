// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QSyntaxHighlighter>

class QWidget;

namespace widgets {

/// INFORM in the theme's colours: instruction words semibold, labels and called jobs in accent, comments quiet.
class InformHighlighter : public QSyntaxHighlighter
{
    Q_OBJECT

public:
    /// The colours follow the scheme of `widget`, which must outlive the highlighter.
    InformHighlighter(QTextDocument *document, const QWidget *widget);

protected:
    void highlightBlock(const QString &line) override;

private:
    const QWidget *m_widget;
};

} // namespace widgets
