// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/widgets/sheetframe.h"

#include "ui/theme.h"
#include "ui/widgets/dialogsheet.h"
#include "ui/widgets/sheetlayer.h"
#include "ui/widgets/text.h"
#include <QEvent>
#include <QLabel>
#include <QLayout>
#include <QPushButton>
#include <QScrollArea>
#include <QStyle>
#include <QVBoxLayout>

namespace widgets {

namespace {

constexpr int edge = 12; ///< Between the sheet and the borders of the layer.

} // namespace

SheetFrame::SheetFrame(DialogSheet *sheet, SheetLayer *layer)
    : QFrame(layer),
      m_layer {layer},
      m_sheet {sheet},
      m_first {sheet->focusWidget()},
      m_title {text(sheet->windowTitle(), ui::Type::Heading, ui::Role::Text2)},
      m_scroll {new QScrollArea},
      m_wanted {sheet->testAttribute(Qt::WA_Resized) ? sheet->size() : sheet->sizeHint()}
{
    hide();
    setObjectName(QStringLiteral("sheetFrame"));
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    m_title->setObjectName(QStringLiteral("sheetTitle"));
    m_title->setTextFormat(Qt::PlainText);
    m_title->setContentsMargins(ui::space::page, 10, ui::space::page, 0);
    m_scroll->setFrameShape(QFrame::NoFrame);
    m_scroll->setFocusPolicy(Qt::NoFocus);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_title);
    column->addWidget(m_scroll, 1);
    connect(sheet, &QWidget::windowTitleChanged, m_title, &QLabel::setText);
    connect(sheet, &QObject::destroyed, this, [this] {
        m_layer->onHidden(this);
        deleteLater();
    });
    sheet->installEventFilter(this);
    m_scroll->setWidget(sheet);
    sheet->setWindowFlags(Qt::SubWindow); // Tab goes round inside
}

SheetFrame::~SheetFrame()
{
    if (!m_sheet)
        return;
    m_sheet->removeEventFilter(this);
    m_sheet->disconnect(this);
    delete m_sheet;
}

bool SheetFrame::eventFilter(QObject *watched, QEvent *event)
{
    if (watched == m_sheet) {
        switch (event->type()) {
        case QEvent::ShowToParent: m_layer->onShown(this); break;
        case QEvent::HideToParent: m_layer->onHidden(this); break;
        case QEvent::LayoutRequest: place(); break;
        default: break;
        }
    }
    return QFrame::eventFilter(watched, event);
}

/// What the words of the sheet need at least when it is so wide.
QSize SheetFrame::needed(int width) const
{
    const QLayout *layout = m_sheet->layout();
    if (!layout)
        return m_sheet->minimumSize();
    const QSize least = layout->totalMinimumSize().expandedTo(m_sheet->minimumSize());
    const int wide = std::max(width, least.width());
    const int lines = layout->hasHeightForWidth() ? layout->totalHeightForWidth(wide) : 0;
    return {wide, std::max(least.height(), lines)};
}

void SheetFrame::place()
{
    if (!m_sheet)
        return;
    const QSize room = m_layer->size() - QSize(2 * edge, 2 * edge);
    const QSize border {2 * frameWidth(), 2 * frameWidth() + m_title->sizeHint().height()};
    const QSize free = room - border;
    const QSize least = needed(std::min(m_wanted.width(), free.width()));
    m_wanted = m_wanted.expandedTo(least);
    const QSize inside = m_wanted.boundedTo(free).expandedTo(least);
    const int bar = m_scroll->style()->pixelMetric(QStyle::PM_ScrollBarExtent);
    const QSize scrolled {inside.height() > free.height() ? inside.width() + bar : inside.width(),
        inside.width() > free.width() ? inside.height() + bar : inside.height()};
    const QSize outside = (scrolled + border).boundedTo(room);
    m_sheet->resize(inside);
    setGeometry(QRect({(m_layer->width() - outside.width()) / 2, edge}, outside));
}

void SheetFrame::takeFocus()
{
    if (!m_sheet)
        return;
    const auto mayHaveFocus = [this](QWidget *widget) {
        const auto *button = qobject_cast<QPushButton *>(widget);
        return widget != m_sheet && m_sheet->isAncestorOf(widget) && (widget->focusPolicy() & Qt::TabFocus)
            && widget->isVisibleTo(m_sheet) && widget->isEnabled() && !(button && isWriting(button));
    };
    for (QWidget *widget : {m_sheet->focusWidget(), m_first.data()}) {
        if (widget && mayHaveFocus(widget))
            return widget->setFocus(Qt::OtherFocusReason);
    }
    for (QWidget *next = m_sheet->nextInFocusChain(); next != m_sheet; next = next->nextInFocusChain()) {
        if (mayHaveFocus(next))
            return next->setFocus(Qt::OtherFocusReason);
    }
    m_sheet->setFocusPolicy(Qt::StrongFocus); // so that Escape is heard
    m_sheet->setFocus(Qt::OtherFocusReason);
}

void SheetFrame::scrollTo(QWidget *widget)
{
    if (widget != m_sheet && m_sheet->isAncestorOf(widget))
        m_scroll->ensureWidgetVisible(widget);
}

} // namespace widgets
