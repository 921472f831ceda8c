// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/widgets/question.h"

#include "ui/widgets/text.h"
#include <QFormLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>

namespace widgets {

namespace {

constexpr int leastWidth = 460;
constexpr int tallText = 320; ///< Longer text scrolls.

QPushButton *button(const QString &text, const char *name)
{
    auto *result = new QPushButton(text);
    result->setObjectName(QLatin1String(name));
    return result;
}

/// The label itself, or an area in which it scrolls.
QWidget *room(QLabel *label)
{
    if (label->heightForWidth(leastWidth) <= tallText)
        return label;
    auto *scroll = new QScrollArea;
    scroll->setProperty("reads", true);
    scroll->setWidget(label);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setMinimumHeight(tallText);
    return scroll;
}

} // namespace

Question::Question(
    const char *name, const QString &title, const QString &text, const QList<Answer> &answers, QWidget *owner)
    : DialogSheet(owner)
{
    setObjectName(QLatin1String(name));
    setWindowTitle(title);
    setMinimumWidth(leastWidth);
    auto *words = sentence(text, ui::Role::Text1);
    words->setObjectName(QStringLiteral("questionText"));
    words->setTextFormat(Qt::PlainText);
    words->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto *row = new QHBoxLayout;
    row->addStretch();
    for (const Answer &answer : answers)
        addAnswer(row, answer);
    auto *cancel = button(answers.isEmpty() ? tr("Close") : tr("Cancel"), "cancelButton");
    cancel->setDefault(true);
    row->addWidget(cancel);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(ui::space::page, ui::space::page, ui::space::page, ui::space::page);
    column->setSpacing(ui::space::page);
    column->addWidget(room(words));
    column->addLayout(row);
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
    cancel->setFocus();
}

void Question::addAnswer(QHBoxLayout *row, const Answer &answer)
{
    auto *result = button(answer.text, answer.name);
    result->setAutoDefault(false);
    if (answer.writes)
        writing(result);
    row->addWidget(result);
    connect(result, &QPushButton::clicked, this, [this, then = answer.then] {
        if (isAnswered())
            return;
        accept();
        then();
    });
}

void ask(const char *name, const QString &title, const QString &text, const QList<Answer> &answers, QWidget *owner)
{
    (new Question(name, title, text, answers, owner))->show();
}

void askForLine(const char *name, const QString &title, const QString &label, QWidget *owner,
    const std::function<void(const QString &line)> &then)
{
    auto *sheet = new DialogSheet(owner);
    sheet->setObjectName(QLatin1String(name));
    sheet->setWindowTitle(title);
    auto *line = new QLineEdit;
    line->setObjectName(QStringLiteral("line"));
    auto *ok = button(Question::tr("OK"), "okButton");
    auto *cancel = button(Question::tr("Cancel"), "cancelButton");
    cancel->setAutoDefault(false);
    ok->setDefault(true);
    ok->setEnabled(false);
    auto *row = new QHBoxLayout;
    row->addStretch();
    row->addWidget(ok);
    row->addWidget(cancel);
    auto *form = new QFormLayout(sheet);
    form->setContentsMargins(ui::space::page, ui::space::page, ui::space::page, ui::space::page);
    form->addRow(label, line);
    form->addRow(row);
    line->setFocus();
    QObject::connect(
        line, &QLineEdit::textChanged, ok, [ok](const QString &text) { ok->setEnabled(!text.trimmed().isEmpty()); });
    QObject::connect(cancel, &QPushButton::clicked, sheet, &QDialog::reject);
    QObject::connect(ok, &QPushButton::clicked, sheet, [sheet, line, then] {
        const QString text = line->text().trimmed();
        sheet->accept();
        then(text);
    });
    sheet->show();
}

} // namespace widgets
