// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/linkcard.h"

#include "ui/widgets/rows.h"
#include "ui/widgets/sparkline.h"
#include "ui/words.h"
#include <QCoreApplication>
#include <QLocale>

namespace pages {

namespace {

using session::Counters;

enum Row { RoundTrip, Lost, Requests, LastAnswer, Sent, Unusual };

QString counted(quint64 value) { return QLocale().toString(value); }

/// What a good link has none of.
QString unusual(const Counters &counters)
{
    struct Item {
        const char *text;
        quint64 count;
    };
    const Item items[] {
        {QT_TRANSLATE_NOOP("pages::LinkCard", "%1 repeated"), counters.repeats},
        {QT_TRANSLATE_NOOP("pages::LinkCard", "%1 unanswered"), counters.lost},
        {QT_TRANSLATE_NOOP("pages::LinkCard", "%1 late"), counters.late},
        {QT_TRANSLATE_NOOP("pages::LinkCard", "%1 twice"), counters.duplicates},
        {QT_TRANSLATE_NOOP("pages::LinkCard", "%1 mismatched"), counters.mismatched},
        {QT_TRANSLATE_NOOP("pages::LinkCard", "%1 malformed"), counters.malformed},
        {QT_TRANSLATE_NOOP("pages::LinkCard", "%1 from elsewhere"), counters.strangers},
        {QT_TRANSLATE_NOOP("pages::LinkCard", "%1 busy"), counters.busy},
    };
    QStringList words;
    for (const Item &item : items) {
        if (item.count > 0)
            words << LinkCard::tr(item.text).arg(counted(item.count));
    }
    return words.isEmpty() ? LinkCard::tr("nothing") : words.join(QStringLiteral(" · "));
}

} // namespace

LinkCard::LinkCard(const settings::Profile &profile, QWidget *parent)
    : Card(tr("Link"), parent),
      m_ceiling {profile.requestsPerSecond},
      m_sparkline {new widgets::Sparkline},
      m_rows {new widgets::Rows(Qt::AlignRight)}
{
    setNote(tr("last 60 s"));
    m_sparkline->setObjectName(QStringLiteral("roundTrips"));
    m_rows->add(QStringLiteral("roundTrip"), tr("round trip p50 / p95"));
    m_rows->add(QStringLiteral("lost"), tr("lost"));
    m_rows->add(QStringLiteral("requests"), tr("requests"));
    m_rows->add(QStringLiteral("lastAnswer"), tr("last answer"));
    m_rows->add(QStringLiteral("sent"), tr("sent / answered"));
    m_rows->add(QStringLiteral("unusual"), tr("unusual"));
    body()->addWidget(m_sparkline);
    body()->addWidget(m_rows);
    body()->addStretch();
}

void LinkCard::showStatistics(const session::LinkStatistics &statistics)
{
    m_sparkline->show(statistics.seconds);
    m_rows->showText(
        RoundTrip, tr("%1 / %2").arg(ui::roundTripText(statistics.p50), ui::roundTripText(statistics.p95)));
    m_rows->showText(Lost, ui::percent(statistics.loss));
    m_rows->showText(
        Requests, tr("%1 /s of %2").arg(counted(quint64(statistics.requestsPerSecond)), counted(quint64(m_ceiling))));
    m_rows->showText(LastAnswer,
        statistics.lastAnswerAge ? tr("%1 ago").arg(ui::ageText(statistics.lastAnswerAge)) : widgets::dash());
    m_rows->showText(
        Sent, tr("%1 / %2").arg(counted(statistics.counters.requests), counted(statistics.counters.answers)));
    m_rows->showText(Unusual, unusual(statistics.counters));
}

} // namespace pages
