// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/robotstrip.h"

#include "ui/widgets/badge.h"
#include "ui/widgets/holdbutton.h"
#include "ui/widgets/statefield.h"
#include "ui/widgets/text.h"
#include "ui/words.h"
#include <QCoreApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QPainter>
#include <algorithm>
#include <numeric>
#include <utility>

namespace ui {

using robot::HoldWord;
using robot::LinkState;
using widgets::Lamp;
using widgets::StateField;

namespace {

constexpr int alarmField = 4;

struct StripCell {
    const char *name;
    const char *title;
    widgets::Word (*word)(const values::Status &);
    int width;
};

constexpr StripCell fields[] {
    {"stripMode", QT_TRANSLATE_NOOP("ui::RobotStrip", "Mode"), modeWord, 140},
    {"stripServo", QT_TRANSLATE_NOOP("ui::RobotStrip", "Servo"), servoWord, 78},
    {"stripRun", QT_TRANSLATE_NOOP("ui::RobotStrip", "Run"), runWord, 128},
    {"stripHold", QT_TRANSLATE_NOOP("ui::RobotStrip", "Hold"), holdWord, 100},
    {"stripAlarm", QT_TRANSLATE_NOOP("ui::RobotStrip", "Alarm"), alarmWord, 0},
    {"stripError", QT_TRANSLATE_NOOP("ui::RobotStrip", "Error"), errorWord, 86},
};

constexpr int linkWidth = 104;
constexpr int cellMargin = 9;
constexpr int mostSeconds = 99; ///< That HOLD counts before its words would need more room.
constexpr int leftMargin = space::page - 4;

/// The cells that share what a window has. Their widths follow from the window alone, never from the words in them.
struct Shares {
    int window;
    int name;
    int alarm;
    int job;
    int hold;
};
constexpr Shares shares[] {{1366, 180, 190, 174, 150}, {1440, 190, 218, 210, 150}, {1920, 240, 438, 390, 180}};
constexpr int leastWindow = 1024;
constexpr int leastWithLink = 1088;

int fixedWidth()
{
    return std::accumulate(std::begin(fields), std::end(fields), leftMargin + space::page,
        [](int sum, const StripCell &field) { return sum + field.width; });
}

/// Without the job, which is on the overview too, and then without the link, of which every page line tells.
Shares narrowShares(int window)
{
    const Shares &least = shares[0];
    const int link = window < leastWithLink ? 0 : linkWidth;
    return {window, least.name, window - fixedWidth() - link - least.name - least.hold, 0, least.hold};
}

Shares sharesOf(int window)
{
    if (window < shares[0].window)
        return narrowShares(std::max(window, leastWindow));
    const auto *above = std::ranges::find_if(shares, [window](const Shares &row) { return window < row.window; });
    if (above == std::end(shares))
        return std::end(shares)[-1];
    const Shares &below = above[-1];
    const auto between = [&](int Shares::*cell) {
        return below.*cell + (above->*cell - below.*cell) * (window - below.window) / (above->window - below.window);
    };
    return {window, between(&Shares::name), between(&Shares::alarm), between(&Shares::job), between(&Shares::hold)};
}

StateField *cell(const char *name, const QString &title)
{
    auto *field = new StateField(title, Type::StripState);
    field->value()->setObjectName(QLatin1String(name));
    field->value()->setElided(true);
    field->layout()->setContentsMargins(cellMargin, 0, cellMargin, 0);
    return field;
}

widgets::Shown fact(const QString &text, Lamp lamp = Lamp::None) { return {{text, lamp}, robot::Freshness::Live, {}}; }

/// Where the values come from: the address, or the mark that nothing of this is real.
QWidget *originOf(const settings::Profile &profile)
{
    if (!profile.isSimulation) {
        auto *address = new widgets::ValueLabel(Type::Label);
        address->setObjectName(QStringLiteral("stripAddress"));
        address->setRole(Role::Text2);
        address->setElided(true);
        address->show(fact(addressText(profile)));
        return address;
    }
    auto *mark = new widgets::Badge(RobotStrip::tr("SIMULATION"), Role::Magenta, Role::MagentaGround);
    mark->setObjectName(QStringLiteral("simulationBadge"));
    mark->setToolTip(addressText(profile));
    return mark;
}

/// Everything that can stand under HOLD.
QStringList captions()
{
    QStringList result;
    for (int word = 0; word <= int(HoldWord::Released); ++word)
        result << holdCaption({HoldWord(word), mostSeconds});
    return result;
}

} // namespace

RobotStrip::RobotStrip(const robot::RobotState &state, const settings::Profile &profile, QWidget *parent)
    : QWidget(parent),
      m_state {state},
      m_encoding {profile.encoding},
      m_row {new QHBoxLayout(this)},
      m_name {nameCell(profile)},
      m_job {cell("stripJob", tr("Job"))},
      m_link {cell("stripLink", tr("Link"))},
      m_hold {new widgets::HoldButton}
{
    setFixedHeight(space::strip);
    m_row->setContentsMargins(leftMargin, 0, space::page, 0);
    m_row->setSpacing(0);
    m_row->addWidget(m_name);
    addStatusCells();
    m_row->addWidget(m_job);
    m_link->setFixedWidth(linkWidth);
    m_row->addWidget(m_link);
    m_row->addStretch();
    m_row->addWidget(m_hold);
    useFittingType();
    m_hold->setObjectName(QStringLiteral("holdButton"));
    m_hold->makeRoomFor(captions());
    connect(m_hold, &widgets::HoldButton::holdRequested, this, &RobotStrip::holdRequested);
    connect(&state, &robot::RobotState::changed, this, &RobotStrip::onChanged);
    showLink({});
    showStatus();
    showJob();
}

QWidget *RobotStrip::nameCell(const settings::Profile &profile)
{
    auto *result = new QWidget;
    auto *name = new widgets::ValueLabel(Type::StripState);
    name->setObjectName(QStringLiteral("stripName"));
    name->setElided(true);
    name->show(fact(profile.name.isEmpty() ? tr("No controller") : profile.name));
    m_badges = new QHBoxLayout;
    m_badges->setSpacing(6);
    m_badges->addWidget(originOf(profile), 1, Qt::AlignLeft);
    m_nameLine = new QHBoxLayout;
    m_nameLine->setSpacing(6);
    m_nameLine->addWidget(name, 1);
    auto *column = new QVBoxLayout(result);
    column->setContentsMargins(0, 0, cellMargin, 0);
    column->setSpacing(1);
    column->addStretch();
    column->addLayout(m_badges);
    column->addLayout(m_nameLine);
    column->addStretch();
    return result;
}

void RobotStrip::addBadge(QWidget *badge) { m_badges->addWidget(badge); }

void RobotStrip::addMark(QWidget *mark) { m_nameLine->addWidget(mark); }

void RobotStrip::addStatusCells()
{
    for (const StripCell &field : fields) {
        m_statusFields << cell(field.name, tr(field.title));
        if (field.width > 0)
            m_statusFields.back()->setFixedWidth(field.width);
        m_row->addWidget(m_statusFields.back());
    }
}

void RobotStrip::onChanged(const robot::TopicRange &range)
{
    if (range.contains(robot::topics::status))
        showStatus();
    else if (range.contains(robot::topics::masterJob))
        showJob();
}

void RobotStrip::showStatus()
{
    const auto freshness = m_state.freshness(robot::topics::status);
    for (qsizetype i = 0; i < m_statusFields.size(); ++i)
        m_statusFields[i]->show(widgets::shown(m_state.status(), freshness, fields[i].word));
}

void RobotStrip::showJob()
{
    const auto freshness = m_state.freshness(robot::topics::masterJob);
    const auto name = [this](const values::ExecutingJob &job) { return widgets::Word {jobName(job, m_encoding)}; };
    m_job->show(widgets::shown(m_state.job(), freshness, name));
    const QString place = freshness == robot::Freshness::Live ? jobPlace(*m_state.job().value) : QString();
    m_job->setTitle(place.isEmpty() ? tr("Job") : tr("Job · %1").arg(place));
}

void RobotStrip::showLink(const LinkView &link)
{
    m_linkView = link;
    m_hold->setCaption(holdCaption(link.hold));
    showLinkCell();
}

void RobotStrip::showStatistics(const session::LinkStatistics &statistics)
{
    m_statistics = statistics;
    showLinkCell();
}

void RobotStrip::showLinkCell()
{
    const QString age = ageText(m_statistics.lastAnswerAge);
    const bool hasAnswered = m_statistics.lastAnswerAge.has_value();
    m_link->setTitle(
        hasAnswered && m_linkView.state != LinkState::Disconnected ? tr("Link · %1 ago").arg(age) : tr("Link"));
    switch (m_linkView.state) {
    case LinkState::Monitoring:
        return m_link->show(fact(tr("%1 · %2").arg(roundTripText(m_statistics.p50), percent(m_statistics.loss))));
    case LinkState::Lost: return m_link->show(fact(tr("LOST"), Lamp::Warning));
    case LinkState::Checking:
        return m_link->show(
            m_linkView.trouble ? fact(tr("no answer"), Lamp::Warning) : fact(tr("checking…"), Lamp::Hollow));
    case LinkState::Disconnected: break;
    }
    m_link->show(fact(tr("not connected"), Lamp::Hollow));
}

QSize RobotStrip::minimumSizeHint() const { return {leastWindow, space::strip}; }

void RobotStrip::resizeEvent(QResizeEvent *event)
{
    Shares now = sharesOf(width());
    const int words = std::max(now.hold, m_hold->sizeHint().width()); // under HOLD none is cut off
    now.alarm -= words - std::exchange(now.hold, words);
    m_name->setFixedWidth(now.name);
    m_statusFields[alarmField]->setFixedWidth(now.alarm);
    m_job->setFixedWidth(now.job);
    m_job->setVisible(now.job > 0);
    m_link->setVisible(width() >= leastWithLink);
    m_hold->setFixedWidth(now.hold);
    m_row->activate();
    QWidget::resizeEvent(event);
}

/// Smaller words where the usual ones of this language and font would be shortened.
void RobotStrip::useFittingType()
{
    values::Status usual;
    usual.data1 = values::Status::Remote | values::Status::Play;
    const int room = fields[0].width - 2 * cellMargin;
    QFont words = ui::font(Type::StripState);
    if (QFontMetrics(words).horizontalAdvance(modeWord(usual).text) > room)
        words = ui::font(Type::Body);
    words.setWeight(QFont::DemiBold);
    for (const StateField *field : m_statusFields + QList<StateField *> {m_job, m_link})
        field->value()->setFont(words);
}

void RobotStrip::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.fillRect(rect(), color(Role::Strip, this));
    painter.setPen(color(Role::Border, this));
    painter.drawLine(0, height() - 1, width(), height() - 1);
    for (int i = 1; i < m_row->count() - 1; ++i) {
        if (m_row->itemAt(i)->isEmpty())
            continue; // hidden
        const int x = m_row->itemAt(i)->geometry().left();
        painter.drawLine(x, 0, x, height() - 1);
    }
}

} // namespace ui
