// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "inform/token.h"
#include <QSyntaxHighlighter>

class QWidget;

namespace widgets {

/// INFORM as inform::tokenize() cuts it: instruction words semibold, unknown ones underlined as well, labels and called
/// jobs in accent, comments and headers quiet, strings and aliases in italics, signals underlined by dots.
class InformHighlighter : public QSyntaxHighlighter
{
    Q_OBJECT

public:
    /// The colours follow the scheme of `widget`, which must outlive the highlighter.
    InformHighlighter(QTextDocument *document, const QWidget *widget);

    /// The names of the job's //ALIAS; takes effect for text that is set afterwards.
    void setAliases(const inform::Aliases &aliases) { m_aliases = aliases; }

protected:
    void highlightBlock(const QString &line) override;

private:
    [[nodiscard]] QTextCharFormat formatOf(inform::TokenKind kind, QByteArrayView text) const;

    const QWidget *m_widget;
    inform::Aliases m_aliases;
};

} // namespace widgets
