// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/alldialogs.h"
#include "ui/fit.h"
#include "ui/harness.h"
#include "ui/pseudolocale.h"

#include "ui/language.h"
#include "ui/pagecatalog.h"
#include <QRegularExpression>
#include <QStandardPaths>

namespace {

constexpr int readTime = 20000; ///< ms; a page may want a hundred answers of a busy computer.
constexpr int layoutTime = 500; ///< ms in which a layout follows its words.
constexpr QSize sizes[] {{1440, 900}, {1024, 768}};

struct Speech {
    const char *language; ///< "pseudo", or a code of ours.
    qreal fontScale = 1;
};

constexpr Speech speeches[] {{"pseudo"}, {"en"}, {"de"}, {"ja"}, {"de", 1.25}};

/// What is the same in every language.
const QStringList sameEverywhere {
    // what the virtual controller and its profile are called, and where files are kept here
    QStringLiteral("CELL 4 · Weld"),
    QStringLiteral("PENDESK VIRTUAL"),
    QStringLiteral("VIRTUAL-A00"),
    QStringLiteral("MOVJ"),
    QStringLiteral("VJ"),
    QStringLiteral("WELD_A12"),
    QStringLiteral("UNCLAMP"),
    QStringLiteral("CLAMP"),
    QStringLiteral("TIPDRESS"),
    QStringLiteral("Pendesk backups"),
    // robot words as on the pendant: axes, kinds of variables and of files; and what must be typed to start
    QStringLiteral("Rx"),
    QStringLiteral("Ry"),
    QStringLiteral("Rz"),
    QStringLiteral("BP"),
    QStringLiteral("EX"),
    QStringLiteral("JBI"),
    QStringLiteral("DAT"),
    QStringLiteral("CND"),
    QStringLiteral("PRM"),
    QStringLiteral("SYS"),
    QStringLiteral("LST"),
    QStringLiteral("START"),
    // names of products, encodings and keys
    QStringLiteral("DX100"),
    QStringLiteral("DX200"),
    QStringLiteral("FS100"),
    QStringLiteral("YRC1000micro"),
    QStringLiteral("YRC1000"),
    QStringLiteral("UTF-8"),
    QStringLiteral("Shift_JIS"),
    QStringLiteral("GBK"),
    QStringLiteral("Big5"),
    QStringLiteral("EUC-KR"),
    QStringLiteral("ISO-8859-1"),
    QStringLiteral("Del"),
    // a unit
    QStringLiteral("mm"),
};

/// Words with Latin letters that were not translated, of what a widget shows.
QStringList untranslated(const QWidget &widget)
{
    static const QRegularExpression latin(QStringLiteral("[A-Za-z]{2,}"));
    QStringList result;
    for (const QString &text : fit::words(widget)) {
        QString rest = text;
        rest.remove(QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation));
        for (const QString &same : sameEverywhere)
            rest.remove(same);
        if (latin.match(rest).hasMatch())
            result << QStringLiteral("%1: “%2” of “%3”").arg(fit::nameOf(widget), latin.match(rest).captured(), text);
    }
    return result;
}

/// A live window that speaks so; the next one takes its place.
class SpokenWindow
{
public:
    explicit SpokenWindow(const Speech &speech) : m_fontScale {speech.fontScale}
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
    [[nodiscard]] QDialog *create(const DialogRow &row) const { return row.create(*m_harness); }
    [[nodiscard]] ui::MainWindow &window() const { return m_harness->window; }

    /// Opens the page and waits until what it wants was read.
    [[nodiscard]] pages::Page *open(int row) const
    {
        m_harness->window.view().openPage(row);
        pages::Page *page = m_harness->window.view().page(row);
        const bool isRead = QTest::qWaitFor(
            [&] {
                return std::ranges::all_of(page->topics(), [&](const robot::TopicRange &range) {
                    return m_harness->state().freshness({range.kind, range.last}) != robot::Freshness::Unknown;
                });
            },
            readTime);
        return isRead ? page : nullptr;
    }
    void resize(const QSize &size) const
    {
        m_harness->window.resize(size);
        QCoreApplication::sendPostedEvents();
    }
    /// With the width before each, as words may have come since the last layout: ask again.
    [[nodiscard]] QStringList findings(const QSize &size) const
    {
        QStringList found = fit::findings(window());
        if (size == sizes[0] && m_fontScale == 1)
            found << fit::sidewaysScrolled(window());
        if (window().size() != size)
            found << QStringLiteral("the window is %1 x %2").arg(window().width()).arg(window().height());
        for (QString &finding : found)
            finding.prepend(QStringLiteral("%1 px: ").arg(size.width()));
        return found;
    }

private:
    qreal m_fontScale;
    QFont m_font = QApplication::font();
    PseudoLocale m_pseudo;
    std::unique_ptr<Harness> m_harness;
    bool m_isLive = false;
};

bool isPseudo(int speech) { return QLatin1String(speeches[speech].language) == QLatin1String("pseudo"); }

int rowOf(const char *id)
{
    const auto found = std::ranges::find(
        ui::pageCatalog(), QLatin1String(id), [](const ui::PageRow &row) { return QLatin1String(row.id); });
    return int(found - ui::pageCatalog().begin());
}

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
    void dialogsHaveRoom_data();
    void dialogsHaveRoom();
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
    if (isPseudo(speech)) {
        for (const QWidget *widget : fit::visibleWidgets(spoken.window()))
            findings << untranslated(*widget);
    }
    for (const QSize &size : sizes) {
        if (speeches[speech].fontScale > 1 && size != sizes[0])
            continue; // bigger words need a bigger window
        spoken.resize(size);
        QStringList now;
        const auto hasRoom = [&] { return (now = spoken.findings(size)).isEmpty(); };
        if (!QTest::qWaitFor(hasRoom, layoutTime))
            findings << now;
        if (qEnvironmentVariableIsSet("PENDESK_GRAB"))
            spoken.window().grab().save(QStringLiteral(PENDESK_PICTURES "/fit-%1-%2-%3.png")
                                            .arg(QLatin1String(speeches[speech].language))
                                            .arg(row)
                                            .arg(size.width()));
    }
    QVERIFY(isNothing(findings));
}

void TestPseudoLocale::dialogsHaveRoom_data()
{
    QTest::addColumn<int>("speech");
    QTest::addColumn<int>("row");
    for (int speech = 0; speech < int(std::size(speeches)); ++speech) {
        for (int row = 0; row < int(allDialogs().size()); ++row)
            QTest::addRow("%s %g, %s", speeches[speech].language, speeches[speech].fontScale, allDialogs()[row].name)
                << speech << row;
    }
}

void TestPseudoLocale::dialogsHaveRoom()
{
    QFETCH(int, speech);
    QFETCH(int, row);
    const SpokenWindow &spoken = speak(speech);
    QVERIFY(spoken.isLive());
    QVERIFY(spoken.open(rowOf("motion"))); // a move begins where the robot is
    std::unique_ptr<QDialog> dialog;
    QTRY_VERIFY((dialog.reset(spoken.create(allDialogs()[row])), dialog));
    dialog->setAttribute(Qt::WA_DeleteOnClose, false);
    dialog->show();
    QStringList findings;
    const auto hasRoom = [&] {
        findings = fit::findings(*dialog) + fit::sidewaysScrolled(*dialog);
        return findings.isEmpty();
    };
    std::ignore = QTest::qWaitFor(hasRoom, layoutTime); // words that come later move the others
    if (isPseudo(speech)) {
        for (const QWidget *widget : fit::visibleWidgets(*dialog))
            findings << untranslated(*widget);
    }
    if (qEnvironmentVariableIsSet("PENDESK_GRAB"))
        dialog->grab().save(QStringLiteral(PENDESK_PICTURES "/fit-dialog-%1-%2.png")
                                .arg(QLatin1String(speeches[speech].language))
                                .arg(row));
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
