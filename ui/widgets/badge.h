// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/theme.h"
#include <QLabel>

namespace widgets {

/// A word in a rounded frame: the access level, SIMULATION.
class Badge : public QLabel
{
    Q_OBJECT

public:
    Badge(const QString &word, ui::Role ink, ui::Role ground, QWidget *parent = nullptr);

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    ui::Role m_ink;
    ui::Role m_ground;
};

} // namespace widgets
