// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/variabletransfer.h"

#include "disk/durable.h"
#include "ui/dialogs/importdialog.h"
#include <QClipboard>
#include <QGuiApplication>

using namespace std::chrono_literals;

namespace pages {

using robot::Freshness;
using variables::Lookup;
using variables::Reference;

namespace {

constexpr auto patience = 15s; ///< Then it goes on with what is known.

} // namespace

VariableTransfer::VariableTransfer(const models::VariableDesk &desk, const robot::Orders &orders, QWidget *window)
    : QObject(window), m_desk {desk}, m_orders {orders}, m_window {window}
{
    m_patience.setSingleShot(true);
    connect(&m_patience, &QTimer::timeout, this, &VariableTransfer::goOn);
    connect(&orders, &robot::Orders::situationChanged, this, &VariableTransfer::look);
    connect(&m_desk.history, &robot::VariableHistory::changed, this, &VariableTransfer::look);
}

void VariableTransfer::copy(const QList<Reference> &variables) const
{
    QString text;
    for (const Reference &variable : variables) {
        const auto value = now(variable);
        text += variables::csvLine({toString(variable), value ? toText(*value, m_desk.format) : QString()}, u'\t');
    }
    QGuiApplication::clipboard()->setText(text);
}

void VariableTransfer::paste(const Reference &first)
{
    preview([this, text = QGuiApplication::clipboard()->text(), first](const Lookup &now) {
        return variables::previewBlock(text, first, m_desk.format, m_desk.dialect, now);
    });
}

void VariableTransfer::importFrom(const QString &path)
{
    const auto read = [path] {
        return disk::readFile(path).and_then(variables::textOfFile).and_then(variables::readTable);
    };
    m_disk.run(this, read, [this](const values::Result<variables::Table> &table) {
        if (!table && table.error().kind == values::ErrorKind::LocalFile)
            return Q_EMIT said(tr("The file cannot be read: %1").arg(table.error().detail), true);
        if (!table)
            return Q_EMIT said(table.error().detail, true);
        preview([this, table = *table](
                    const Lookup &now) { return variables::preview(table, m_desk.format, m_desk.dialect, now); });
    });
}

/// Reads the text twice: to learn which variables it names, and once these are known.
void VariableTransfer::preview(const Reading &reading)
{
    QList<Reference> named;
    (void)reading([&](const Reference &variable) {
        named << variable;
        return now(variable);
    });
    readFirst(
        named, [this, reading] { openPreview(reading([this](const Reference &variable) { return now(variable); })); });
}

void VariableTransfer::openPreview(const variables::Preview &preview)
{
    const QString controller = m_orders.controller().profile().name;
    auto *dialog = new dialogs::ImportDialog(preview, controller, m_desk.format, m_window);
    connect(dialog, &dialogs::ImportDialog::differencesAccepted, this,
        [this](const QList<variables::Difference> &differences) { m_desk.edits.stage(differences); });
    dialog->show();
}

void VariableTransfer::exportTo(const QString &path, const QList<Reference> &variables)
{
    readFirst(variables, [this, path, variables] { write(path, variables); });
}

void VariableTransfer::write(const QString &path, const QList<Reference> &variables)
{
    QList<variables::ExportRow> rows;
    for (const Reference &variable : variables)
        rows << variables::ExportRow {variable, m_desk.book.names().of(variable).text, now(variable)};
    const QByteArray csv = "\xEF\xBB\xBF" + toCsv(rows, m_desk.format).toUtf8();
    m_disk.run(
        this, [path, csv] { return disk::replaceFile(path, csv); },
        [this, path](const values::Result<void> &written) {
            Q_EMIT said(written ? tr("%1 was written.").arg(path)
                                : tr("The file could not be written: %1").arg(written.error().detail),
                !written);
        });
}

QList<robot::TopicRange> VariableTransfer::topics() const
{
    QList<robot::TopicRange> result;
    for (const Reference &variable : m_wanted)
        result << robot::TopicRange {robot::topicOf(variable)};
    return result;
}

void VariableTransfer::readFirst(const QList<Reference> &variables, const std::function<void()> &goOn)
{
    m_wanted = variables;
    m_next = goOn;
    m_patience.start(patience);
    Q_EMIT said(tr("Reading %n variable(s)…", nullptr, int(variables.size())), false);
    Q_EMIT topicsChanged();
    look();
}

void VariableTransfer::look()
{
    const auto known = [this](const Reference &variable) { return isKnown(variable); };
    if (m_next && (!m_orders.situation().isLinkUp || std::ranges::all_of(m_wanted, known)))
        goOn();
}

void VariableTransfer::goOn()
{
    m_patience.stop();
    m_wanted.clear();
    Q_EMIT said({}, false);
    Q_EMIT topicsChanged();
    if (const auto next = std::exchange(m_next, {}))
        next();
}

bool VariableTransfer::isKnown(const Reference &variable) const
{
    const Freshness freshness = readingOf(m_desk.state, variable).freshness;
    return freshness == Freshness::Live || freshness == Freshness::Refused;
}

std::optional<variables::Value> VariableTransfer::now(const Reference &variable) const
{
    return readingOf(m_desk.state, variable).value;
}

} // namespace pages
