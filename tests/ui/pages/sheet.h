// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/models/variablemodel.h"
#include "ui/room.h"
#include "ui/widgets/table.h"
#include <QLineEdit>
#include <QTabBar>

/// The window on its variables page.
struct Sheet : Room {
    explicit Sheet(const char *pageId = "variables") : Room {pageId} { }

    [[nodiscard]] bool isLive() const override { return text(3) != u"—"; }
    [[nodiscard]] widgets::Table *table() const { return find<widgets::Table>("variableTable"); }
    [[nodiscard]] QTabBar *tabs() const { return find<QTabBar>("tabs"); }
    [[nodiscard]] QString text(int row, int column = models::VariableModel::Value) const
    {
        return table()->model()->index(row, column).data().toString();
    }
    /// Every row in view is live, or was refused.
    [[nodiscard]] bool isSettled() const
    {
        return std::ranges::all_of(page->topics(), [this](const robot::TopicRange &range) {
            const auto freshness = harness.state().freshness({range.kind, range.first});
            return freshness == robot::Freshness::Live || freshness == robot::Freshness::Refused;
        });
    }
    void select(int row) const
    {
        table()->setFocus();
        table()->setCurrentIndex(table()->model()->index(row, models::VariableModel::Value));
    }
    /// Types a value into a row, and Enter.
    void type(int row, const QString &words) const
    {
        select(row);
        QTest::keyClick(table(), Qt::Key_Return);
        const auto editors = table()->findChildren<QLineEdit *>(QStringLiteral("cellEditor"));
        if (editors.isEmpty())
            return;
        QLineEdit *editor = editors.last(); // the one before may not be gone yet
        editor->selectAll();
        QTest::keyClicks(editor, words);
        QTest::keyClick(editor, Qt::Key_Return);
        QCoreApplication::processEvents(); // the view takes it from the event loop
    }
    [[nodiscard]] bool apply() const
    {
        click("write-variable");
        QDialog *box = dialog("applyDialog");
        if (!box)
            return false;
        QTest::mouseClick(box->findChild<QPushButton *>(QStringLiteral("applyConfirm")), Qt::LeftButton);
        return true;
    }
};
