// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/fit.h"

#include "ui/widgets/badge.h"
#include "ui/widgets/valuelabel.h"
#include <QAbstractButton>
#include <QAbstractScrollArea>
#include <QAbstractSpinBox>
#include <QCheckBox>
#include <QComboBox>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QRadioButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QStyleOptionButton>
#include <QStyleOptionComboBox>
#include <QStyleOptionGroupBox>
#include <QTabBar>

namespace fit {

namespace {

/// A part that Qt makes and lays out by itself.
bool isPartOfQt(const QWidget &widget)
{
    const QWidget *parent = widget.parentWidget();
    if (!parent || widget.isWindow())
        return false;
    const bool isInEditor = qobject_cast<const QLineEdit *>(parent) || qobject_cast<const QComboBox *>(parent)
        || qobject_cast<const QAbstractSpinBox *>(parent) || qobject_cast<const QTabBar *>(parent);
    const auto *area = qobject_cast<const QAbstractScrollArea *>(parent);
    const bool isBar = area && &widget != area->viewport() && !qobject_cast<const QHeaderView *>(&widget);
    return isInEditor || isBar || widget.inherits("QTableCornerButton");
}

void collect(const QWidget &widget, QList<const QWidget *> &found)
{
    found << &widget;
    for (const QObject *child : widget.children()) {
        const auto *inner = qobject_cast<const QWidget *>(child);
        if (inner && inner->isVisible() && !inner->isWindow() && !isPartOfQt(*inner))
            collect(*inner, found);
    }
}

QString withoutMnemonic(QString text)
{
    return text.replace(QStringLiteral("&&"), QStringLiteral("\n"))
        .remove(u'&')
        .replace(QStringLiteral("\n"), QStringLiteral("&"));
}

/// Whole words of the widget can be read elsewhere.
bool isToldElsewhere(const QWidget &widget, const QString &text)
{
    return widget.toolTip().contains(text) || (widget.accessibleName().contains(text) && !text.isEmpty());
}

template <typename Option, typename Widget> Option optionOf(const Widget &widget)
{
    struct Opened : Widget {
        using Widget::initStyleOption;
    };
    Option option;
    std::invoke(&Opened::initStyleOption, widget, &option);
    return option;
}

QString least(const QWidget &widget, int wanted, int there, const QString &text)
{
    if (wanted <= there)
        return {};
    return QStringLiteral("%1: “%2” needs %3, has %4").arg(nameOf(widget), text).arg(wanted).arg(there);
}

QString high(const QString &text) { return text + QStringLiteral(" (height)"); }

QString labelFinding(const QLabel &label)
{
    const QString text = label.text();
    if (text.isEmpty())
        return {};
    if (label.wordWrap()) {
        const QString lines = least(label, label.heightForWidth(label.width()), label.height(), high(text));
        return lines.isEmpty() ? least(label, label.minimumSizeHint().width(), label.width(), text) : lines;
    }
    const bool isShortened = label.minimumSizeHint().width() < label.sizeHint().width() && isToldElsewhere(label, text);
    if (isShortened)
        return {};
    const QString wide = least(label, label.sizeHint().width(), label.width(), text);
    return wide.isEmpty() ? least(label, label.sizeHint().height() - 4, label.height(), high(text)) : wide;
}

QString pushButtonFinding(const QPushButton &button)
{
    auto option = optionOf<QStyleOptionButton>(button);
    const QRect room = button.style()->subElementRect(QStyle::SE_PushButtonContents, &option, &button);
    QFont font = button.font();
    if (button.property("segment").toBool() || button.property("rail").toBool() || button.property("primary").toBool())
        font.setWeight(QFont::DemiBold); // as the style sheet has them, pressed or not
    const QFontMetrics metrics(font);
    const int icon = option.icon.isNull() ? 0 : option.iconSize.width() + 4;
    const QString text = withoutMnemonic(button.text());
    const QString wide =
        least(button, metrics.size(Qt::TextShowMnemonic, button.text()).width() + icon, room.width(), text);
    return wide.isEmpty() ? least(button, metrics.height(), room.height() + 2, high(text)) : wide;
}

QString boxFinding(const QAbstractButton &box, QStyle::SubElement element, const QStyleOptionButton &option)
{
    const QRect room = box.style()->subElementRect(element, &option, &box);
    return least(box, box.fontMetrics().size(Qt::TextShowMnemonic, box.text()).width(), room.width(), box.text());
}

QString buttonFinding(const QAbstractButton &button)
{
    if (button.hasHeightForWidth()) { // its words wrap
        const QString lines =
            least(button, button.heightForWidth(button.width()), button.height(), high(button.text()));
        return lines.isEmpty() ? least(button, button.minimumSizeHint().width(), button.width(), button.text()) : lines;
    }
    if (const auto *push = qobject_cast<const QPushButton *>(&button))
        return pushButtonFinding(*push);
    if (const auto *check = qobject_cast<const QCheckBox *>(&button))
        return boxFinding(button, QStyle::SE_CheckBoxContents, optionOf<QStyleOptionButton>(*check));
    if (const auto *radio = qobject_cast<const QRadioButton *>(&button))
        return boxFinding(button, QStyle::SE_RadioButtonContents, optionOf<QStyleOptionButton>(*radio));
    return least(button, button.sizeHint().width(), button.width(), button.text());
}

QString comboFinding(const QComboBox &combo)
{
    const auto option = optionOf<QStyleOptionComboBox>(combo);
    const QRect room =
        combo.style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &combo);
    const QString text = combo.currentText();
    return isToldElsewhere(combo, text) ? QString()
                                        : least(combo, combo.fontMetrics().horizontalAdvance(text), room.width(), text);
}

QString groupFinding(const QGroupBox &group)
{
    const auto option = optionOf<QStyleOptionGroupBox>(group);
    const QRect room = group.style()->subControlRect(QStyle::CC_GroupBox, &option, QStyle::SC_GroupBoxLabel, &group);
    return least(
        group, group.fontMetrics().size(Qt::TextShowMnemonic, group.title()).width(), room.width(), group.title());
}

QString editFinding(const QLineEdit &edit)
{
    if (edit.placeholderText().isEmpty() || isToldElsewhere(edit, edit.placeholderText()))
        return {};
    QStyleOptionFrame option;
    option.initFrom(&edit);
    option.lineWidth = edit.style()->pixelMetric(QStyle::PM_DefaultFrameWidth, &option, &edit);
    const QRect room = edit.style()->subElementRect(QStyle::SE_LineEditContents, &option, &edit);
    const int inset = 4 + edit.textMargins().left() + edit.textMargins().right();
    const int wanted = edit.fontMetrics().horizontalAdvance(edit.placeholderText()) + inset;
    return least(edit, wanted, room.width(), edit.placeholderText());
}

QStringList headFindings(const QHeaderView &head)
{
    QStringList result;
    const QAbstractItemModel *model = head.model();
    for (int i = 0; model && head.orientation() == Qt::Horizontal && i < head.count(); ++i) {
        const QString text = model->headerData(i, head.orientation()).toString();
        const bool isTold = model->headerData(i, head.orientation(), Qt::ToolTipRole).toString().contains(text);
        QFont font = head.font();
        font.setWeight(QFont::DemiBold);
        const int margins = 2 * head.style()->pixelMetric(QStyle::PM_HeaderMargin, nullptr, &head);
        const int wanted = QFontMetrics(font).horizontalAdvance(text) + margins;
        if (!head.isSectionHidden(i) && !text.isEmpty() && !isTold)
            result << least(head, wanted, head.sectionSize(i), text);
    }
    return result;
}

QStringList tabFindings(const QTabBar &bar)
{
    QStringList result;
    const QRect open = bar.tabRect(bar.currentIndex());
    if (bar.count() > 0 && !bar.rect().contains(open))
        result
            << QStringLiteral("%1: the open tab “%2” is not in view").arg(nameOf(bar), bar.tabText(bar.currentIndex()));
    for (int i = 0; i < bar.count(); ++i) {
        const int room = std::min(bar.tabRect(i).width(), bar.width()); // those out of view are scrolled to
        constexpr int padding = 2 * 10; // of the style sheet
        result << least(bar, bar.fontMetrics().horizontalAdvance(bar.tabText(i)), room - padding, bar.tabText(i));
    }
    return result;
}

QStringList textFindings(const QWidget &widget)
{
    if (const auto *label = qobject_cast<const QLabel *>(&widget))
        return {labelFinding(*label)};
    if (const auto *button = qobject_cast<const QAbstractButton *>(&widget))
        return {buttonFinding(*button)};
    if (const auto *combo = qobject_cast<const QComboBox *>(&widget))
        return {comboFinding(*combo)};
    if (const auto *group = qobject_cast<const QGroupBox *>(&widget))
        return {groupFinding(*group)};
    if (const auto *edit = qobject_cast<const QLineEdit *>(&widget))
        return {editFinding(*edit)};
    if (const auto *head = qobject_cast<const QHeaderView *>(&widget))
        return headFindings(*head);
    if (const auto *bar = qobject_cast<const QTabBar *>(&widget))
        return tabFindings(*bar);
    return {};
}

/// Layouts give less than the least when the window is too small for them.
QStringList sizeFindings(const QWidget &widget)
{
    if (qobject_cast<const QLabel *>(&widget) || qobject_cast<const QHeaderView *>(&widget) || widget.isWindow())
        return {};
    const QSize wanted = widget.minimumSizeHint().boundedTo(widget.maximumSize());
    return {least(widget, wanted.width(), widget.width(), QStringLiteral("width")),
        least(widget, wanted.height(), widget.height(), QStringLiteral("height"))};
}

bool isViewport(const QWidget &widget)
{
    const auto *area = qobject_cast<const QAbstractScrollArea *>(widget.parentWidget());
    return area && area->viewport() == &widget;
}

/// What is in the viewport of an area can be scrolled to.
bool canBeScrolledTo(const QWidget &widget)
{
    if (!isViewport(*widget.parentWidget()))
        return false;
    const auto *area = static_cast<const QAbstractScrollArea *>(widget.parentWidget()->parentWidget());
    return area->horizontalScrollBarPolicy() != Qt::ScrollBarAlwaysOff || widget.width() <= area->viewport()->width();
}

QString outsideFinding(const QWidget &widget)
{
    const QWidget *parent = widget.parentWidget();
    if (widget.isWindow() || !parent || canBeScrolledTo(widget) || parent->rect().contains(widget.geometry()))
        return {};
    const QRect place = widget.geometry();
    return QStringLiteral("%1 sticks out of %2: %3 %4 %5 %6 in %7 %8")
        .arg(nameOf(widget), nameOf(*parent))
        .arg(place.x())
        .arg(place.y())
        .arg(place.width())
        .arg(place.height())
        .arg(parent->width())
        .arg(parent->height());
}

QStringList overlapFindings(const QWidget &widget, const QList<const QWidget *> &all)
{
    QStringList result;
    QList<const QWidget *> children;
    for (const QWidget *one : all) {
        const bool isArea = qobject_cast<const QAbstractScrollArea *>(&widget) || isViewport(widget);
        if (one->parentWidget() == &widget && !one->isWindow() && !isArea)
            children << one;
    }
    for (qsizetype i = 0; i < children.size(); ++i) {
        for (qsizetype k = i + 1; k < children.size(); ++k) {
            if (children[i]->geometry().intersects(children[k]->geometry()))
                result << QStringLiteral("%1 overlaps %2").arg(nameOf(*children[i]), nameOf(*children[k]));
        }
    }
    return result;
}

} // namespace

QString nameOf(const QWidget &widget)
{
    const QWidget *named = widget.parentWidget();
    while (named && named->objectName().isEmpty())
        named = named->parentWidget();
    return QStringLiteral("%1/%2 '%3'")
        .arg(named ? named->objectName() : QString(), QLatin1String(widget.metaObject()->className()),
            widget.objectName());
}

QList<const QWidget *> visibleWidgets(const QWidget &root)
{
    QList<const QWidget *> result;
    collect(root, result);
    return result;
}

QStringList words(const QWidget &widget)
{
    QStringList result {widget.toolTip(), widget.accessibleName()};
    if (const auto *label = qobject_cast<const QLabel *>(&widget))
        result << label->text();
    else if (const auto *button = qobject_cast<const QAbstractButton *>(&widget))
        result << button->text();
    else if (const auto *group = qobject_cast<const QGroupBox *>(&widget))
        result << group->title();
    else if (const auto *edit = qobject_cast<const QLineEdit *>(&widget))
        result << edit->placeholderText();
    if (const auto *combo = qobject_cast<const QComboBox *>(&widget)) {
        for (int i = 0; i < combo->count(); ++i)
            result << combo->itemText(i);
    }
    if (const auto *bar = qobject_cast<const QTabBar *>(&widget)) {
        for (int i = 0; i < bar->count(); ++i)
            result << bar->tabText(i) << bar->tabToolTip(i);
    }
    if (const auto *head = qobject_cast<const QHeaderView *>(&widget); head && head->orientation() == Qt::Horizontal) {
        for (int i = 0; head->model() && i < head->count(); ++i)
            result << head->model()->headerData(i, Qt::Horizontal).toString()
                   << head->model()->headerData(i, Qt::Horizontal, Qt::ToolTipRole).toString();
    }
    result.removeAll(QString());
    return result;
}

QStringList findings(const QWidget &root)
{
    QStringList result;
    const QList<const QWidget *> all = visibleWidgets(root);
    for (const QWidget *widget : all) {
        result << textFindings(*widget) << sizeFindings(*widget) << outsideFinding(*widget)
               << overlapFindings(*widget, all);
    }
    result.removeAll(QString());
    result.removeDuplicates();
    return result;
}

QStringList sidewaysScrolled(const QWidget &root)
{
    QStringList result;
    for (const auto *area : root.findChildren<QAbstractScrollArea *>()) {
        if (area->isVisible() && area->horizontalScrollBar()->isVisible())
            result << QStringLiteral("%1 is scrolled sideways: %2 too narrow")
                          .arg(nameOf(*area))
                          .arg(area->horizontalScrollBar()->maximum());
    }
    return result;
}

} // namespace fit
