// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/files/remotechanges.h"

#include "ui/dialogs/comparedialog.h"
#include "ui/dialogs/jobeditor.h"
#include "ui/pages/files/remotefile.h"
#include "ui/widgets/question.h"
#include <QDir>

using values::FileName;

namespace pages {

RemoteChanges::RemoteChanges(const Context &context, QWidget *window)
    : m_context {context}, m_orders {context.station.fileOrders}, m_queue {context.station.transfers}, m_window {window}
{
}

void RemoteChanges::edit(const FileName &name)
{
    readRemote(m_context, name, m_window, [this, name](const QByteArray &content) { openEditor(name, content); });
}

void RemoteChanges::openEditor(const FileName &name, const QByteArray &content)
{
    auto *editor =
        new dialogs::JobEditor(name, content, protocol::TextCodec {m_context.station.profile().encoding}, m_window);
    connect(editor, &dialogs::JobEditor::sendRequested, this,
        [this, editor, name, content](const QByteArray &edited) { compareAndSend(name, content, edited, editor); });
    editor->show();
}

void RemoteChanges::compareAndSend(
    const FileName &name, const QByteArray &older, const QByteArray &newer, QWidget *editor)
{
    const protocol::TextCodec codec {m_context.station.profile().encoding};
    const bool mayChange = older != newer && !m_context.station.orders.obstacle(robot::Act::Upload);
    const QString title = tr("What changes in “%1” on %2").arg(text(m_context, name), m_context.station.profile().name);
    auto *dialog = new dialogs::CompareDialog(title, older, newer, codec, mayChange ? tr("Send") : QString(), editor);
    connect(dialog, &QDialog::accepted, this, [this, name, newer, editor] {
        if (auto task = m_orders.upload(name, newer))
            m_queue.add(std::move(task));
        editor->close();
    });
    dialog->show();
}

void RemoteChanges::remove(const QList<FileName> &names, const QString &folderOfCopies)
{
    QStringList words;
    for (const FileName &name : names)
        words << text(m_context, name);
    const QString text = tr("These files are deleted on %1:\n%2\nBefore that each is copied to %3.");
    widgets::ask("deleteFiles", tr("Delete on %1").arg(m_context.station.profile().name),
        text.arg(m_context.station.profile().name, words.join(u'\n'), QDir::toNativeSeparators(folderOfCopies)),
        {{"confirmDelete", tr("Delete %n file(s)", nullptr, int(names.size())),
            [this, names, folderOfCopies] { removeNow(names, folderOfCopies); }}},
        m_window);
}

void RemoteChanges::removeNow(const QList<FileName> &names, const QString &folderOfCopies)
{
    for (const FileName &name : names) {
        if (auto task = m_orders.remove(name, folderOfCopies))
            m_queue.add(std::move(task));
    }
}

} // namespace pages
