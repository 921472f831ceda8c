// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/files/offers.h"

#include "disk/durable.h"
#include "files/localname.h"
#include "files/preflight.h"
#include "ui/dialogs/comparedialog.h"
#include "ui/pages/files/remotefile.h"
#include "ui/widgets/question.h"
#include <QFileInfo>

using files::Direction;

namespace pages {

Offers::Offers(const Context &context, QWidget *window)
    : m_context {context}, m_orders {context.station.fileOrders}, m_queue {context.station.transfers}, m_window {window}
{
}

void Offers::lookAndAsk(const QList<Offer> &offers)
{
    const protocol::TextCodec codec {m_context.station.profile().encoding};
    QList<Offer> passing;
    QStringList sentences;
    for (const Offer &each : offers) {
        const auto content = disk::readFile(each.localPath);
        const auto findings = files::preflight(each.name, content.value_or(QByteArray()), m_orders.jobsInUse());
        if (files::mayBeSent(findings))
            passing << each;
        for (const inform::Finding &finding : findings)
            sentences << QStringLiteral("%1 %2: %3")
                             .arg(finding.isError() ? QStringLiteral("▲") : QStringLiteral("·"),
                                 text(m_context, each.name), files::explain(finding, codec));
    }
    if (sentences.isEmpty())
        ask(passing);
    else
        tellFindings(sentences, passing);
}

void Offers::tellFindings(const QStringList &sentences, const QList<Offer> &passing)
{
    QList<widgets::Answer> answers;
    if (!passing.isEmpty())
        answers << widgets::Answer {
            "sendFiles", tr("Send %n file(s)", nullptr, int(passing.size())), [this, passing] { ask(passing); }};
    widgets::ask("preflight", tr("Before sending"), sentences.join(u'\n'), answers, m_window);
}

void Offers::ask(const QList<Offer> &offers)
{
    m_offers = offers;
    m_forAll.reset();
    askNext();
}

void Offers::askNext()
{
    while (!m_offers.isEmpty() && (!m_offers.first().isTaken || m_forAll))
        decide(m_offers.first().isTaken ? *m_forAll : Choice::Replace);
    if (!m_offers.isEmpty())
        askAbout(m_offers.first());
}

void Offers::askAbout(const Offer &offer)
{
    const bool isDownload = offer.direction == Direction::Download;
    const QString where = isDownload ? tr("on this computer") : tr("on %1").arg(m_context.station.profile().name);
    auto *dialog = new dialogs::OverwriteDialog(
        text(m_context, offer.name), where, isDownload, int(m_offers.size()) - 1, m_window);
    connect(dialog, &QDialog::finished, this, [this, dialog] {
        if (dialog->choice() == Choice::Compare)
            return compare(m_offers.first());
        if (dialog->isForAll())
            m_forAll = dialog->choice();
        decide(dialog->choice());
        askNext();
    });
    dialog->show();
}

void Offers::decide(Choice choice)
{
    Offer offer = m_offers.takeFirst();
    if (choice == Choice::Skip)
        return;
    if (choice == Choice::KeepBoth)
        offer.localPath = files::freePath(QFileInfo {offer.localPath}.path(), offer.name);
    carryOut(offer);
}

void Offers::carryOut(const Offer &offer)
{
    auto task = offer.direction == Direction::Download ? m_orders.download(offer.name, offer.localPath)
                                                       : m_orders.upload(offer.name, offer.localPath);
    if (task)
        m_queue.add(std::move(task));
}

void Offers::compare(const Offer &offer)
{
    readRemote(m_context, offer.name, m_window, [this, offer](const QByteArray &remote) {
        const QByteArray local = disk::readFile(offer.localPath).value_or(QByteArray());
        const bool isDownload = offer.direction == Direction::Download;
        const protocol::TextCodec codec {m_context.station.profile().encoding};
        auto *dialog = new dialogs::CompareDialog(tr("What would change in “%1”").arg(text(m_context, offer.name)),
            isDownload ? local : remote, isDownload ? remote : local, codec, {}, m_window);
        connect(dialog, &QDialog::finished, this, &Offers::askNext);
        dialog->show();
    });
}

} // namespace pages
