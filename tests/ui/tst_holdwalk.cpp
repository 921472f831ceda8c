// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/alldialogs.h"
#include "ui/pagecatalog.h"
#include "ui/pagewindow.h"
#include "ui/robotstrip.h"
#include "ui/widgets/holdbutton.h"
#include "ui/widgets/sheetlayer.h"
#include "ui/words.h"

#include <QPushButton>
#include <QRandomGenerator>

using namespace std::chrono_literals;
using robot::HoldState;
using values::Status;

namespace {

constexpr int events = 20'000;
constexpr int outages = 4; ///< Lost links among them: each takes its time.
/// What a strip may lag behind its controller, which looks at its clock now and then.
constexpr std::chrono::milliseconds lags[] {0ms, 60ms, 200ms, 1000ms};

} // namespace

/// A window, a second one, sheets, lost links and every mode, in an order that nobody would think of.
class TestHoldWalk : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void wordsAreBitsAndOrder()
    {
        m_harness.readTimeout = 200ms; // a lost link is noticed sooner
        QVERIFY(m_harness.connectLive());
        m_harness.access().enter(robot::Level::Engineer);
        m_harness.window.view().openInWindow(QStringLiteral("alarms"));
        connect(&m_harness.window.view().orders(), &robot::Orders::recorded, this,
            [this](const journal::OrderRecord &record) { m_orders += record.action != QLatin1String("hold"); });
        for (int i = 0; i < events; ++i) {
            step();
            if (i % 8 == 0)
                QCoreApplication::processEvents();
            if (i % (events / outages) == events / (2 * outages))
                loseTheLink();
            const QString wrong = wrongWords();
            QVERIFY2(wrong.isEmpty(), qPrintable(QStringLiteral("event %1: %2").arg(i).arg(wrong)));
            QCOMPARE(m_orders, 0);
        }
    }

private:
    void step()
    {
        switch (m_random.bounded(12)) {
        case 0: return toggle(Status::HeldByCommand);
        case 1: return toggle(Status::HeldByPendant);
        case 2: return toggle(Status::HeldExternally);
        case 3: return toggleMode();
        case 4: return Q_EMIT holds().at(m_random.bounded(int(holds().size())))->holdRequested();
        case 5: return press(Qt::Key_Pause);
        case 6: return press(Qt::Key_Return);
        case 7: return press(Qt::Key_Tab);
        case 8: return press(Qt::Key_Escape);
        case 9: return openSheet();
        case 10: return openPage();
        default: return readStatus();
        }
    }

    void toggle(Status::Data2Flag flag)
    {
        memory().status.data2 ^= flag;
        readStatus();
    }
    void toggleMode()
    {
        memory().status.data1 ^= m_random.bounded(2) ? Status::Running : Status::Teach;
        readStatus();
    }
    /// As if it had been polled just now.
    void readStatus()
    {
        if (m_harness.window.controller().linkState() == robot::LinkState::Monitoring)
            m_harness.state().take<robot::Kind::Status>(1, memory().status, values::now());
    }
    void press(Qt::Key key)
    {
        QWidget *focus = QApplication::focusWidget();
        QTest::keyClick(focus ? focus : &m_harness.window, key);
    }
    void openSheet()
    {
        if (m_random.bounded(20) != 0)
            return;
        const auto rows = allDialogs();
        if (QDialog *dialog = rows[m_random.bounded(quint32(rows.size()))].create(m_harness))
            dialog->show();
        if (widgets::SheetLayer::of(&m_harness.window)->sheets().size() > 3)
            widgets::SheetLayer::of(&m_harness.window)->clear();
    }
    void openPage()
    {
        if (m_random.bounded(20) == 0 && !widgets::SheetLayer::of(&m_harness.window)->isOpen())
            m_harness.window.view().openPage(m_random.bounded(int(ui::pageCatalog().size())));
    }
    void loseTheLink()
    {
        auto &controller = m_harness.window.controller();
        m_harness.server->setFaults(*virtualcontroller::Faults::parse(u"any request lose"));
        QTRY_VERIFY(controller.linkState() == robot::LinkState::Lost);
        QCOMPARE(wrongWords(), QString());
        m_harness.server->setFaults(virtualcontroller::Faults {});
        QTRY_VERIFY(controller.linkState() == robot::LinkState::Monitoring);
    }

    [[nodiscard]] virtualcontroller::Memory &memory() const { return m_harness.server->memory(); }
    /// Those of the strips: HOLD ALL speaks of stations, not of one controller's bits.
    [[nodiscard]] QList<widgets::HoldButton *> holds() const
    {
        return m_harness.window.findChildren<widgets::HoldButton *>(QStringLiteral("holdButton"));
    }

    /// A strip that says what neither the bits nor the order say.
    [[nodiscard]] QString wrongWords() const
    {
        const robot::HoldFacts facts = m_harness.window.controller().holdFacts();
        QStringList right;
        for (const auto lag : lags)
            right << ui::holdCaption(robot::holdState(facts, values::now() - lag));
        for (const widgets::HoldButton *hold : holds()) {
            if (!right.contains(hold->caption()))
                return QStringLiteral("“%1” instead of “%2”").arg(hold->caption(), right.first());
        }
        return {};
    }

    Harness m_harness;
    QRandomGenerator m_random {15};
    int m_orders = 0; ///< But HOLD.
};

int main(int argc, char *argv[])
{
    QApplication application {argc, argv};
    ui::apply(application, ui::Scheme::Light);
    TestHoldWalk test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_holdwalk.moc"
