// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/fit.h"
#include "ui/harness.h"
#include "ui/pseudolocale.h"

#include "ui/language.h"
#include "ui/pagecatalog.h"
#include <QDir>

namespace {

constexpr QSize sizes[] {{1440, 900}, {1024, 768}};

struct Speech {
    const char *language; ///< "pseudo", or a code of ours.
    qreal fontScale = 1;
};

constexpr Speech speeches[] {{"pseudo"}, {"en"}, {"de"}, {"ja"}, {"de", 1.25}};

/// A live window that speaks so; the next one takes its place.
class SpokenWindow
{
public:
    explicit SpokenWindow(const Speech &speech)
    {
        QFont font = m_font;
        font.setPointSizeF(font.pointSizeF() * speech.fontScale);
        QApplication::setFont(font);
        if (QLatin1String(speech.language) == QLatin1String("pseudo"))
            QCoreApplication::installTranslator(&m_pseudo);
        else
            ui::speak(*qApp, QLatin1String(speech.language));
        m_harness = std::make_unique<Harness>();
        m_isLive = m_harness->connectLive();
    }
    ~SpokenWindow()
    {
        m_harness.reset();
        QCoreApplication::removeTranslator(&m_pseudo);
        ui::speak(*qApp, QStringLiteral("en"));
        QApplication::setFont(m_font);
    }
    Q_DISABLE_COPY_MOVE(SpokenWindow)

    [[nodiscard]] bool isLive() const { return m_isLive; }
    [[nodiscard]] ui::MainWindow &window() const { return m_harness->window; }

    /// Opens the page and waits until what it wants was read.
    [[nodiscard]] pages::Page *open(int row) const
    {
        m_harness->window.view().openPage(row);
        pages::Page *page = m_harness->window.view().pages()[row];
        const bool isRead = QTest::qWaitFor([&] {
            return std::ranges::all_of(page->topics(), [&](const robot::TopicRange &range) {
                return m_harness->state().freshness({range.kind, range.last}) != robot::Freshness::Unknown;
            });
        });
        return isRead ? page : nullptr;
    }
    void resize(const QSize &size) const
    {
        m_harness->window.resize(size);
        settle();
    }
    static void settle()
    {
        QCoreApplication::processEvents();
        QCoreApplication::sendPostedEvents(); // layouts, and no reads
    }

private:
    QFont m_font = QApplication::font();
    PseudoLocale m_pseudo;
    std::unique_ptr<Harness> m_harness;
    bool m_isLive = false;
};

/// Says each of them, so that all can be mended at once.
bool isNothing(const QStringList &findings)
{
    for (const QString &finding : findings)
        qWarning().noquote() << finding;
    return findings.isEmpty();
}

} // namespace

/// Nothing on the screen is cut off, in a language two fifths longer than English and in real ones, and everything was
/// translated.
class TestPseudoLocale : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void pagesHaveRoom_data();
    void pagesHaveRoom();
    void cleanupTestCase() { m_spoken.reset(); }

private:
    [[nodiscard]] SpokenWindow &speak(int speech);

    std::unique_ptr<SpokenWindow> m_spoken;
    int m_speech = -1;
};

SpokenWindow &TestPseudoLocale::speak(int speech)
{
    if (speech != m_speech) {
        m_spoken.reset();
        m_spoken = std::make_unique<SpokenWindow>(speeches[speech]);
        m_speech = speech;
    }
    return *m_spoken;
}

void TestPseudoLocale::pagesHaveRoom_data()
{
    QTest::addColumn<int>("speech");
    QTest::addColumn<int>("row");
    for (int speech = 0; speech < int(std::size(speeches)); ++speech) {
        for (int row = 0; row < int(ui::pageCatalog().size()); ++row)
            QTest::addRow("%s %g, %s", speeches[speech].language, speeches[speech].fontScale, ui::pageCatalog()[row].id)
                << speech << row;
    }
}

void TestPseudoLocale::pagesHaveRoom()
{
    QFETCH(int, speech);
    QFETCH(int, row);
    const SpokenWindow &spoken = speak(speech);
    QVERIFY(spoken.isLive());
    QVERIFY(spoken.open(row));
    QStringList findings;
    spoken.resize({1024, 768});
    const std::function<void(const QWidget *, int)> dump = [&](const QWidget *widget, int depth) {
        const int hint = widget->minimumSizeHint().width();
        if ((hint > 400 || (row == 8 && hint > 100)) && widget->isVisible())
            qWarning().noquote() << "DUMP" << QString(depth, u' ') << fit::nameOf(*widget) << widget->minimumSizeHint();
        for (auto *child : widget->children())
            if (auto *inner = qobject_cast<QWidget *>(child); inner && !inner->isWindow())
                dump(inner, depth + 1);
    };
    dump(spoken.window().view().pages()[row], 0);
    if (row == 0)
        dump(&spoken.window(), 0);
    for (const QSize &size : sizes) {
        spoken.resize(size);
        const QString mark = QStringLiteral("%1 px: ").arg(size.width());
        for (const QString &finding : fit::findings(spoken.window()))
            findings << mark + finding;
        if (size.width() == 1440) {
            for (const QString &finding : fit::sidewaysScrolled(spoken.window()))
                findings << mark + finding;
        }
        if (spoken.window().size() != size)
            findings << mark
                    + QStringLiteral("the window is %1 x %2").arg(spoken.window().width()).arg(spoken.window().height());
        if (qEnvironmentVariableIsSet("PENDESK_GRAB"))
            spoken.window().grab().save(QStringLiteral(PENDESK_PICTURES "/fit-%1-%2-%3.png").arg(speech).arg(row).arg(size.width()));
    }
    QVERIFY(isNothing(findings));
}

int main(int argc, char *argv[])
{
    QApplication application {argc, argv};
    ui::apply(application, ui::Scheme::Light);
    TestPseudoLocale test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_pseudolocale.moc"
