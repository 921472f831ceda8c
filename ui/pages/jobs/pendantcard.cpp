// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/jobs/pendantcard.h"

#include "protocol/text.h"
#include <QLineEdit>
#include <QLocale>

namespace pages {

using robot::Act;
using values::PendantText;

PendantCard::PendantCard(const Context &context, QWidget *parent)
    : OrderCard(context, tr("Pendant"), parent),
      m_text {new QLineEdit},
      m_counter {widgets::text({}, ui::Type::Label, ui::Role::Text2)},
      m_lock {widgets::sentence({}, ui::Role::Text2)}
{
    m_text->setObjectName(QStringLiteral("pendantText"));
    m_text->setAccessibleName(tr("Message for the pendant"));
    m_text->setPlaceholderText(tr("Message for the pendant"));
    m_counter->setObjectName(QStringLiteral("pendantBytes"));
    m_lock->setObjectName(QStringLiteral("lockState"));
    body()->addWidget(m_text);
    body()->addWidget(m_counter);
    m_show = addButton(Act::ShowPendantText);
    m_show->setText(tr("Show on the pendant"));
    body()->addSpacing(6);
    body()->addWidget(m_lock);
    m_lockOn = addButton(Act::HlockOn);
    m_lockOff = addButton(Act::HlockOff);
    connect(m_text, &QLineEdit::textChanged, this, &PendantCard::onEdited);
    connect(m_show, &widgets::OrderButton::clicked, this, &PendantCard::showText);
    connect(m_lockOn, &widgets::OrderButton::clicked, this,
        [this] { order(m_lockOn, protocol::HlockOn {}, {Act::HlockOn}); });
    connect(m_lockOff, &widgets::OrderButton::clicked, this,
        [this] { order(m_lockOff, protocol::HlockOff {}, {Act::HlockOff}); });
    connect(&m_orders, &robot::Orders::pendantLockChanged, this, &PendantCard::showLock);
    onEdited();
    showLock();
}

void PendantCard::onEdited()
{
    const auto bytes = protocol::TextCodec(m_profile.encoding).encode(m_text->text());
    const qsizetype count = bytes ? bytes->size() : 0;
    m_counter->setText(tr("%1 of %n byte(s)", nullptr, int(PendantText::maxBytes)).arg(QLocale().toString(count)));
    if (m_text->text().isEmpty())
        m_show->setComplaint(tr("Type a message first."));
    else if (!bytes)
        m_show->setComplaint(tr("The controller's encoding cannot hold this: %1.").arg(bytes.error().detail));
    else
        m_show->setComplaint(
            count > PendantText::maxBytes ? tr("The message is too long for the pendant.") : QString());
}

void PendantCard::showText()
{
    const auto bytes = protocol::TextCodec(m_profile.encoding).encode(m_text->text());
    const auto message = bytes.and_then([](const QByteArray &encoded) { return PendantText::create(encoded); });
    if (message)
        order(m_show, protocol::ShowPendantText {*message}, {Act::ShowPendantText, {}, {}, m_text->text()});
}

void PendantCard::showLock()
{
    m_lock->setText(m_orders.isPendantLocked()
            ? tr("HLOCK was switched on from here: the pendant is locked out, but for its emergency stop.")
            : tr("HLOCK locks the pendant out. Whether it is on cannot be read over HSES; from here it was not "
                 "switched on."));
}

} // namespace pages
