// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "settings/profilestore.h"
#include "ui/widgets/shown.h"
#include <QPushButton>

namespace pages::start {

/// "connected today 14:03", "connected yesterday 14:03", else with the date by the locale; "no connection noted yet"
/// for an invalid time.
[[nodiscard]] QString connectedText(const QDateTime &at, const QDateTime &now);

/// A controller to be connected to with one click: name and address, when it was connected last, the age of its backup.
class RecentTile : public QPushButton
{
    Q_OBJECT

public:
    /// The filled one says in words what it does.
    RecentTile(const settings::RecentProfile &recent, const QDateTime &now, bool isFilled, QWidget *parent = nullptr);

    void showBackup(const widgets::Word &age);

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    void tellNames();
    [[nodiscard]] ui::Role role(ui::Role usual) const;

    bool m_isFilled;
    QString m_name;
    QString m_address;
    QString m_connected;
    widgets::Word m_backup;
};

} // namespace pages::start
