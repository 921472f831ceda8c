// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/dialogs/helpdialog.h"

#include "ui/actioncatalog.h"
#include "ui/pagecatalog.h"
#include "ui/widgets/text.h"
#include "ui/widgets/valuelabel.h"
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>

namespace dialogs {

using robot::Freshness;
using widgets::Lamp;
using widgets::Shown;

namespace {

constexpr int keyWidth = 190;
constexpr int signWidth = 150;

/// Something at the left, and what it means.
QWidget *pairRow(QWidget *left, int leftWidth, const QString &what)
{
    auto *result = new QWidget;
    auto *row = new QHBoxLayout(result);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(ui::space::gap);
    left->setMinimumWidth(leftWidth);
    row->addWidget(left, 0, Qt::AlignTop);
    row->addWidget(widgets::sentence(what, ui::Role::Text2), 1);
    return result;
}

} // namespace

HelpDialog::HelpDialog(int page, QWidget *parent)
    : DialogSheet(parent),
      m_page {page},
      m_search {new QLineEdit},
      m_nothing {widgets::sentence({}, ui::Role::Text2)},
      m_scroll {new QScrollArea}
{
    setObjectName(QStringLiteral("helpDialog"));
    resize(640, 620);
    m_search->setObjectName(QStringLiteral("helpSearch"));
    m_search->setClearButtonEnabled(true);
    m_nothing->setObjectName(QStringLiteral("helpNothing"));
    m_scroll->setObjectName(QStringLiteral("helpScroll"));
    m_scroll->setProperty("reads", true);
    m_scroll->setWidgetResizable(true);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_scroll->setFrameShape(QFrame::NoFrame);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    buttons->button(QDialogButtonBox::Close)->setObjectName(QStringLiteral("closeButton"));
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(ui::space::page, ui::space::page, ui::space::page, ui::space::page);
    column->setSpacing(ui::space::gap);
    column->addWidget(m_search);
    column->addWidget(m_nothing);
    column->addWidget(m_scroll, 1);
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    connect(m_search, &QLineEdit::textChanged, this, &HelpDialog::search);
    make();
}

void HelpDialog::make()
{
    setWindowTitle(tr("Help — %1").arg(ui::title(ui::pageCatalog()[std::size_t(m_page)])));
    m_search->setPlaceholderText(tr("Search in this help"));
    m_search->setAccessibleName(tr("Search in this help"));
    m_nothing->setText(tr("Nothing here has these words."));
    m_scroll->setAccessibleName(tr("Help"));
    m_entries.clear();
    auto *content = new QWidget;
    auto *column = new QVBoxLayout(content);
    column->setContentsMargins(0, 0, ui::space::inside, 0);
    column->setSpacing(6);
    makePage(column);
    makeKeys(column);
    makeSigns(column);
    column->addStretch();
    m_scroll->setWidget(content); // deletes the one before
    search();
}

void HelpDialog::beginSection(QVBoxLayout *column, const QString &title)
{
    m_heading = widgets::text(title, ui::Type::Heading, ui::Role::Text1);
    m_heading->setContentsMargins(0, ui::space::gap, 0, 0);
    column->addWidget(m_heading);
}

void HelpDialog::add(QVBoxLayout *column, QWidget *widget, const QString &text)
{
    column->addWidget(widget);
    m_entries << Entry {m_heading, widget, text};
}

void HelpDialog::addKey(QVBoxLayout *column, const char *keys, const QString &what)
{
    const QString text = ui::shortcutText(keys);
    add(column, pairRow(widgets::text(text, ui::Type::Heading, ui::Role::Text1), keyWidth, what), text + u' ' + what);
}

void HelpDialog::makePage(QVBoxLayout *column)
{
    const ui::PageRow &page = ui::pageCatalog()[std::size_t(m_page)];
    m_heading = widgets::text(ui::title(page), ui::Type::State, ui::Role::Text1);
    m_heading->setObjectName(QStringLiteral("helpTitle"));
    column->addWidget(m_heading);
    for (const QString &sentence : ui::helpOf(page))
        add(column, widgets::sentence(sentence, ui::Role::Text1), sentence);
    if (page.keys.empty())
        return;
    beginSection(column, tr("Keys of this page"));
    for (const ui::PageKey &key : page.keys)
        addKey(column, key.keys, ui::text(key));
}

void HelpDialog::makeKeys(QVBoxLayout *column)
{
    beginSection(column, tr("Keys everywhere"));
    for (const ui::ActionRow &row : ui::actionCatalog()) {
        if (*row.shortcut)
            addKey(column, row.shortcut, ui::text(row));
    }
    addKey(column, "F10", tr("Menu"));
    addKey(column, "Return", tr("Without a connection: connect to the controller on the filled button"));
    beginSection(column, tr("Pages"));
    for (const ui::PageRow &row : ui::pageCatalog())
        addKey(column, row.shortcut, ui::title(row));
}

/// What a person must be able to tell apart on every page.
void HelpDialog::makeSigns(QVBoxLayout *column)
{
    struct Sign {
        Shown shown;
        QString what;
    };
    const QString number = QStringLiteral("1284.575");
    const auto word = [](const QString &text, Lamp lamp) { return Shown {{text, lamp}, Freshness::Live, {}}; };
    const Sign signs[] {
        {word(number, Lamp::None), tr("Live: read within its last three turns.")},
        {{{number, Lamp::None}, Freshness::Stale, tr("Stale")},
            tr("Stale: read once, too long ago. The tool tip says when. It is not what the robot does now.")},
        {widgets::unknown(), tr("Unknown: not read on this connection. It is never shown as 0.")},
        {{{widgets::dash(), Lamp::None}, Freshness::Refused, tr("Refused")},
            tr("Refused: the controller does not tell it. The reason stands on the card or in the tool tip.")},
        {word(tr("on"), Lamp::Filled), tr("A filled square: on, or 1.")},
        {word(tr("off"), Lamp::Hollow), tr("A hollow square: off, or 0.")},
        {word(tr("held"), Lamp::Warning),
            tr("An amber triangle: error, hold, something not allowed or to be looked at.")},
        {word(tr("alarm"), Lamp::Alarm), tr("A red square: an alarm.")},
    };
    beginSection(column, tr("What the signs mean"));
    int index = 0;
    for (const Sign &sign : signs) {
        auto *sample = new widgets::ValueLabel(ui::Type::Body);
        sample->setObjectName(QStringLiteral("sign%1").arg(index++));
        sample->setTitle(tr("Sample"));
        sample->show(sign.shown);
        sample->setMinimumHeight(22);
        add(column, pairRow(sample, signWidth, sign.what), sign.what);
    }
    const QString amber = tr("An amber ground in a table: typed and staged, not sent yet. A red one: it reads back "
                             "differently from what was written.");
    add(column, widgets::sentence(amber, ui::Role::Text2), amber);
}

/// Entries that have the words stay, and headings that have such entries.
void HelpDialog::search()
{
    const QString words = m_search->text().trimmed();
    QList<QWidget *> found;
    for (const Entry &entry : m_entries) {
        const bool isFound = entry.text.contains(words, Qt::CaseInsensitive);
        entry.widget->setVisible(isFound);
        if (isFound)
            found << entry.heading;
    }
    for (const Entry &entry : m_entries)
        entry.heading->setVisible(found.contains(entry.heading));
    m_nothing->setVisible(found.isEmpty());
}

} // namespace dialogs
