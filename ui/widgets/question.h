// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/widgets/dialogsheet.h"
#include <functional>

class QHBoxLayout;
class QLineEdit;
class QVBoxLayout;

namespace widgets {

/// One answer to a Question. `then` runs once, after the sheet is closed.
struct Answer {
    const char *name; ///< Object name of its button.
    QString text;
    std::function<void()> then;
    bool writes = true; ///< See writing().
};

/// A sentence or a few, and the answers to it. There is always one button more that does nothing; it has the focus and
/// is the default: "Cancel", or "Close" where there is nothing to answer. Its object name is "cancelButton".
class Question : public DialogSheet
{
    Q_OBJECT

public:
    /// `name` is the object name. Text is shown as it is, never as markup.
    Question(const char *name, const QString &title, const QString &text, const QList<Answer> &answers, QWidget *owner);

private:
    void addAnswer(QHBoxLayout *row, const Answer &answer);
};

/// Shows a Question, unless the owner has one of that name open.
void ask(const char *name, const QString &title, const QString &text, const QList<Answer> &answers, QWidget *owner);

/// Asks for a line of text. `then` runs once, after the sheet is closed, with text that is not blank.
void askForLine(const char *name, const QString &title, const QString &label, QWidget *owner,
    const std::function<void(const QString &line)> &then);

} // namespace widgets
