// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/harness.h"

#include <QDir>

using robot::LinkState;
using robot::Topic;

namespace {

values::Error refusal() { return {values::ErrorKind::Refused, 0x1F, 0xA001, {}}; }

/// What each picture shows; returns whether the window got there.
struct Scene {
    const char *name;
    bool (*arrange)(Harness &);
};

bool live(Harness &harness)
{
    return harness.connectLive()
        && QTest::qWaitFor([&] { return harness.window.controller().statistics().seconds.size() > 2; });
}

bool stale(Harness &harness)
{
    if (!live(harness))
        return false;
    harness.stopController();
    return QTest::qWaitFor([&] { return harness.window.controller().linkState() == LinkState::Lost; });
}

bool checking(Harness &harness)
{
    if (!harness.startController())
        return false;
    harness.stopController();
    harness.window.show();
    harness.window.connectTo(harness.profile());
    return QTest::qWaitFor([&] { return harness.window.controller().trouble().has_value(); });
}

bool refused(Harness &harness)
{
    if (!live(harness))
        return false;
    for (const robot::Topic topic : robot::topics::overview)
        harness.state().refuse(topic, refusal(), std::chrono::steady_clock::now());
    return true;
}

bool troubled(Harness &harness)
{
    if (!live(harness))
        return false;
    using values::Status;
    harness.server->memory().status = {
        Status::Data1 {Status::Teach} | Status::Play | Status::Remote | Status::Step | Status::SpeedLimited,
        Status::Data2 {Status::Alarm} | Status::Error | Status::HeldByPendant | Status::HeldExternally
            | Status::HeldByCommand};
    const auto hasRoom = [&](const char *name) {
        return harness.value(name)->width() >= harness.value(name)->minimumSizeHint().width();
    };
    return QTest::qWaitFor([&] { return harness.word("alarm") == u"ALARM" && hasRoom("mode"); });
}

bool notConnected(Harness &harness)
{
    harness.window.offer(harness.profile());
    harness.window.show();
    return true;
}

constexpr Scene scenes[] {
    {"notconnected", notConnected},
    {"checking", checking},
    {"live", live},
    {"stale", stale},
    {"refused", refused},
    {"troubled", troubled},
};

} // namespace

/// Writes what a person would see to the build folder, to be looked at; and sees that nothing is blank.
class TestPictures : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void pictures_data();
    void pictures();
};

void TestPictures::pictures_data()
{
    QTest::addColumn<int>("scene");
    QTest::addColumn<QSize>("size");
    for (int i = 0; i < int(std::size(scenes)); ++i) {
        QTest::addRow("%s, large", scenes[i].name) << i << QSize(1440, 900);
        QTest::addRow("%s, small", scenes[i].name) << i << QSize(1024, 768);
    }
}

void TestPictures::pictures()
{
    QFETCH(int, scene);
    QFETCH(QSize, size);
    Harness harness;
    harness.window.resize(size);
    QVERIFY(scenes[scene].arrange(harness));
    QVERIFY(QDir().mkpath(QStringLiteral(PENDESK_PICTURES)));
    for (const ui::Scheme scheme : {ui::Scheme::Light, ui::Scheme::Dark}) {
        ui::apply(*qApp, scheme);
        QCoreApplication::sendPostedEvents(); // layouts, and no reads
        const QImage image = harness.window.grab().toImage();
        QCOMPARE(image.deviceIndependentSize().toSize(), size);
        QVERIFY(image.save(QStringLiteral("%1/overview-%2-%3-%4.png")
                               .arg(QStringLiteral(PENDESK_PICTURES), QLatin1String(scenes[scene].name),
                                   scheme == ui::Scheme::Light ? QStringLiteral("light") : QStringLiteral("dark"))
                               .arg(size.width())));
    }
    ui::apply(*qApp, ui::Scheme::Light);
}

int main(int argc, char *argv[])
{
    QApplication application {argc, argv};
    ui::apply(application, ui::Scheme::Light);
    TestPictures test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_pictures.moc"
