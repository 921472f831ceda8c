// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/widgets/conditionlist.h"

#include "ui/conditionwords.h"
#include "ui/widgets/line.h"
#include "ui/widgets/text.h"
#include <QGridLayout>

namespace widgets {

using robot::Verdict;

namespace {

QString markOf(Verdict verdict)
{
    switch (verdict) {
    case Verdict::Met: return QStringLiteral("✓");
    case Verdict::NotMet: return QStringLiteral("✗");
    case Verdict::Unread: return QStringLiteral("…");
    case Verdict::Unreadable: return QStringLiteral("?");
    }
    return {};
}

} // namespace

ConditionList::ConditionList(robot::Orders &orders, robot::Act act, QWidget *parent)
    : QWidget(parent), m_orders {orders}, m_act {act}
{
    auto *grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(2);
    grid->setColumnStretch(1, 1);
    for (qsizetype i = 0; i < orders.findings(act).size(); ++i)
        addRow();
    connect(&orders, &robot::Orders::situationChanged, this, &ConditionList::showFindings);
    showFindings();
}

void ConditionList::addRow()
{
    const int index = int(m_rows.size());
    const Row row {text({}, ui::Type::Body, ui::Role::Text1), new Line(ui::Role::Text1, ui::Type::Body),
        sentence({}, ui::Role::Text2)};
    keepRoom(row.remedy);
    row.words->setObjectName(QStringLiteral("condition%1").arg(index));
    row.remedy->setObjectName(QStringLiteral("remedy%1").arg(index));
    auto *grid = static_cast<QGridLayout *>(layout());
    grid->addWidget(row.mark, 2 * index, 0, Qt::AlignTop);
    grid->addWidget(row.words, 2 * index, 1);
    grid->addWidget(row.remedy, 2 * index + 1, 1);
    m_rows << row;
}

void ConditionList::showFindings()
{
    const auto findings = m_orders.findings(m_act);
    for (qsizetype i = 0; i < m_rows.size(); ++i)
        showFinding(m_rows[i], findings[i]);
}

void ConditionList::showFinding(const Row &row, const robot::Finding &finding) const
{
    const bool isWrong = finding.verdict == Verdict::NotMet;
    const bool isKnown = isWrong || finding.verdict == Verdict::Met;
    const QString title = isWrong ? ui::complaint(finding.condition) : ui::title(finding.condition);
    const QString words = isKnown ? title : tr("%1 — %2").arg(title, ui::word(finding.verdict));
    row.mark->setText(markOf(finding.verdict));
    row.words->setWords(words);
    row.words->setAccessibleName(tr("%1: %2").arg(title, ui::word(finding.verdict)));
    row.remedy->setText(ui::remedy(finding.condition, m_orders.controller().profile().model));
    row.remedy->setVisible(isWrong);
    setTextRole(row.mark, isWrong ? ui::Role::Amber : ui::Role::Text1);
    row.words->setRole(isWrong ? ui::Role::Amber : isKnown ? ui::Role::Text1 : ui::Role::Text2);
}

} // namespace widgets
