// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/dialogs/numberingdialog.h"

#include "protocol/codes.h"
#include "ui/widgets/text.h"
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QPushButton>
#include <QSpinBox>
#include <functional>

namespace dialogs {

using robot::NumberingVerdict;
using values::ByteVariable;
using values::Result;

namespace {

constexpr int firstInstance = 1; ///< Both numberings have the instances 1 to 98.
constexpr int instanceCount = 98;

QSpinBox *spin(const QString &name, const QString &title, int least, int most)
{
    auto *box = new QSpinBox;
    box->setObjectName(name);
    box->setAccessibleName(title);
    box->setRange(least, most);
    return box;
}

} // namespace

NumberingDialog::NumberingDialog(robot::Orders &orders, QWidget *parent)
    : DialogSheet(parent), m_orders {orders}, m_sentence {widgets::sentence({}, ui::Role::Text2)}
{
    setObjectName(QStringLiteral("numberingDialog"));
    setWindowTitle(tr("Variable numbering — %1").arg(orders.controller().profile().name));
    setMinimumWidth(560);
    m_sentence->setObjectName(QStringLiteral("sentence"));
    auto *grid = new QGridLayout;
    for (int i = 0; i < 2; ++i) {
        const auto at = std::size_t(i);
        m_numbers[at] = spin(QStringLiteral("number%1").arg(i + 1), tr("Number of the variable"), 1, 97);
        m_numbers[at]->setPrefix(QStringLiteral("B"));
        m_values[at] = spin(QStringLiteral("value%1").arg(i + 1), tr("Value on the pendant"), -1, 255);
        m_values[at]->setSpecialValueText(tr("not read yet"));
        m_values[at]->setValue(-1);
        grid->addWidget(m_numbers[at], i, 0);
        grid->addWidget(widgets::text(tr("reads on the pendant"), ui::Type::Body, ui::Role::Text2), i, 1);
        grid->addWidget(m_values[at], i, 2);
    }
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    buttons->button(QDialogButtonBox::Close)->setObjectName(QStringLiteral("closeButton"));
    m_compare = buttons->addButton(tr("Compare"), QDialogButtonBox::ActionRole);
    m_compare->setObjectName(QStringLiteral("compareButton"));
    m_accept = buttons->addButton(tr("Keep the result"), QDialogButtonBox::ActionRole);
    m_accept->setObjectName(QStringLiteral("keepButton"));
    m_accept->setProperty("primary", true);
    m_accept->setEnabled(false);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(ui::space::page, ui::space::page, ui::space::page, ui::space::page);
    column->setSpacing(ui::space::gap);
    column->addWidget(widgets::text(tr("Which number is which?"), ui::Type::State, ui::Role::Text1));
    column->addWidget(widgets::sentence(
        tr("Parameter RS022 decides whether B000 is number 0 or number 1 on the network. Until that is known, a write "
           "could hit the neighbour, so none is sent. Read two variables on the pendant (main menu, VARIABLE, BYTE) "
           "and "
           "enter what you see. This test only reads."),
        ui::Role::Text2));
    column->addLayout(grid);
    column->addWidget(m_sentence);
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    connect(m_compare, &QPushButton::clicked, this, [this] { read(&NumberingDialog::judge); });
    connect(m_accept, &QPushButton::clicked, this, [this] {
        if (m_result)
            Q_EMIT verified(*m_result);
        close();
    });
    read(&NumberingDialog::propose);
}

void NumberingDialog::say(const QString &sentence, bool isTrouble)
{
    m_sentence->setText(sentence);
    widgets::setTextRole(m_sentence, isTrouble ? ui::Role::Amber : ui::Role::Text2);
}

/// Each time anew: they may have changed since.
void NumberingDialog::read(void (NumberingDialog::*then)())
{
    const auto request = protocol::ReadItems<ByteVariable>::create(firstInstance, instanceCount);
    Q_ASSERT(request);
    m_orders.read(*request, this, [this, then](const Result<QList<ByteVariable>> &instances) {
        if (!instances)
            return say(tr("The variables could not be read: %1.").arg(protocol::explain(instances.error())), true);
        m_instances = *instances;
        std::invoke(then, this);
    });
}

/// Variables whose neighbours hold something else: others prove nothing.
void NumberingDialog::propose()
{
    const auto numbers = robot::tellingNumbers(m_instances, firstInstance, 2);
    if (numbers.isEmpty())
        return say(
            tr("All B variables hold the same value, which proves nothing: let a job or the pendant set B010 to 1 "
               "and B011 to 2, then open this test again."),
            true);
    m_numbers[0]->setValue(numbers.first());
    m_numbers[1]->setValue(numbers.last() == numbers.first() ? numbers.first() + 1 : numbers.last());
    say(tr("These two tell the numberings apart."), false);
}

void NumberingDialog::judge()
{
    QList<robot::PendantValue> pendant;
    for (std::size_t i = 0; i < 2; ++i)
        pendant << robot::PendantValue {m_numbers[i]->value(), m_values[i]->value()};
    m_result.reset();
    switch (robot::judgeNumbering(pendant, m_instances, firstInstance)) {
    case NumberingVerdict::FromZero:
        m_result = protocol::Numbering::FromZero;
        say(tr("Verified: number 0 on the network is B000."), false);
        break;
    case NumberingVerdict::FromOne:
        m_result = protocol::Numbering::FromOne;
        say(tr("Verified, shifted: number 1 on the network is B000."), false);
        break;
    case NumberingVerdict::Ambiguous:
        say(tr("Both numberings fit these values: choose variables whose neighbours hold other values."), true);
        break;
    case NumberingVerdict::Neither:
        say(tr("Neither numbering fits: read the values again, they may have changed."), true);
        break;
    }
    m_accept->setEnabled(m_result.has_value());
}

} // namespace dialogs
