// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/harness.h"

#include "protocol/catalog.h"
#include "ui/language.h"
#include "ui/pagecatalog.h"
#include "ui/pages/page.h"
#include <QDir>

using robot::LinkState;

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
        harness.state().refuse(topic, refusal(), values::now());
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

/// Opens each page and waits until what it wants was answered or refused.
bool visitAllPages(Harness &harness)
{
    for (int row = 0; row < int(ui::pageCatalog().size()); ++row) {
        harness.window.view().openPage(row);
        const pages::Page *page = harness.window.view().page(row);
        const bool isRead = QTest::qWaitFor([&] {
            return std::ranges::all_of(page->topics(), [&](const robot::TopicRange &range) {
                return harness.state().freshness({range.kind, range.last}) != robot::Freshness::Unknown;
            });
        });
        if (!isRead)
            return false;
    }
    return true;
}

bool livePages(Harness &harness) { return live(harness) && visitAllPages(harness); }

bool stalePages(Harness &harness)
{
    if (!livePages(harness))
        return false;
    harness.stopController();
    return QTest::qWaitFor([&] { return harness.window.controller().linkState() == LinkState::Lost; });
}

/// Everything but status and system information is refused.
bool refusedPages(Harness &harness)
{
    if (!harness.startController())
        return false;
    std::vector<virtualcontroller::FaultRule> rules;
    for (const protocol::Command &row : protocol::commands()) {
        if (row.number != 0x72 && row.number != 0x89)
            rules.push_back({.command = row.number,
                .direction = virtualcontroller::Direction::Request,
                .kind = virtualcontroller::FaultKind::Refuse,
                .code = 0x2110});
    }
    harness.server->setFaults(virtualcontroller::Faults {rules});
    harness.window.show();
    harness.window.connectTo(harness.profile());
    return QTest::qWaitFor([&] { return harness.window.controller().linkState() == LinkState::Monitoring; })
        && visitAllPages(harness);
}

constexpr Scene pageScenes[] {
    {"live", livePages},
    {"stale", stalePages},
    {"refused", refusedPages},
    {"notconnected", notConnected},
};

} // namespace

/// Writes what a person would see to the build folder, to be looked at; and sees that nothing is blank.
class TestPictures : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void overview_data();
    void overview();
    void everyPage_data();
    void everyPage();

private:
    static bool write(Harness &harness, const QString &name, ui::Scheme scheme);
};

/// The window as it is, in light or dark.
bool TestPictures::write(Harness &harness, const QString &name, ui::Scheme scheme)
{
    if (ui::schemeOf(QApplication::palette()) != scheme)
        ui::apply(*qApp, scheme);
    QCoreApplication::sendPostedEvents(); // layouts, and no reads
    const QImage image = harness.window.grab().toImage();
    const QString word = scheme == ui::Scheme::Light ? QStringLiteral("light") : QStringLiteral("dark");
    return image.deviceIndependentSize().toSize() == harness.window.size()
        && QDir().mkpath(QStringLiteral(PENDESK_PICTURES))
        && image.save(QStringLiteral("%1/%2-%3.png").arg(QStringLiteral(PENDESK_PICTURES), name, word));
}

void TestPictures::overview_data()
{
    QTest::addColumn<int>("scene");
    QTest::addColumn<QSize>("size");
    for (int i = 0; i < int(std::size(scenes)); ++i) {
        QTest::addRow("%s, large", scenes[i].name) << i << QSize(1440, 900);
        QTest::addRow("%s, small", scenes[i].name) << i << QSize(1024, 768);
    }
}

void TestPictures::overview()
{
    QFETCH(int, scene);
    QFETCH(QSize, size);
    Harness harness;
    harness.window.resize(size);
    QVERIFY(scenes[scene].arrange(harness));
    for (const ui::Scheme scheme : {ui::Scheme::Light, ui::Scheme::Dark})
        QVERIFY(write(harness,
            QStringLiteral("overview-%1-%2").arg(QLatin1String(scenes[scene].name)).arg(size.width()), scheme));
    ui::apply(*qApp, ui::Scheme::Light);
}

void TestPictures::everyPage_data()
{
    QTest::addColumn<int>("scene");
    QTest::addColumn<QString>("language");
    QTest::addColumn<QSize>("size");
    for (int i = 0; i < int(std::size(pageScenes)); ++i)
        QTest::newRow(pageScenes[i].name) << i << QStringLiteral("en") << QSize(1440, 900);
    QTest::newRow("live, German") << 0 << QStringLiteral("de") << QSize(1440, 900);
    QTest::newRow("live, Japanese") << 0 << QStringLiteral("ja") << QSize(1440, 900);
}

void TestPictures::everyPage()
{
    QFETCH(int, scene);
    QFETCH(QString, language);
    QFETCH(QSize, size);
    QVERIFY(ui::speak(*qApp, language));
    Harness harness;
    harness.window.resize(size);
    QVERIFY(pageScenes[scene].arrange(harness));
    for (int row = 0; row < int(ui::pageCatalog().size()); ++row) {
        harness.window.view().openPage(row);
        const QString name =
            QStringLiteral("page-%1-%2-%3-%4")
                .arg(QLatin1String(ui::pageCatalog()[row].id), QLatin1String(pageScenes[scene].name), language)
                .arg(size.width());
        QVERIFY2(write(harness, name, ui::Scheme::Light), qPrintable(name));
    }
    QVERIFY(ui::speak(*qApp, QStringLiteral("en")));
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
