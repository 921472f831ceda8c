// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/widgets/card.h"
#include <QHash>

class QHBoxLayout;
class QLabel;
class QListWidget;

namespace pages {

/// One of the two panes: a list of file names of which several can be chosen and dragged to the other pane. Which files
/// those are only its owner knows.
class FilePane : public widgets::Card
{
    Q_OBJECT

public:
    /// `name` becomes the objectName of the list.
    FilePane(const QString &title, const QString &name, QWidget *parent = nullptr);

    /// A place for what belongs above the list.
    [[nodiscard]] QHBoxLayout *tools() const { return m_tools; }
    /// Shows these files by key; those that were there before stay, with selection and scroll. `words` is what a person
    /// reads, in the same order.
    void showFiles(const QList<QByteArray> &keys, const QStringList &words);
    /// A sentence under the title instead of a list that cannot be had; empty takes it away.
    void setStale(bool isStale);
    [[nodiscard]] QList<QByteArray> chosen() const;

Q_SIGNALS:
    void chosenChanged();
    void activated(const QByteArray &key);
    /// Files of the other pane were dropped here.
    void dropped();

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    QHBoxLayout *m_tools;
    QListWidget *m_list;
};

} // namespace pages
