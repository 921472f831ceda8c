// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/widgets/dialogsheet.h"
#include <QList>

class QLabel;
class QLineEdit;
class QScrollArea;
class QVBoxLayout;

namespace dialogs {

/// F1: what the page in view shows and means, every key that does something, and the signs of the window, drawn by the
/// widgets that draw them everywhere. Made from the catalogues. Not modal; deletes itself when closed.
class HelpDialog : public widgets::DialogSheet
{
    Q_OBJECT

public:
    /// `page` is a row of the page catalogue.
    explicit HelpDialog(int page, QWidget *parent = nullptr);

    [[nodiscard]] int page() const { return m_page; }

private:
    /// Something that the search shows or hides.
    struct Entry {
        QWidget *heading;
        QWidget *widget;
        QString text;
    };

    void make();
    void makePage(QVBoxLayout *column);
    void makeKeys(QVBoxLayout *column);
    void makeSigns(QVBoxLayout *column);
    void beginSection(QVBoxLayout *column, const QString &title);
    void add(QVBoxLayout *column, QWidget *widget, const QString &text);
    void addKey(QVBoxLayout *column, const char *keys, const QString &what);
    void search();

    int m_page;
    QLineEdit *m_search;
    QLabel *m_nothing;
    QScrollArea *m_scroll;
    QWidget *m_heading = nullptr; ///< Of the section that is being made.
    QList<Entry> m_entries;
};

} // namespace dialogs
