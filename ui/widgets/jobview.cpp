// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/widgets/jobview.h"

#include "ui/theme.h"
#include "ui/widgets/informhighlighter.h"
#include <QEvent>
#include <QPainter>
#include <QTextBlock>

namespace widgets {

namespace {

constexpr int leastDigits = 4; ///< As on the pendant.

} // namespace

class JobView::Gutter : public QWidget
{
public:
    explicit Gutter(JobView *view) : QWidget(view), m_view {view} { }

protected:
    void paintEvent(QPaintEvent *event) override { m_view->paintGutter(this, event->rect()); }

private:
    JobView *m_view;
};

JobView::JobView(QWidget *parent)
    : QPlainTextEdit(parent), m_highlighter {new InformHighlighter(document(), this)}, m_gutter {new Gutter(this)}
{
    setReadOnly(true);
    setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    setLineWrapMode(NoWrap);
    setFont(ui::font(ui::Type::Mono));
    setFrameShape(NoFrame);
    setAccessibleName(tr("Job text"));
    connect(this, &QPlainTextEdit::updateRequest, m_gutter, [this] { m_gutter->update(); });
}

void JobView::showLines(const QStringList &lines, const inform::Aliases &aliases)
{
    if (lines == m_lines)
        return;
    m_lines = lines;
    m_highlighter->setAliases(aliases);
    setPlainText(lines.join(u'\n'));
    setViewportMargins(gutterWidth(), 0, 0, 0);
    markExecuting();
}

void JobView::setExecutingLine(std::optional<int> line)
{
    if (std::exchange(m_executing, line) != line)
        markExecuting();
}

void JobView::setFollowing(bool isFollowing)
{
    m_isFollowing = isFollowing;
    markExecuting();
}

void JobView::goTo(int line)
{
    setTextCursor(QTextCursor(document()->findBlockByNumber(line)));
    centerCursor();
}

void JobView::markExecuting()
{
    QList<QTextEdit::ExtraSelection> marks;
    const QTextBlock block = document()->findBlockByNumber(m_executing.value_or(-1));
    if (m_executing && block.isValid() && !m_lines.isEmpty()) {
        QTextEdit::ExtraSelection mark;
        mark.cursor = QTextCursor(block);
        mark.format.setBackground(ui::color(ui::Role::AccentGround, this));
        mark.format.setProperty(QTextFormat::FullWidthSelection, true);
        marks << mark;
        if (m_isFollowing)
            goTo(*m_executing);
    }
    setExtraSelections(marks);
    m_gutter->update();
}

int JobView::gutterWidth() const
{
    const auto digits = std::max<qsizetype>(leastDigits, QString::number(m_lines.size()).size());
    return fontMetrics().horizontalAdvance(u'0') * int(digits + 3);
}

void JobView::resizeEvent(QResizeEvent *event)
{
    QPlainTextEdit::resizeEvent(event);
    const QRect area = contentsRect();
    m_gutter->setGeometry(area.left(), area.top(), gutterWidth(), area.height());
}

void JobView::changeEvent(QEvent *event)
{
    QPlainTextEdit::changeEvent(event);
    if (event->type() != QEvent::PaletteChange)
        return;
    m_highlighter->rehighlight();
    markExecuting();
}

void JobView::paintGutter(QWidget *gutter, const QRect &area) const
{
    if (m_lines.isEmpty())
        return;
    QPainter painter(gutter);
    painter.setFont(font());
    const int digit = fontMetrics().horizontalAdvance(u'0');
    for (QTextBlock block = firstVisibleBlock(); block.isValid(); block = block.next()) {
        const QRectF place = blockBoundingGeometry(block).translated(contentOffset());
        if (place.top() > area.bottom())
            break;
        const bool isExecuting = m_executing == block.blockNumber();
        const QRectF line(0, place.top(), gutter->width() - digit, place.height());
        if (isExecuting)
            painter.fillRect(line.adjusted(0, 0, digit, 0), ui::color(ui::Role::AccentGround, this));
        painter.setPen(ui::color(isExecuting ? ui::Role::Accent : ui::Role::Text2, this));
        painter.drawText(line, Qt::AlignRight | Qt::AlignTop, QString::number(block.blockNumber()));
        if (isExecuting)
            painter.drawText(line, Qt::AlignLeft | Qt::AlignTop, QStringLiteral("▶"));
    }
}

} // namespace widgets
