// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/pages/page.h"

namespace pages {

/// What a person changes at the controller without a file of this computer: texts edited here, files deleted there.
class RemoteChanges : public QObject
{
    Q_OBJECT

public:
    /// All of them must outlive it; boxes open above `window`.
    RemoteChanges(const Context &context, QWidget *window);

    /// Opens the text of a file; what is changed is compared before it is sent.
    void edit(const values::FileName &name);
    /// Names the files and asks; a copy of each goes into `folderOfCopies` before it is deleted.
    void remove(const QList<values::FileName> &names, const QString &folderOfCopies);

private:
    void openEditor(const values::FileName &name, const QByteArray &content);
    void compareAndSend(
        const values::FileName &name, const QByteArray &older, const QByteArray &newer, QWidget *editor);
    void removeNow(const QList<values::FileName> &names, const QString &folderOfCopies);

    const Context m_context;
    station::FileOrders &m_orders;
    files::TransferQueue &m_queue;
    QWidget *m_window;
};

} // namespace pages
