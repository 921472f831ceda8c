// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "robot/arming.h"
#include "ui/harness.h"
#include "ui/pagecatalog.h"
#include "ui/widgets/noticestack.h"
#include "virtualcontroller/alarms.h"
#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QLineEdit>
#include <QTabBar>

using robot::Freshness;
using robot::LinkState;
using values::Status;

namespace {

/// What a person may press or type into.
bool isInteractive(const QWidget &widget)
{
    return qobject_cast<const QAbstractButton *>(&widget) || qobject_cast<const QLineEdit *>(&widget)
        || qobject_cast<const QComboBox *>(&widget) || qobject_cast<const QAbstractSpinBox *>(&widget)
        || qobject_cast<const QTabBar *>(&widget) || qobject_cast<const QAbstractItemView *>(&widget);
}

using Places = QHash<const QWidget *, QRect>;

/// Where everything interactive in the window is; what notices bring with them is no part of it.
Places placesIn(const QWidget &window)
{
    Places result;
    const auto *notices = window.findChild<QWidget *>(QStringLiteral("notices"));
    for (const QWidget *widget : window.findChildren<QWidget *>()) {
        if (widget->isVisible() && isInteractive(*widget) && !(notices && notices->isAncestorOf(widget)))
            result[widget] = {widget->mapTo(&window, QPoint()), widget->size()};
    }
    return result;
}

QString text(const QRect &rect)
{
    return QStringLiteral("%1,%2 %3x%4").arg(rect.x()).arg(rect.y()).arg(rect.width()).arg(rect.height());
}

/// A line for everything that was there before and after, in another place.
QStringList movedBetween(const Places &before, const Places &after)
{
    QStringList result;
    for (auto it = before.begin(); it != before.end(); ++it) {
        const auto now = after.find(it.key());
        if (now != after.end() && *now != it.value())
            result << QStringLiteral("%1 '%2': %3 → %4")
                          .arg(QLatin1String(it.key()->metaObject()->className()), it.key()->objectName(),
                              text(it.value()), text(*now));
    }
    result.sort();
    return result;
}

/// The window at rest, with an engineer before it.
struct Desk : Harness {
    [[nodiscard]] bool open()
    {
        readTimeout = std::chrono::milliseconds {1000};
        if (!connectLive())
            return false;
        access().enter(robot::Level::Engineer);
        virtualcontroller::Memory &memory = server->memory();
        memory.isJobRunning = false;
        memory.status = Status {Status::Data1 {Status::Remote} | Status::Play | Status::Continuous, Status::ServoOn};
        return QTest::qWaitFor([this] { return is([](const Status &s) { return !s.isRunning(); }); });
    }
    [[nodiscard]] bool is(const std::function<bool(const Status &)> &what) const
    {
        return state().status().value && what(*state().status().value);
    }
    [[nodiscard]] robot::Orders &orders() const { return window.view().orders(); }
    [[nodiscard]] Status &status() { return server->memory().status; }

    /// Opens the page; true when all that it names was read or refused.
    [[nodiscard]] bool openPage(int row)
    {
        window.view().openPage(row);
        return QTest::qWaitFor([this, row] {
            for (const robot::TopicRange &range : window.view().page(row)->topics()) {
                for (int number = range.first; number <= range.last; ++number) {
                    if (state().freshness({range.kind, quint16(number)}) == Freshness::Unknown)
                        return false;
                }
            }
            return true;
        });
    }
};

struct Event {
    const char *name;
    void (*apply)(Desk &);
    bool (*isThere)(Desk &);
    void (*undo)(Desk &);
    bool (*isOver)(Desk &);
};

template <auto flag> bool hasData1(Desk &desk)
{
    return desk.is([](const Status &s) { return s.data1.testFlag(flag); });
}
template <auto flag> bool hasData2(Desk &desk)
{
    return desk.is([](const Status &s) { return s.data2.testFlag(flag); });
}
template <auto flag> constexpr Event data1Event(const char *name)
{
    return {name, [](Desk &desk) { desk.status().data1.setFlag(flag); }, hasData1<flag>,
        [](Desk &desk) { desk.status().data1.setFlag(flag, false); }, [](Desk &desk) { return !hasData1<flag>(desk); }};
}
template <auto flag> constexpr Event data2Event(const char *name)
{
    return {name, [](Desk &desk) { desk.status().data2.setFlag(flag); }, hasData2<flag>,
        [](Desk &desk) { desk.status().data2.setFlag(flag, false); }, [](Desk &desk) { return !hasData2<flag>(desk); }};
}

bool always(Desk &) { return true; }

const Event events[] {
    data1Event<Status::Teach>("teach beside play"),
    {"remote off", [](Desk &desk) { desk.status().data1.setFlag(Status::Remote, false); },
        [](Desk &desk) { return !hasData1<Status::Remote>(desk); },
        [](Desk &desk) { desk.status().data1.setFlag(Status::Remote); }, hasData1<Status::Remote>},
    data1Event<Status::Running>("running"),
    data2Event<Status::HeldByPendant>("held by the pendant"),
    data2Event<Status::HeldExternally>("held externally"),
    data2Event<Status::HeldByCommand>("held by command"),
    data2Event<Status::Error>("error"),
    {"servo off", [](Desk &desk) { desk.status().data2.setFlag(Status::ServoOn, false); },
        [](Desk &desk) { return !hasData2<Status::ServoOn>(desk); },
        [](Desk &desk) { desk.status().data2.setFlag(Status::ServoOn); }, hasData2<Status::ServoOn>},
    {"alarm", [](Desk &desk) { virtualcontroller::raiseAlarm(desk.server->memory(), 4107, "OVERRUN"); },
        hasData2<Status::Alarm>,
        [](Desk &desk) {
            desk.server->memory().alarms.clear();
            desk.status().data2.setFlag(Status::Alarm, false);
            desk.status().data2.setFlag(Status::ServoOn);
        },
        [](Desk &desk) { return !hasData2<Status::Alarm>(desk) && hasData2<Status::ServoOn>(desk); }},
    {"monitor", [](Desk &desk) { desk.access().enter(robot::Level::Monitor); }, always,
        [](Desk &desk) { desk.access().enter(robot::Level::Engineer); }, always},
    {"armed", [](Desk &desk) { desk.orders().arm(); }, [](Desk &desk) { return desk.orders().isArmed(); },
        [](Desk &desk) { desk.orders().arming().drop(robot::Arming::Drop::ByHand); },
        [](Desk &desk) { return !desk.orders().isArmed(); }},
    {"a notice",
        [](Desk &desk) {
            desk.window.view().show(ui::Notice {{widgets::Severity::Warning, QStringLiteral("Something."), {}}, {}});
        },
        [](Desk &desk) { return desk.bar()->isVisible(); }, [](Desk &desk) { desk.window.view().show(ui::Notice {}); },
        [](Desk &desk) { return !desk.bar()->isVisible(); }},
    {"the journal fails", [](Desk &desk) { Q_EMIT desk.journal.failed(QStringLiteral("The disk is full.")); }, always,
        [](Desk &desk) { Q_EMIT desk.journal.recovered(0); }, always},
    {"the pendant locked",
        [](Desk &desk) {
            desk.orders().send(protocol::HlockOn {}, {robot::Act::HlockOn}, &desk.window, [](const auto &) {});
        },
        [](Desk &desk) { return desk.orders().isPendantLocked(); },
        [](Desk &desk) { desk.window.view().releaseLock([] {}); },
        [](Desk &desk) { return !desk.orders().isPendantLocked(); }},
    {"the link lost", [](Desk &desk) { desk.stopController(); },
        [](Desk &desk) { return desk.window.controller().linkState() == LinkState::Lost; },
        [](Desk &desk) { (void)desk.startController(); },
        [](Desk &desk) { return desk.window.controller().linkState() == LinkState::Monitoring; }},
};

/// What still moves, and why. This list only gets shorter.
bool isKnownToMove(const QString &line)
{
    static const QStringList known {
        QStringLiteral("alarms: widgets::TableHeader"), // the scroll bar of a table that got another row
        QStringLiteral("jobs: QPushButton 'hlock-o"), // in a narrow window HLOCK's sentences differ by a line
        QStringLiteral("jobs: QPushButton 'why-hlock-o"), QStringLiteral("jobs: QPushButton 'showTasks'"),
        QStringLiteral("overview: QPushButton 'copySystem'"), // the card grows with what the system says
    };
    return std::ranges::any_of(known, [&line](const QString &each) { return line.contains(each); });
}

} // namespace

/// A page stands still: whatever happens to the robot, the link or the program, nothing that can be pressed moves.
class StandsStillTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void nothingMoves_data();
    void nothingMoves();
    void noticesLieOverTheEdge();
};

void StandsStillTest::nothingMoves_data()
{
    QTest::addColumn<QSize>("size");
    QTest::newRow("1440") << QSize(1440, 900);
    QTest::newRow("1024") << QSize(1024, 768);
}

void StandsStillTest::nothingMoves()
{
    QFETCH(QSize, size);
    Desk desk;
    desk.window.resize(size);
    QVERIFY(desk.open());
    const int count = int(ui::pageCatalog().size());
    QList<Places> still;
    for (int row = 0; row < count; ++row) {
        QVERIFY(desk.openPage(row));
        QCoreApplication::sendPostedEvents();
        QVERIFY(!placesIn(desk.window).isEmpty());
    }
    for (int row = 0; row < count; ++row) { // once more: all are made, and all was read
        desk.window.view().openPage(row);
        QCoreApplication::sendPostedEvents();
        still << placesIn(desk.window);
    }
    QStringList moved;
    const auto look = [&](const char *event, const char *when) {
        for (int row = 0; row < count; ++row) {
            desk.window.view().openPage(row);
            QCoreApplication::sendPostedEvents();
            for (const QString &line : movedBetween(still[row], placesIn(desk.window))) {
                const QString found = QStringLiteral("%1: %2").arg(QLatin1String(ui::pageCatalog()[row].id), line);
                if (!isKnownToMove(found))
                    moved << QStringLiteral("%1, %2, %3").arg(QLatin1String(event), QLatin1String(when), found);
            }
        }
    };
    for (const Event &event : events) {
        event.apply(desk);
        QTRY_VERIFY2(event.isThere(desk), event.name);
        look(event.name, "there");
        event.undo(desk);
        QTRY_VERIFY2(event.isOver(desk), event.name);
        look(event.name, "over");
    }
    QVERIFY2(moved.isEmpty(), qPrintable(QStringLiteral("%1 moved\n").arg(moved.size()) + moved.join(u'\n')));
}

void StandsStillTest::noticesLieOverTheEdge()
{
    Desk desk;
    QVERIFY(desk.open());
    desk.window.view().show(ui::Notice {{widgets::Severity::Warning, QStringLiteral("Something happened."), {}}, {}});
    Q_EMIT desk.journal.failed(QStringLiteral("The disk is full."));
    const auto *stack = desk.window.findChild<widgets::NoticeStack *>();
    QVERIFY(stack->isVisible());
    QVERIFY(desk.window.rect().contains(stack->geometry()));
    QVERIFY(stack->geometry().bottom() > desk.window.height() - 10);
    QVERIFY(stack->geometry().right() > desk.window.width() - 2 * ui::space::page);
    QVERIFY(stack->geometry().top() > desk.window.height() / 2);
    auto *close = desk.bar()->findChild<QAbstractButton *>(QStringLiteral("messageClose"));
    QTest::mouseClick(close, Qt::LeftButton);
    QVERIFY(!desk.bar()->isVisible());
    QVERIFY(stack->isVisible()); // the other one stays
    Q_EMIT desk.journal.recovered(0);
    QVERIFY(!stack->isVisible());
}

int main(int argc, char *argv[])
{
    QApplication application {argc, argv};
    ui::apply(application, ui::Scheme::Light);
    StandsStillTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_standsstill.moc"
