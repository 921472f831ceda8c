// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/dialogs/overwritedialog.h"
#include "ui/pages/page.h"

namespace pages {

/// A file that may be sent or fetched.
struct Offer {
    files::Direction direction;
    values::FileName name;
    QString localPath;
    bool isTaken = false; ///< The name exists where it is to go.
};

/// Asks a person what is to be asked before files go, and hands what is decided to the queue.
class Offers : public QObject
{
    Q_OBJECT

public:
    /// All of them must outlive it; boxes open above `window`.
    Offers(const Context &context, QWidget *window);

    /// Asks about one after the other where its name is taken. Forgets what was still to be decided.
    void ask(const QList<Offer> &offers);
    /// Looks at files before they are sent, tells what was found, and asks about those that may be sent.
    void lookAndAsk(const QList<Offer> &offers);

private:
    using Choice = dialogs::OverwriteDialog::Choice;

    void askNext();
    void askAbout(const Offer &offer);
    void decide(Choice choice);
    void carryOut(const Offer &offer);
    /// Shows what the person is asked about, and asks again.
    void compare(const Offer &offer);
    void tellFindings(const QStringList &sentences, const QList<Offer> &passing);

    const Context m_context;
    station::FileOrders &m_orders;
    files::TransferQueue &m_queue;
    QWidget *m_window;
    QList<Offer> m_offers; ///< Still to be decided about.
    std::optional<Choice> m_forAll;
};

} // namespace pages
