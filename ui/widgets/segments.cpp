// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/widgets/segments.h"

#include "ui/theme.h"
#include "ui/widgets/flow.h"
#include <QButtonGroup>
#include <QPushButton>

namespace widgets {

namespace {

/// The chosen one is written bold, and its neighbours stand still.
int chosenWidth(const QString &word)
{
    QFont bold = ui::font(ui::Type::Body);
    bold.setWeight(QFont::DemiBold);
    constexpr int padding = 9; // of the style sheet, with the border
    return QFontMetrics(bold).horizontalAdvance(word) + 2 * padding + 1;
}

} // namespace

Segments::Segments(const QString &name, const QString &title, QWidget *parent)
    : QWidget(parent), m_title {title}, m_group {new QButtonGroup(this)}
{
    setObjectName(name);
    setAccessibleName(title);
    auto *row = new Flow(this);
    row->setSpacing(0);
    connect(m_group, &QButtonGroup::idClicked, this, &Segments::changed);
}

void Segments::setChoices(const QStringList &words, int chosen)
{
    qDeleteAll(m_group->buttons());
    for (int place = 0; place < int(words.size()); ++place) {
        auto *button = new QPushButton(words[place]);
        button->setObjectName(objectName() + QString::number(place + 1));
        button->setAccessibleName(tr("%1: %2", "what is chosen: the choice").arg(m_title, words[place]));
        button->setCheckable(true);
        button->setAutoDefault(false);
        button->setProperty("segment", true);
        button->setMinimumWidth(chosenWidth(words[place]));
        m_group->addButton(button, place);
        layout()->addWidget(button);
    }
    choose(chosen);
}

int Segments::chosen() const { return m_group->checkedId(); }

void Segments::choose(int place)
{
    if (auto *button = m_group->button(place))
        button->setChecked(true);
}

} // namespace widgets
