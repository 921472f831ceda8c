// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "settings/settingsfile.h"
#include "ui/pages/overviewpage.h"

#include "robot/namebook.h"
#include "robot/numbering.h"
#include "robot/orders.h"
#include "settings/profilestore.h"
#include "trend/recorder.h"
#include "ui/actioncatalog.h"
#include "ui/robotstrip.h"
#include "ui/widgets/board.h"
#include "ui/widgets/line.h"
#include "ui/widgets/valuelabel.h"
#include <QAbstractButton>
#include <QApplication>
#include <QTemporaryDir>
#include <QTest>
#include <QTranslator>
#include <QVBoxLayout>

using robot::LinkState;
using robot::RobotState;
using widgets::ValueLabel;

namespace {

const robot::Time start {std::chrono::seconds {1000}};

/// Every text 40 % longer, as other languages have it.
class LongTexts : public QTranslator
{
public:
    QString translate(const char *, const char *source, const char *, int) const override
    {
        const QString text = QString::fromUtf8(source);
        return text + QString((text.size() * 2 + 4) / 5, u'x');
    }
    [[nodiscard]] bool isEmpty() const override { return false; }
};

values::Position position(values::PositionType type, int axes)
{
    values::Position result;
    result.type = type;
    result.tool = 3;
    result.axes.resize(axes);
    for (int axis = 0; axis < axes; ++axis)
        result.axes[axis] = -1234567 * (axis + 1);
    return result;
}

values::AxisNames names(std::initializer_list<const char *> list)
{
    values::AxisNames result;
    std::size_t axis = 0;
    for (const char *name : list)
        result.names[axis++] = values::FixedText<4>(name);
    return result;
}

void fill(RobotState &state, int axes = 6)
{
    using values::Status;
    state.setLinkUp(true, start);
    state.take<robot::Kind::Status>(1,
        {Status::Data1 {Status::Remote} | Status::Play | Status::Continuous | Status::Running,
            Status::Data2 {Status::ServoOn}},
        start);
    state.take<robot::Kind::Job>(0, {values::JobName {"WELD_A12"}, 47, 12, 8000}, start);
    state.take<robot::Kind::Position>(
        robot::topics::basePosition.number, position(values::PositionType::Base, axes), start);
    state.take<robot::Kind::Position>(
        robot::topics::pulsePosition.number, position(values::PositionType::Pulse, axes), start);
    state.take<robot::Kind::AxisNames>(
        robot::topics::baseAxisNames.number, names({"X", "Y", "Z", "Rx", "Ry", "Rz", "Re"}), start);
    state.take<robot::Kind::AxisNames>(
        robot::topics::pulseAxisNames.number, names({"S", "L", "U", "R", "B", "T", "E"}), start);
    state.take<robot::Kind::SystemInformation>(robot::topics::systemInformation.number,
        {values::FixedText<24> {"YAS4.12.00A(EN/EN)-00"}, values::FixedText<16> {"1-06VXH12-A0*"},
            values::FixedText<8> {"12.34"}},
        start);
}

/// A page on a state that the test fills.
struct Desk {
    explicit Desk(const settings::Profile &own = {}) : station {own, {store, rules, arming, journal}}
    {
        page.showLink({LinkState::Monitoring, {}, {}, 0, {}});
    }

    [[nodiscard]] ValueLabel *value(const char *name) const
    {
        return page.findChild<ValueLabel *>(QLatin1String(name));
    }
    [[nodiscard]] QString word(const char *name) const { return value(name)->text(); }

    QTemporaryDir folder;
    bool isDataHere = qputenv("XDG_DATA_HOME", folder.path().toLocal8Bit()); ///< Before anything is kept.
    QWidget window;
    ui::Actions actions {&window};
    robot::AccessRules rules;
    robot::Arming arming {std::chrono::hours {1}}; ///< However busy the computer is.
    journal::Store journal {QUrl::fromLocalFile(folder.filePath(QStringLiteral("journal.sqlite")))};
    settings::SettingsFile file {folder.filePath(QStringLiteral("settings.json"))};
    settings::ProfileStore store {file};
    station::Fleet fleet {{store, rules, arming, journal}};
    station::Station station;
    RobotState &state = const_cast<RobotState &>(station.state()); ///< Filled by hand.
    pages::OverviewPage page {{station, fleet, store, actions}};
};

bool lay(QWidget &widget, const QSize &size)
{
    widget.resize(size);
    widget.show();
    return QTest::qWaitForWindowExposed(&widget);
}

/// The first visible widget with text that has less room than it needs; empty if there is none.
QString clipped(const QWidget &page)
{
    const auto all = page.findChildren<QWidget *>();
    for (const QWidget *widget : all) {
        const auto *label = qobject_cast<const QLabel *>(widget);
        const auto *button = qobject_cast<const QAbstractButton *>(widget);
        if (!widget->isVisible() || (!label && !button))
            continue;
        const QString text = label ? label->text() : button->text();
        const bool wraps = label && label->wordWrap();
        const QSize need = wraps ? QSize(0, label->heightForWidth(label->width())) : widget->minimumSizeHint();
        if (widget->width() < need.width() || widget->height() < need.height())
            return text;
    }
    return {};
}

} // namespace

class TestOverviewPage : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init() { QLocale::setDefault(QLocale::c()); }
    void unknownIsNeverZeroOrBlank();
    void liveValues();
    void axes_data();
    void axes();
    void namesThatWereNotReadAreNotGuessed();
    void staleAfterTheLinkIsLost();
    void refusedSaysWhy();
    void contradictoryBitsAreShownAsReceived();
    void jobNamesInThePendantsEncoding();
    void anotherModelThanTheProfileSays();
    void layers();
    void reflows_data();
    void reflows();
    void longTextsAreNotClipped_data();
    void longTextsAreNotClipped();
    void stripFits_data();
    void stripFits();
};

void TestOverviewPage::unknownIsNeverZeroOrBlank()
{
    Desk desk;
    for (const char *name : {"mode", "cycle", "servo", "run", "heldByPendant", "heldExternally", "heldByCommand",
             "alarm", "error", "speedLimit", "job", "line", "step", "override", "base1", "base6", "pulse1", "pulse6",
             "model", "software", "parameters", "roundTrip", "lost"})
        QCOMPARE(desk.word(name), QStringLiteral("—"));
}

void TestOverviewPage::liveValues()
{
    Desk desk;
    fill(desk.state);
    QCOMPARE(desk.word("mode"), QStringLiteral("REMOTE PLAY"));
    QCOMPARE(desk.word("line"), QStringLiteral("47"));
    QCOMPARE(desk.word("override"), QStringLiteral("80 %"));
    QCOMPARE(desk.word("base1"), QStringLiteral("-1234.567"));
    QCOMPARE(desk.word("base4"), QStringLiteral("-493.8268"));
    QCOMPARE(desk.word("pulse2"), QStringLiteral("-2469134"));
    QCOMPARE(desk.word("model"), QStringLiteral("1-06VXH12-A0*"));
    QCOMPARE(desk.value("base4")->accessibleName(), QStringLiteral("Rx: -493.8268"));
    QCOMPARE(desk.value("pulse1")->accessibleName(), QStringLiteral("S: -1234567"));
}

void TestOverviewPage::axes_data()
{
    QTest::addColumn<int>("axes");
    for (const int axes : {4, 6, 7, 8})
        QTest::addRow("%d", axes) << axes;
}

void TestOverviewPage::axes()
{
    QFETCH(int, axes);
    Desk desk;
    fill(desk.state, axes);
    QVERIFY(lay(desk.page, {1224, 800}));
    for (int axis = 1; axis <= values::maxAxes; ++axis) {
        QCOMPARE(desk.value(qPrintable(QStringLiteral("base%1").arg(axis)))->isVisible(), axis <= axes);
        QCOMPARE(desk.value(qPrintable(QStringLiteral("pulse%1").arg(axis)))->isVisible(), axis <= axes);
    }
}

void TestOverviewPage::namesThatWereNotReadAreNotGuessed()
{
    Desk desk;
    desk.state.setLinkUp(true, start);
    desk.state.take<robot::Kind::Position>(
        robot::topics::basePosition.number, position(values::PositionType::Base, 6), start);
    QCOMPARE(desk.value("base1")->accessibleName(), QStringLiteral("axis 1: -1234.567"));
}

void TestOverviewPage::staleAfterTheLinkIsLost()
{
    Desk desk;
    fill(desk.state);
    desk.state.setLinkUp(false, start);
    for (const char *name : {"mode", "job", "base1", "pulse6", "model"}) {
        QVERIFY(desk.value(name)->shown().freshness == robot::Freshness::Stale);
        QVERIFY(desk.value(name)->toolTip().startsWith(QStringLiteral("Last seen ")));
    }
    QCOMPARE(desk.word("base1"), QStringLiteral("-1234.567"));
}

void TestOverviewPage::refusedSaysWhy()
{
    Desk desk;
    fill(desk.state);
    desk.state.refuse(robot::topics::basePosition, {values::ErrorKind::Refused, 0x1F, 0xA001, {}}, start);
    QCOMPARE(desk.word("base1"), QStringLiteral("—"));
    QVERIFY(desk.value("base1")->toolTip().startsWith(QStringLiteral("Refused: 0xA001")));
    QCOMPARE(desk.word("mode"), QStringLiteral("REMOTE PLAY"));
    QVERIFY(std::ranges::any_of(
        desk.page.findChildren<widgets::Line *>(QStringLiteral("reason")), [](const widgets::Line *line) {
            return line->shown().word.text.startsWith(QStringLiteral("Refused: 0xA001"));
        }));
}

void TestOverviewPage::contradictoryBitsAreShownAsReceived()
{
    using values::Status;
    Desk desk;
    desk.state.setLinkUp(true, start);
    desk.state.take<robot::Kind::Status>(1, {Status::Data1 {Status::Teach} | Status::Play, {}}, start);
    QCOMPARE(desk.word("mode"), QStringLiteral("TEACH + PLAY"));
    QVERIFY(desk.value("mode")->shown().word.lamp == widgets::Lamp::Warning);
    QCOMPARE(desk.word("cycle"), QStringLiteral("NO CYCLE"));
}

void TestOverviewPage::jobNamesInThePendantsEncoding()
{
    settings::Profile profile;
    profile.encoding = protocol::Encoding::ShiftJis;
    Desk desk {profile};
    fill(desk.state);
    desk.state.take<robot::Kind::Job>(0, {values::JobName {"\x97\x6E\x90\xDA"}, 0, 0, 10000}, start);
    QCOMPARE(desk.word("job"), QStringLiteral("溶接"));
}

void TestOverviewPage::anotherModelThanTheProfileSays()
{
    settings::Profile profile;
    profile.model = protocol::Model::FS100;
    Desk desk {profile};
    const auto complains = [&desk] {
        const auto labels = desk.page.findChildren<QLabel *>();
        return std::ranges::any_of(labels, [](const QLabel *label) {
            return label->text()
                == u"The profile says FS100, but this is the software of a YRC1000: correct the profile.";
        });
    };
    QVERIFY(!complains());
    fill(desk.state);
    QVERIFY(complains());
}

void TestOverviewPage::layers()
{
    Desk desk;
    QVERIFY(lay(desk.page, {1224, 800}));
    const auto *panel = desk.page.findChild<QWidget *>(QStringLiteral("notConnected"));
    for (const auto state : {LinkState::Checking, LinkState::Monitoring, LinkState::Lost, LinkState::Disconnected}) {
        desk.page.showLink({state, {}, {}, 0, {}});
        QCOMPARE(panel->isVisible(), state == LinkState::Disconnected);
    }
}

void TestOverviewPage::reflows_data()
{
    QTest::addColumn<int>("width");
    QTest::addColumn<int>("columns");
    QTest::newRow("1440 wide window") << 1440 - ui::space::rail << 3;
    QTest::newRow("1024 wide window") << 1024 - ui::space::rail << 2;
    QTest::newRow("half a screen") << 500 << 1;
}

void TestOverviewPage::reflows()
{
    QFETCH(int, width);
    QFETCH(int, columns);
    Desk desk;
    fill(desk.state);
    QVERIFY(lay(desk.page, {width, 700}));
    QTRY_COMPARE(desk.page.findChild<widgets::Board *>()->columns(), columns);
    QTRY_COMPARE(clipped(desk.page), QString());
}

void TestOverviewPage::longTextsAreNotClipped_data()
{
    QTest::addColumn<int>("width");
    QTest::newRow("1440 wide window") << 1440 - ui::space::rail;
    QTest::newRow("1024 wide window") << 1024 - ui::space::rail;
}

void TestOverviewPage::longTextsAreNotClipped()
{
    QFETCH(int, width);
    LongTexts translator;
    QCoreApplication::installTranslator(&translator);
    {
        Desk desk;
        fill(desk.state);
        desk.page.showStatistics({});
        QVERIFY(lay(desk.page, {width, 700}));
        QTRY_COMPARE(clipped(desk.page), QString());
        desk.state.refuse(robot::topics::status, {values::ErrorKind::Refused, 0x1F, 0xA001, {}}, start);
        QTRY_COMPARE(clipped(desk.page), QString());
    }
    QCoreApplication::removeTranslator(&translator);
}

void TestOverviewPage::stripFits_data()
{
    QTest::addColumn<int>("width");
    QTest::newRow("1440") << 1440;
    QTest::newRow("1024") << 1024;
}

void TestOverviewPage::stripFits()
{
    QFETCH(int, width);
    RobotState state;
    settings::Profile profile;
    profile.name = QStringLiteral("CELL 4 · Weld");
    profile.host = QStringLiteral("192.168.1.31");
    QWidget window;
    QVBoxLayout column(&window);
    column.setContentsMargins(0, 0, 0, 0);
    ui::RobotStrip strip(state, profile);
    column.addWidget(&strip);
    fill(state);
    strip.showLink({LinkState::Monitoring, {}, {}, 0, {}});
    QVERIFY(lay(window, {width, ui::space::strip}));
    QTRY_COMPARE(clipped(strip), QString());
    QCOMPARE(strip.width(), width);
    const auto *mode = strip.findChild<ValueLabel *>(QStringLiteral("stripMode"));
    QVERIFY(mode->width() >= mode->sizeHint().width()); // not elided
}

int main(int argc, char *argv[])
{
    QApplication application {argc, argv};
    ui::apply(application, ui::Scheme::Light);
    TestOverviewPage test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_overviewpage.moc"
