// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/dialogs/readinesssheet.h"

#include "session/filesession.h"
#include "ui/dialogs/ladderview.h"
#include "ui/dialogs/numberingdialog.h"
#include "ui/dialogs/readinessrowview.h"
#include "ui/linkview.h"
#include "ui/readinesswords.h"
#include "ui/widgets/text.h"
#include <QClipboard>
#include <QDialogButtonBox>
#include <QGuiApplication>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

namespace dialogs {

using robot::LinkState;
using robot::Probe;
using robot::ReadinessFacts;
using robot::ReadinessRow;
using robot::Topic;

namespace {

// Both numberings have the variable number 1, every model the signal group 1.
constexpr Topic signalAsked {robot::Kind::IoGroup, 1};
constexpr Topic variableAsked {robot::Kind::ByteVariable, 1};

} // namespace

ReadinessSheet::ReadinessSheet(
    robot::Orders &orders, robot::NumberingGuard &guard, settings::ProfileStore &store, QWidget *parent)
    : DialogSheet(parent),
      m_orders {orders},
      m_guard {guard},
      m_store {store},
      m_link {widgets::sentence({}, ui::Role::Text2)},
      m_ladder {new LadderView(this)}
{
    setObjectName(QStringLiteral("readinessSheet"));
    const QString name = orders.controller().profile().name;
    setWindowTitle(tr("Readiness — %1").arg(name));
    resize(720, 640);
    m_ladder->hide();
    m_link->setObjectName(QStringLiteral("readinessLink"));
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(ui::space::page, ui::space::page, ui::space::page, ui::space::page);
    column->setSpacing(10);
    column->addWidget(widgets::text(tr("What %1 allows now").arg(name), ui::Type::State, ui::Role::Text1));
    column->addWidget(m_link);
    column->addWidget(makeRows(), 1);
    column->addWidget(makeButtons());
    follow();
}

ReadinessSheet::~ReadinessSheet() = default;

QWidget *ReadinessSheet::makeRows()
{
    auto *sheet = new QWidget;
    auto *column = new QVBoxLayout(sheet);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    for (int i = 0; i < robot::subjectCount; ++i) {
        m_rows << new ReadinessRowView(robot::Subject(i));
        column->addWidget(m_rows.last());
    }
    column->addStretch();
    auto *scroll = new QScrollArea;
    scroll->setObjectName(QStringLiteral("readinessRows"));
    scroll->setAccessibleName(tr("Readiness"));
    scroll->setProperty("reads", true);
    scroll->setWidget(sheet);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFrameShape(QFrame::NoFrame);
    return scroll;
}

QWidget *ReadinessSheet::makeButtons()
{
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    buttons->button(QDialogButtonBox::Close)->setObjectName(QStringLiteral("closeButton"));
    m_copy = buttons->addButton(tr("Copy"), QDialogButtonBox::ActionRole);
    m_copy->setObjectName(QStringLiteral("copyReadiness"));
    m_copy->setAccessibleName(tr("Copy the readiness and a diagnosis"));
    m_copy->setToolTip(tr("As text for support, with a diagnosis of the link, which takes a moment."));
    m_test = buttons->addButton(tr("Test numbering…"), QDialogButtonBox::ActionRole);
    m_test->setObjectName(QStringLiteral("testNumbering"));
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    connect(m_copy, &QPushButton::clicked, this, [this] {
        m_copy->setEnabled(false);
        m_ladder->diagnose(m_orders.controller().profile());
    });
    connect(m_ladder, &LadderView::finished, this, &ReadinessSheet::copy);
    connect(m_test, &QPushButton::clicked, this, &ReadinessSheet::openNumberingTest);
    return buttons;
}

void ReadinessSheet::follow()
{
    const robot::Controller &controller = m_orders.controller();
    connect(&m_orders, &robot::Orders::situationChanged, this, &ReadinessSheet::showFacts);
    connect(&controller, &robot::Controller::linkStateChanged, this, &ReadinessSheet::onLinkStateChanged);
    connect(&controller, &robot::Controller::holdOrderChanged, this, &ReadinessSheet::showFacts);
    connect(&controller.state(), &robot::RobotState::changed, this, [this](const robot::TopicRange &range) {
        using namespace robot::topics;
        const auto concerns = [&range](Topic topic) { return range.contains(topic); };
        if (std::ranges::any_of(
                std::array {status, masterJob, systemInformation, signalAsked, variableAsked}, concerns))
            showFacts();
    });
}

void ReadinessSheet::showEvent(QShowEvent *event)
{
    QDialog::showEvent(event);
    m_interest = m_orders.controller().poller().want({signalAsked, variableAsked});
    onLinkStateChanged();
}

void ReadinessSheet::hideEvent(QHideEvent *event)
{
    QDialog::hideEvent(event);
    m_interest.reset();
}

/// What was found out stands while communication is lost, and is forgotten with the link.
void ReadinessSheet::onLinkStateChanged()
{
    const LinkState link = m_orders.controller().linkState();
    if (link == LinkState::Disconnected || link == LinkState::Checking)
        m_files = {};
    else if (link == LinkState::Monitoring && isVisible())
        knockAtFiles();
    showFacts();
}

/// A list is the one file service that needs no name and changes nothing.
void ReadinessSheet::knockAtFiles()
{
    if (session::FileSession *files = m_orders.controller().files())
        files->list("*.JBI", this, [this](const values::Result<protocol::FileList> &list) {
            m_files = list ? Probe {Probe::Outcome::Answered, {}} : Probe {Probe::Outcome::Failed, list.error()};
            showFacts();
        });
}

Probe ReadinessSheet::probe(Topic topic) const
{
    const robot::RobotState &state = m_orders.controller().state();
    switch (state.freshness(topic)) {
    case robot::Freshness::Unknown: return {};
    case robot::Freshness::Live:
    case robot::Freshness::Stale: return {Probe::Outcome::Answered, {}};
    case robot::Freshness::Refused: break;
    }
    using robot::Kind;
    return {Probe::Outcome::Failed,
        topic.kind == Kind::IoGroup ? state.reading<Kind::IoGroup>(topic.number).refusal
                                    : state.reading<Kind::ByteVariable>(topic.number).refusal};
}

ReadinessFacts ReadinessSheet::facts() const
{
    ReadinessFacts facts = robot::readinessFacts(m_orders.controller(), m_orders.situation());
    facts.signal = probe(signalAsked);
    facts.variable = probe(variableAsked);
    facts.files = m_files;
    return facts;
}

void ReadinessSheet::showFacts()
{
    const robot::RobotState &state = m_orders.controller().state();
    const bool isStale = state.freshness(robot::topics::status) == robot::Freshness::Stale;
    const QString note = isStale ? widgets::lastSeen(state.status().clock) : QString();
    const ReadinessFacts now = facts();
    for (const ReadinessRow &row : robot::readiness(now))
        m_rows[int(row.subject)]->show(row, now, note);
    const auto &situation = now.situation;
    m_test->setVisible(!situation.isNumberingVerified && !now.profile.isSimulation);
    m_test->setEnabled(situation.isLinkUp);
    m_test->setToolTip(situation.isLinkUp ? QString() : tr("It needs a link to the controller."));
    showLink(isStale);
}

void ReadinessSheet::showLink(bool isStale)
{
    const robot::Controller &controller = m_orders.controller();
    const QString time = controller.linkStateSince().toString(u"HH:mm:ss");
    const auto say = [this](ui::Role role, const QString &text) {
        widgets::setTextRole(m_link, role);
        m_link->setText(text);
    };
    switch (controller.linkState()) {
    case LinkState::Lost:
        return say(ui::Role::Amber, tr("Communication lost at %1: what is hatched was read before.").arg(time));
    case LinkState::Checking:
        return say(ui::Role::Amber, tr("%1 has not answered yet.").arg(ui::addressText(controller.profile())));
    case LinkState::Disconnected: return say(ui::Role::Text2, tr("Not connected: nothing is read."));
    case LinkState::Monitoring: break;
    }
    say(ui::Role::Text2,
        isStale ? tr("The status was not read just now.")
                : tr("It is read live and changes nothing. HOLD works meanwhile: Pause key."));
}

QString ReadinessSheet::toText() const
{
    const ReadinessFacts now = facts();
    return ui::toText(robot::readiness(now), now);
}

void ReadinessSheet::copy()
{
    QGuiApplication::clipboard()->setText(toText() + u'\n' + m_ladder->toText());
    m_copy->setText(tr("Copied"));
    m_copy->setEnabled(true);
}

void ReadinessSheet::openNumberingTest()
{
    auto *dialog = new NumberingDialog(m_orders, this);
    connect(dialog, &NumberingDialog::verified, this,
        [this](protocol::Numbering numbering) { m_guard.keep(numbering, m_store); });
    dialog->show();
}

} // namespace dialogs
