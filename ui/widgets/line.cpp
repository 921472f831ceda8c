// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/widgets/line.h"

namespace widgets {

Line::Line(ui::Role role, ui::Type type, QWidget *parent) : ValueLabel(type, parent)
{
    setRole(role);
    setElided(true);
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    setWords({});
}

void Line::setWords(const QString &words) { show({{words, Lamp::None}, robot::Freshness::Live, {}}); }

void keepRoom(QWidget *widget)
{
    QSizePolicy policy = widget->sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    widget->setSizePolicy(policy);
}

} // namespace widgets
