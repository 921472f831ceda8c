// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/widgets/shown.h"
#include <QAbstractButton>
#include <QUuid>

namespace widgets {

/// A controller in the rail: its name, its state in words and the shape that goes with it, how many alarms it has, and
/// the age of its backup. Checked while its pages are in view.
class ControllerTile : public QAbstractButton
{
    Q_OBJECT

public:
    explicit ControllerTile(QWidget *parent = nullptr);

    /// Which controller it is; `tag` as in settings::Profile.
    void showStation(const QUuid &id, const QString &name, int tag);
    [[nodiscard]] const QUuid &id() const { return m_id; }
    void showAlarms(int count);

    void show(const Word &state);
    using QWidget::show;
    [[nodiscard]] const Word &state() const { return m_state; }
    void showBackup(const Word &age);
    [[nodiscard]] const Word &backup() const { return m_backup; }

protected:
    void paintEvent(QPaintEvent *event) override;
    /// Whose pages are in view is not decided by a click.
    void nextCheckState() override { }

private:
    void tellNames();

    QUuid m_id;
    QString m_name;
    int m_tag = 0;
    int m_alarms = 0;
    Word m_state;
    Word m_backup;
};

} // namespace widgets
