// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/dialogs/ladderview.h"

#include "ui/linkview.h"
#include "ui/widgets/text.h"
#include <QCoreApplication>
#include <QHBoxLayout>

namespace dialogs {

using robot::Rung;

namespace {

struct Look {
    QString mark;
    QString word;
    ui::Role ink;
};

Look look(Rung::Outcome outcome)
{
    switch (outcome) {
    case Rung::Outcome::Passed: return {QStringLiteral("✓"), LadderView::tr("passed"), ui::Role::Text1};
    case Rung::Outcome::Failed: return {QStringLiteral("✗"), LadderView::tr("failed"), ui::Role::Alarm};
    case Rung::Outcome::Skipped: break;
    }
    return {QStringLiteral("–"), LadderView::tr("not reached"), ui::Role::Text2};
}

QWidget *rungWidget(const Rung &rung)
{
    const Look look = dialogs::look(rung.outcome);
    auto *result = new QWidget;
    auto *row = new QHBoxLayout(result);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(10);
    auto *words = new QVBoxLayout;
    words->setSpacing(1);
    QLabel *title = widgets::text(rung.title, ui::Type::Heading, ui::Role::Text1);
    title->setAccessibleName(LadderView::tr("%1: %2").arg(rung.title, look.word));
    words->addWidget(title);
    words->addWidget(widgets::sentence(rung.sentence.isEmpty() ? look.word : rung.sentence, ui::Role::Text2));
    if (!rung.remedy.isEmpty())
        words->addWidget(widgets::sentence(rung.remedy, ui::Role::Amber));
    row->addWidget(widgets::text(look.mark, ui::Type::State, look.ink), 0, Qt::AlignTop);
    row->addLayout(words, 1);
    return result;
}

} // namespace

void LadderView::diagnose(const settings::Profile &profile)
{
    m_profile = profile;
    m_isFinished = false;
    m_rungs = std::make_unique<QWidget>();
    auto *column = new QVBoxLayout(m_rungs.get());
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(8);
    if (!layout())
        (new QVBoxLayout(this))->setContentsMargins(0, 0, 0, 0);
    layout()->addWidget(m_rungs.get());
    m_diagnosis = std::make_unique<robot::Diagnosis>(profile);
    connect(m_diagnosis.get(), &robot::Diagnosis::rungFinished, this, &LadderView::add);
    connect(m_diagnosis.get(), &robot::Diagnosis::finished, this, [this] {
        m_isFinished = true;
        Q_EMIT finished();
    });
    m_diagnosis->start();
}

void LadderView::add(const Rung &rung) { m_rungs->layout()->addWidget(rungWidget(rung)); }

QString LadderView::toText() const
{
    QStringList lines {tr("Pendesk %1, diagnosis of %2 (%3)")
                           .arg(QCoreApplication::applicationVersion(), m_profile.name, ui::addressText(m_profile))};
    const QList<Rung> rungs = m_diagnosis ? m_diagnosis->rungs() : QList<Rung>();
    for (const Rung &rung : rungs) {
        const Look look = dialogs::look(rung.outcome);
        lines << QStringList {look.mark, rung.title + u':', rung.sentence.isEmpty() ? look.word : rung.sentence,
            rung.remedy}
                     .join(u' ')
                     .trimmed();
    }
    return lines.join(u'\n') + u'\n';
}

} // namespace dialogs
