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

namespace ui {

using robot::HoldWord;
using robot::LinkState;
using widgets::Lamp;
using widgets::StateField;

namespace {

struct StripCell {
    const char *name;
    const char *title;
    widgets::Word (*word)(const values::Status &);
    bool isElided = false; ///< Words that may grow long; all of them are on the overview.
};

constexpr StripCell fields[] {
    {"stripMode", QT_TRANSLATE_NOOP("ui::RobotStrip", "Mode"), modeWord, true},
    {"stripServo", QT_TRANSLATE_NOOP("ui::RobotStrip", "Servo"), servoWord},
    {"stripRun", QT_TRANSLATE_NOOP("ui::RobotStrip", "Run"), runWord, true},
    {"stripHold", QT_TRANSLATE_NOOP("ui::RobotStrip", "Hold"), holdWord, true},
    {"stripAlarm", QT_TRANSLATE_NOOP("ui::RobotStrip", "Alarm"), alarmWord},
    {"stripError", QT_TRANSLATE_NOOP("ui::RobotStrip", "Error"), errorWord},
};

constexpr int cellMargin = 9;

StateField *cell(const char *name, const QString &title)
{
    auto *field = new StateField(title, Type::StripState);
    field->value()->setObjectName(QLatin1String(name));
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
        result << holdCaption({HoldWord(word)});
    return result;
}

} // namespace

RobotStrip::RobotStrip(const robot::RobotState &state, const settings::Profile &profile, QWidget *parent)
    : QWidget(parent),
      m_state {state},
      m_encoding {profile.encoding},
      m_row {new QHBoxLayout(this)},
      m_job {new widgets::ValueLabel(Type::StripState)},
      m_place {new widgets::ValueLabel(Type::Body)},
      m_link {cell("stripLink", tr("Link"))},
      m_hold {new widgets::HoldButton}
{
    setFixedHeight(space::strip);
    m_row->setContentsMargins(space::page - 4, 0, space::page, 0);
    m_row->setSpacing(0);
    m_row->addWidget(nameCell(profile), 2);
    addStatusCells();
    m_jobCell = jobCell();
    m_row->addWidget(m_jobCell, 3);
    m_link->value()->setElided(true);
    m_row->addWidget(m_link);
    m_row->addWidget(m_hold);
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
    auto *column = new QVBoxLayout(result);
    column->setContentsMargins(0, 0, cellMargin, 0);
    column->setSpacing(1);
    column->addStretch();
    column->addLayout(m_badges);
    column->addWidget(name);
    column->addStretch();
    return result;
}

void RobotStrip::addBadge(QWidget *badge) { m_badges->addWidget(badge); }

QWidget *RobotStrip::jobCell() const
{
    auto *result = new QWidget;
    m_job->setObjectName(QStringLiteral("stripJob"));
    m_job->setTitle(tr("Executing"));
    m_job->setElided(true);
    m_place->setObjectName(QStringLiteral("stripPlace"));
    m_place->setElided(true);
    auto *line = new QHBoxLayout;
    line->setSpacing(8);
    line->addWidget(m_job);
    line->addWidget(m_place, 1);
    auto *column = new QVBoxLayout(result);
    column->setContentsMargins(cellMargin, 0, cellMargin, 0);
    column->setSpacing(1);
    column->addStretch();
    column->addWidget(widgets::text(tr("Executing"), Type::Label, Role::Text2));
    column->addLayout(line);
    column->addStretch();
    return result;
}

void RobotStrip::addStatusCells()
{
    for (const StripCell &field : fields) {
        m_statusFields << cell(field.name, tr(field.title));
        m_statusFields.back()->value()->setElided(field.isElided);
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
    const auto place = [](const values::ExecutingJob &job) { return widgets::Word {jobPlace(job)}; };
    m_job->show(widgets::shown(m_state.job(), freshness, name));
    m_place->show(widgets::shown(m_state.job(), freshness, place));
    m_place->setVisible(m_state.job().value.has_value());
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

/// The cell never gets narrower: digits differ, and the neighbours stand still.
void RobotStrip::showLinkCell()
{
    m_link->setMinimumWidth(std::max(m_link->minimumWidth(), m_link->minimumSizeHint().width()));
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

QSize RobotStrip::minimumSizeHint() const
{
    const int job = m_jobCell->isVisibleTo(this) ? m_jobCell->minimumSizeHint().width() : 0;
    return {m_row->totalMinimumSize().width() - job, space::strip};
}

bool RobotStrip::event(QEvent *event)
{
    if (event->type() == QEvent::LayoutRequest || event->type() == QEvent::Resize)
        makeRoom();
    return QWidget::event(event);
}

/// The job is on the overview too: in a narrow window it makes room for what is only here. The states are written
/// smaller before one of them is shortened, and bigger again when there surely is room.
void RobotStrip::makeRoom()
{
    const int job = m_jobCell->isVisibleTo(this) ? m_jobCell->sizeHint().width() : 0;
    const int others = m_row->totalSizeHint().width() - job;
    m_jobCell->setVisible(others + m_jobCell->minimumSizeHint().width() <= width());
    constexpr qreal growth = 1.3; // of strip words against those of the body
    if (m_isTight ? others * growth <= width() : others > width())
        setTight(!m_isTight);
}

void RobotStrip::setTight(bool isTight)
{
    m_isTight = isTight;
    QFont words = ui::font(isTight ? Type::Body : Type::StripState);
    words.setWeight(QFont::DemiBold);
    for (const StateField *field : m_statusFields)
        field->value()->setFont(words);
    m_link->value()->setFont(words);
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
