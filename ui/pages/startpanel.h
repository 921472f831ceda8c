// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/pages/page.h"

class QPushButton;
class QVBoxLayout;

namespace pages {

/// The way to a connection while there is no link: the controllers that were connected last, or what a person can begin
/// with who has none yet. A page shows it instead of its cards. It is made anew whenever it comes into view.
class StartPanel : public QWidget
{
    Q_OBJECT

public:
    explicit StartPanel(const Context &context, QWidget *parent = nullptr);

protected:
    void showEvent(QShowEvent *event) override;

private:
    void make();
    [[nodiscard]] QWidget *makeContent();
    void addRecent(QVBoxLayout *column);
    void addOffers(QVBoxLayout *column);
    [[nodiscard]] QPushButton *actionButton(const QString &name, const QString &words, int action);
    void press();

    Context m_context;
    QPushButton *m_primary = nullptr; ///< The filled one; Enter presses it.
};

} // namespace pages
