// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/widgets/informhighlighter.h"

#include "ui/theme.h"
#include <QRegularExpression>

namespace widgets {

InformHighlighter::InformHighlighter(QTextDocument *document, const QWidget *widget)
    : QSyntaxHighlighter(document), m_widget {widget}
{
}

void InformHighlighter::highlightBlock(const QString &line)
{
    static const QRegularExpression word {QStringLiteral("^\\s*[A-Z][A-Z0-9#]*")};
    static const QRegularExpression link {QStringLiteral("\\*[^\\s]+|JOB:[^\\s]+")};
    const auto coloured = [this](ui::Role role) {
        QTextCharFormat format;
        format.setForeground(ui::color(role, m_widget));
        return format;
    };
    if (line.trimmed().startsWith(u'\''))
        return setFormat(0, int(line.size()), coloured(ui::Role::Text2));
    QTextCharFormat strong;
    strong.setFontWeight(QFont::DemiBold);
    if (const auto found = word.match(line); found.hasMatch())
        setFormat(int(found.capturedStart()), int(found.capturedLength()), strong);
    for (auto found = link.globalMatch(line); found.hasNext();) {
        const auto match = found.next();
        setFormat(int(match.capturedStart()), int(match.capturedLength()), coloured(ui::Role::Accent));
    }
}

} // namespace widgets
