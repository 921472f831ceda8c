// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/widgets/shown.h"
#include <QWidget>

namespace widgets {

/// A controller in the rail: its name, its state in words and the shape that goes with it, and the age of its backup.
class ControllerTile : public QWidget
{
    Q_OBJECT

public:
    explicit ControllerTile(const QString &name, QWidget *parent = nullptr);

    void show(const Word &state);
    using QWidget::show;
    [[nodiscard]] const Word &state() const { return m_state; }
    void showBackup(const Word &age);
    [[nodiscard]] const Word &backup() const { return m_backup; }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    void tellNames();

    QString m_name;
    Word m_state;
    Word m_backup;
};

} // namespace widgets
