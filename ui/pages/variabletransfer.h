// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "disk/worker.h"
#include "ui/models/variablemodel.h"
#include <QTimer>

namespace robot {
class Orders;
}

namespace pages {

/// Values in and out of a table of variables: clipboard and CSV. What it needs to know and is not live is read first;
/// what the controller refuses, and everything while there is no link, stays as it was seen last. It stages, and never
/// writes.
class VariableTransfer : public QObject
{
    Q_OBJECT

public:
    /// All of it must outlive the transfer; dialogs open over `window`.
    VariableTransfer(const models::VariableDesk &desk, const robot::Orders &orders, QWidget *window);

    void copy(const QList<variables::Reference> &variables) const;
    /// What stands in the clipboard, from `first` on unless it names its variables.
    void paste(const variables::Reference &first);
    /// CSV, with a preview of the differences.
    void importFrom(const QString &path);
    /// CSV with all that could be read; the cell of a variable that could not be read is empty.
    void exportTo(const QString &path, const QList<variables::Reference> &variables);

    /// What must be read now: nothing but while it is at work.
    [[nodiscard]] QList<robot::TopicRange> topics() const;

Q_SIGNALS:
    void topicsChanged();
    /// Something to tell a person; empty takes it back.
    void said(const QString &sentence, bool isTrouble);

private:
    using Reading = std::function<variables::Preview(const variables::Lookup &)>;

    void preview(const Reading &reading);
    void openPreview(const variables::Preview &preview);
    void write(const QString &path, const QList<variables::Reference> &variables);
    void readFirst(const QList<variables::Reference> &variables, const std::function<void()> &goOn);
    void look();
    void goOn();
    [[nodiscard]] bool isKnown(const variables::Reference &variable) const;
    [[nodiscard]] std::optional<variables::Value> now(const variables::Reference &variable) const;

    models::VariableDesk m_desk;
    const robot::Orders &m_orders;
    QWidget *m_window;
    QList<variables::Reference> m_wanted; ///< Of them, some are not known yet.
    std::function<void()> m_next; ///< Once they are.
    QTimer m_patience;
    disk::Worker m_disk;
};

} // namespace pages
