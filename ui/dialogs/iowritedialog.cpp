// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/dialogs/iowritedialog.h"

#include "ui/conditionwords.h"
#include "ui/widgets/orderbutton.h"
#include "ui/widgets/shown.h"
#include "ui/widgets/text.h"
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QPushButton>

namespace dialogs {

using robot::IoWrite;

namespace {

/// "■0 □1 …": the eight signals, lowest first as on the page.
QString bits(const std::optional<values::IoGroup> &group)
{
    if (!group)
        return widgets::dash();
    QStringList words;
    for (int bit = 0; bit < names::signalsPerGroup; ++bit)
        words << (group->isOn(bit) ? QStringLiteral("■ 1") : QStringLiteral("□ 0"));
    return words.join(QStringLiteral("   "));
}

} // namespace

IoWriteDialog::IoWriteDialog(robot::Orders &orders, const names::Signal &signal, const QString &name, QWidget *parent)
    : DialogSheet(parent),
      m_model {orders.controller().profile().model},
      m_write {orders, signal},
      m_before {widgets::text({}, ui::Type::Body, ui::Role::Text1)},
      m_after {widgets::text({}, ui::Type::Body, ui::Role::Text1)},
      m_sentence {widgets::sentence({}, ui::Role::Text2)},
      m_button {new widgets::OrderButton(orders, robot::Act::WriteIo)}
{
    setObjectName(QStringLiteral("ioWriteDialog"));
    const QString controller = orders.controller().profile().name;
    setWindowTitle(tr("Write %1 — %2").arg(toString(signal), controller));
    for (QLabel *label : {m_before, m_after}) { // nothing is read yet: room for all eight
        const auto room = [label](quint8 group) {
            return label->fontMetrics().horizontalAdvance(bits(values::IoGroup {group}));
        };
        label->setMinimumWidth(std::max(room(0), room(0xFF)));
    }
    m_before->setObjectName(QStringLiteral("before"));
    m_after->setObjectName(QStringLiteral("after"));
    m_sentence->setObjectName(QStringLiteral("sentence"));
    auto *grid = new QGridLayout;
    grid->setHorizontalSpacing(ui::space::gap);
    grid->addWidget(widgets::text(tr("Now"), ui::Type::Label, ui::Role::Text2), 0, 0);
    grid->addWidget(m_before, 0, 1);
    grid->addWidget(widgets::text(tr("Will be"), ui::Type::Label, ui::Role::Text2), 1, 0);
    grid->addWidget(m_after, 1, 1);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    buttons->button(QDialogButtonBox::Close)->setObjectName(QStringLiteral("closeButton"));
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(ui::space::page, ui::space::page, ui::space::page, ui::space::page);
    column->setSpacing(ui::space::gap);
    column->addWidget(widgets::text(name.isEmpty() ? toString(signal) : tr("%1 · %2").arg(toString(signal), name),
        ui::Type::State, ui::Role::Text1));
    column->addWidget(widgets::sentence(
        tr("The eight signals #%1 to #%2 travel together: all of them are written as they stand here.")
            .arg(toString(names::Signal {signal.group, 0}).sliced(1),
                toString(names::Signal {signal.group, 7}).sliced(1)),
        ui::Role::Amber));
    column->addLayout(grid);
    column->addWidget(m_sentence);
    column->addWidget(m_button);
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    connect(m_button, &widgets::OrderButton::clicked, &m_write, &IoWrite::write);
    connect(&m_write, &IoWrite::changed, this, &IoWriteDialog::showStep);
    m_write.read();
}

QString IoWriteDialog::sentence() const
{
    switch (m_write.step()) {
    case IoWrite::Step::Reading: return tr("The group is being read…");
    case IoWrite::Step::Ready: return tr("Written once, then read back.");
    case IoWrite::Step::Changed: return tr("Another of the eight has changed meanwhile. Nothing was sent: look again.");
    case IoWrite::Step::Writing: return tr("Being written…");
    case IoWrite::Step::Done: return tr("Written, and read back as it was written.");
    case IoWrite::Step::Mismatch:
        return tr("Accepted, but another value was read back: %1. Something else writes these signals.")
            .arg(bits(m_write.readBack()));
    case IoWrite::Step::Refused:
    case IoWrite::Step::Unknown:
    case IoWrite::Step::Failed: return ui::explain(robot::Act::WriteIo, m_write.error(), m_model);
    }
    return {};
}

void IoWriteDialog::showStep()
{
    using enum IoWrite::Step;
    const auto step = m_write.step();
    const bool isReadBack = step == Done || step == Mismatch; // then that is what it is now
    m_before->setText(bits(isReadBack ? m_write.readBack() : m_write.before()));
    m_after->setText(bits(m_write.after()));
    m_sentence->setText(sentence());
    const bool isBad = step == Mismatch || step == Unknown;
    const bool isAmber = step == Changed || step == Refused || step == Failed;
    widgets::setTextRole(m_sentence, isBad ? ui::Role::Alarm : isAmber ? ui::Role::Amber : ui::Role::Text2);
    m_button->setText(m_write.isOn() ? tr("Switch on") : tr("Switch off"));
    m_button->setComplaint(step == Ready || step == Changed ? QString() : m_sentence->text());
}

} // namespace dialogs
