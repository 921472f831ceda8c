// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/alarmnotes.h"

#include "ui/alarmwords.h"
#include "ui/widgets/tabletools.h"
#include "ui/widgets/text.h"
#include <QGridLayout>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSpinBox>

namespace pages {

namespace {

constexpr int highestCode = 9999; ///< Reference §3.1.

QString userName() { return qEnvironmentVariable("USER", qEnvironmentVariable("USERNAME")); }

QLabel *titleOf(QWidget *widget, const QString &words)
{
    QLabel *label = widgets::text(words, ui::Type::Label, ui::Role::Text2);
    label->setBuddy(widget);
    widget->setAccessibleName(words);
    return label;
}

} // namespace

AlarmNotes::AlarmNotes(journal::Store &store, QWidget *parent)
    : QWidget(parent),
      m_store {store},
      m_list {new QListWidget},
      m_codeBox {new QSpinBox},
      m_cause {new QPlainTextEdit},
      m_remedy {new QPlainTextEdit},
      m_by {widgets::text({}, ui::Type::Label, ui::Role::Text2)},
      m_save {new QPushButton(tr("Save note"))},
      m_export {new QPushButton(tr("Export notes…"))}
{
    m_list->setObjectName(QStringLiteral("noteList"));
    m_codeBox->setObjectName(QStringLiteral("noteCode"));
    m_cause->setObjectName(QStringLiteral("noteCause"));
    m_remedy->setObjectName(QStringLiteral("noteRemedy"));
    m_by->setObjectName(QStringLiteral("noteBy"));
    m_save->setObjectName(QStringLiteral("saveNote"));
    m_export->setObjectName(QStringLiteral("exportNotes"));
    m_codeBox->setRange(1, highestCode);
    m_cause->setTabChangesFocus(true);
    m_remedy->setTabChangesFocus(true);
    lay();
    connect(m_codeBox, &QSpinBox::valueChanged, this, [this](int code) { chooseCode(quint32(code)); });
    connect(m_list, &QListWidget::currentItemChanged, this, [this](const QListWidgetItem *item) {
        if (item)
            chooseCode(item->data(Qt::UserRole).toUInt());
    });
    connect(m_cause, &QPlainTextEdit::textChanged, this, &AlarmNotes::showChanged);
    connect(m_remedy, &QPlainTextEdit::textChanged, this, &AlarmNotes::showChanged);
    connect(m_save, &QPushButton::clicked, this, &AlarmNotes::save);
    connect(m_export, &QPushButton::clicked, this, [this] {
        const auto write = [this](const QString &path, journal::Format format) {
            m_store.exportNotes(path, format, this, [this](const values::Result<qint64> &count) {
                m_by->setText(count ? tr("%n note(s) exported.", nullptr, int(*count))
                                    : tr("Not exported: %1.").arg(count.error().detail));
            });
        };
        widgets::askForFile(this, tr("Export notes"), QStringLiteral("alarm-notes.csv"), write);
    });
    showNote();
    load();
}

/// What was typed and not saved is saved.
AlarmNotes::~AlarmNotes()
{
    if (isEdited())
        save();
}

void AlarmNotes::lay()
{
    auto *grid = new QGridLayout(this);
    grid->setContentsMargins(0, 10, 0, 0);
    grid->setColumnStretch(0, 1);
    grid->setColumnStretch(1, 2);
    grid->setColumnStretch(2, 2);
    grid->addWidget(titleOf(m_list, tr("Codes with a note")), 0, 0);
    grid->addWidget(m_list, 1, 0, 3, 1);
    auto *row = new QHBoxLayout;
    row->addWidget(titleOf(m_codeBox, tr("Alarm code")));
    row->addWidget(m_codeBox);
    row->addWidget(m_by, 1);
    row->addWidget(m_save);
    row->addWidget(m_export);
    grid->addLayout(row, 0, 1, 1, 2);
    grid->addWidget(titleOf(m_cause, tr("Cause")), 1, 1);
    grid->addWidget(m_cause, 2, 1);
    grid->addWidget(titleOf(m_remedy, tr("What we did")), 1, 2);
    grid->addWidget(m_remedy, 2, 2);
    grid->setRowStretch(2, 1);
}

void AlarmNotes::load()
{
    m_store.notes(this, [this](const values::Result<QList<journal::Note>> &notes) {
        if (!notes)
            return m_by->setText(tr("The notes cannot be read: %1.").arg(notes.error().detail));
        const bool wasEdited = isEdited(); // before the journal answered
        for (const journal::Note &note : *notes)
            m_notes.insert(note.code, note);
        fillList();
        if (!wasEdited)
            showNote();
        Q_EMIT changed();
    });
}

void AlarmNotes::chooseCode(quint32 code)
{
    if (code == m_code || code < 1 || code > highestCode)
        return;
    if (isEdited())
        save();
    m_code = code;
    showNote();
}

void AlarmNotes::showNote()
{
    const journal::Note shown = note(m_code);
    const QSignalBlocker noEcho(m_codeBox);
    m_codeBox->setValue(int(m_code));
    m_cause->setPlainText(shown.cause);
    m_remedy->setPlainText(shown.remedy);
    m_by->setText(shown.isEmpty() ? tr("No note yet.")
                                  : tr("Last changed by %1, %2.").arg(shown.author, ui::tableTime(shown.changed)));
    showChanged();
}

bool AlarmNotes::isEdited() const
{
    const journal::Note kept = note(m_code);
    return m_cause->toPlainText() != kept.cause || m_remedy->toPlainText() != kept.remedy;
}

void AlarmNotes::showChanged() { m_save->setEnabled(isEdited()); }

void AlarmNotes::save()
{
    const journal::Note edited {
        m_code, m_cause->toPlainText(), m_remedy->toPlainText(), userName(), QDateTime::currentDateTimeUtc()};
    m_store.keep(edited);
    if (edited.isEmpty())
        m_notes.remove(m_code);
    else
        m_notes.insert(m_code, edited);
    fillList();
    showNote();
    Q_EMIT changed();
}

void AlarmNotes::fillList()
{
    const QSignalBlocker noEcho(m_list);
    m_list->clear();
    for (const journal::Note &note : std::as_const(m_notes)) {
        const QString words = note.cause.isEmpty() ? note.remedy : note.cause;
        auto *item = new QListWidgetItem(QStringLiteral("%1  %2").arg(note.code).arg(words.simplified()), m_list);
        item->setData(Qt::UserRole, note.code);
    }
}

} // namespace pages
