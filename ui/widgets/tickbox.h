// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QCheckBox>

namespace widgets {

/// A check box whose words go on in the next line where they are short of room.
class TickBox : public QCheckBox
{
    Q_OBJECT

public:
    explicit TickBox(const QString &text, QWidget *parent = nullptr);

    [[nodiscard]] QSize minimumSizeHint() const override;
    [[nodiscard]] bool hasHeightForWidth() const override { return true; }
    [[nodiscard]] int heightForWidth(int width) const override;

protected:
    [[nodiscard]] bool hitButton(const QPoint &at) const override { return rect().contains(at); }
    void paintEvent(QPaintEvent *event) override;

private:
    [[nodiscard]] int markWidth() const; ///< Of the square, and the gap before the words.
    [[nodiscard]] QStringList lines(int width) const;
};

} // namespace widgets
