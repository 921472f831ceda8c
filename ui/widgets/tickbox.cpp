// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/widgets/tickbox.h"

#include <QStyleOptionButton>
#include <QStylePainter>
#include <QTextLayout>

namespace widgets {

namespace {

constexpr int leastWords = 120; ///< Pixels; below that lines would be too many to be read.

} // namespace

TickBox::TickBox(const QString &text, QWidget *parent) : QCheckBox(text, parent)
{
    QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Minimum);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
}

int TickBox::markWidth() const { return QCheckBox::sizeHint().width() - fontMetrics().size(0, text()).width(); }

QStringList TickBox::lines(int width) const
{
    QTextLayout layout(text(), font());
    layout.beginLayout();
    for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine())
        line.setLineWidth(std::max(leastWords, width - markWidth()));
    layout.endLayout();
    QStringList result;
    for (int i = 0; i < layout.lineCount(); ++i)
        result << text().sliced(layout.lineAt(i).textStart(), layout.lineAt(i).textLength()).trimmed();
    return result;
}

QSize TickBox::minimumSizeHint() const
{
    const QSize whole = QCheckBox::sizeHint();
    return {std::min(whole.width(), markWidth() + leastWords), whole.height()};
}

int TickBox::heightForWidth(int width) const
{
    const int more = std::max(0, int(lines(width).size()) - 1);
    return QCheckBox::sizeHint().height() + more * fontMetrics().lineSpacing();
}

void TickBox::paintEvent(QPaintEvent *)
{
    QStylePainter painter(this);
    QStyleOptionButton option;
    initStyleOption(&option);
    option.text = lines(width()).join(u'\n');
    painter.drawControl(QStyle::CE_CheckBox, option);
}

} // namespace widgets
