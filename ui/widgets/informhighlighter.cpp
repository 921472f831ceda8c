// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/widgets/informhighlighter.h"

#include "inform/instructions.h"
#include "ui/theme.h"

namespace widgets {

InformHighlighter::InformHighlighter(QTextDocument *document, const QWidget *widget)
    : QSyntaxHighlighter(document), m_widget {widget}
{
}

QTextCharFormat InformHighlighter::formatOf(inform::TokenKind kind, QByteArrayView text) const
{
    using enum inform::TokenKind;
    QTextCharFormat format;
    switch (kind) {
    case Header:
    case Comment:
    case Prefix:
    case TrailingComment: format.setForeground(ui::color(ui::Role::Text2, m_widget)); break;
    case Label:
    case Job: format.setForeground(ui::color(ui::Role::Accent, m_widget)); break;
    case Word:
        format.setFontWeight(QFont::DemiBold);
        if (!inform::findInstruction(text))
            format.setUnderlineStyle(QTextCharFormat::DashUnderline);
        break;
    case Alias:
    case String: format.setFontItalic(true); break;
    case Signal: format.setUnderlineStyle(QTextCharFormat::DotLine); break;
    default: break;
    }
    return format;
}

void InformHighlighter::highlightBlock(const QString &line)
{
    const QByteArray bytes = line.toLatin1(); // a byte a character: what is beyond ASCII is no syntax
    for (const inform::Token &token : inform::tokenize(bytes, m_aliases)) {
        const QTextCharFormat format = formatOf(token.kind, token.in(bytes));
        if (!format.isEmpty())
            setFormat(token.at, token.size, format);
    }
}

} // namespace widgets
