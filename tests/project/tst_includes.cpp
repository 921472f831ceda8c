// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QFileInfo>
#include <QMap>
#include <QRegularExpression>
#include <QSet>
#include <QTest>

/// Who may know whom. Every #include of core, ui and app is looked at.
class TestIncludes : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void arrowsLeadNowhereBack();
    void everyIncludeFollowsAnArrow();
    void noHeaderOfTheUiIsNamedAsOneOfTheCore();
};

namespace {

/// A folder uses itself, the folders named here, and what those use.
struct Arrow {
    const char *folder;
    const char *uses;
};
constexpr Arrow arrows[] {
    {"core/values", ""},
    {"core/disk", "core/values"},
    {"core/protocol", "core/values"},
    {"core/session", "core/protocol"},
    {"core/traffic", "core/protocol"},
    {"core/inform", "core/values"},
    {"core/motion", "core/values"},
    {"core/variables", "core/protocol"},
    {"core/cellfiles", "core/inform core/protocol core/motion core/variables"},
    {"core/cell", "core/cellfiles"},
    {"core/virtualcontroller", "core/protocol core/inform"},
    {"core/names", "core/variables core/cellfiles"},
    {"core/journal", "core/protocol core/disk"},
    {"core/settings", "core/protocol core/motion core/disk"},
    {"core/files", "core/session core/journal core/cell"},
    {"core/robot", "core/session core/motion core/names core/journal core/settings core/cell"},
    {"core/trend", "core/robot"},
    {"core/station", "core/robot core/files core/cell core/trend core/journal core/settings"},
    {"ui/look", "core/station"},
    {"ui/widgets", "ui/look"},
    {"ui/models", "ui/widgets"},
    {"ui/dialogs", "ui/models"},
    {"ui/pages", "ui/dialogs"},
    {"ui/window", "ui/pages"},
    {"app/pendesk", "ui/window core/virtualcontroller"},
    {"app/pendeskctl", "core/station"},
    {"app/pendesk-sim", "core/virtualcontroller core/settings"},
};

/// Files that still stand in another folder than the one they belong to: without their ending, and that folder.
/// Everything else directly in ui/ belongs to ui/window. A file that moves leaves this table.
struct Stray {
    const char *file;
    const char *folder;
};
constexpr Stray strays[] {
    {"ui/actioncatalog", "ui/look"},
    {"ui/alarmwords", "ui/look"},
    {"ui/appearance", "ui/look"},
    {"ui/backupage", "ui/pages"},
    {"ui/conditionwords", "ui/look"},
    {"ui/icons", "ui/look"},
    {"ui/language", "ui/look"},
    {"ui/linkview", "ui/look"},
    {"ui/orderwords", "ui/look"},
    {"ui/plainstyle", "ui/look"},
    {"ui/readinesswords", "ui/look"},
    {"ui/theme", "ui/look"},
    {"ui/words", "ui/look"},
};

/// Includes against the arrows that are still there. The list only ever gets shorter: a row that is not needed any more
/// makes the test fail as well.
struct Include {
    const char *file;
    const char *header;
};
constexpr Include exceptions[] {
    {"ui/dialogs/helpdialog.cpp", "ui/pagecatalog.h"},
    {"ui/readinesswords.h", "ui/widgets/shown.h"},
    {"ui/words.h", "ui/widgets/shown.h"},
    {"ui/widgets/armcontrol.cpp", "ui/dialogs/whynotdialog.h"},
    {"ui/widgets/lampdelegate.h", "ui/models/iomodel.h"},
    {"ui/widgets/orderbutton.cpp", "ui/dialogs/whynotdialog.h"},
};

/// Names of headers that both have, and that one of them is still to give up.
constexpr const char *doubleNames[] {"appearance.h", "text.h"};

QString latin(const char *text) { return QString::fromLatin1(text); }

QDir root() { return QDir {latin(PENDESK_TEST_DATA "/../..")}; }

/// Paths from the root of the tree.
QStringList sources(const QStringList &folders, const QStringList &endings)
{
    QStringList found;
    for (const QString &folder : folders) {
        QDirIterator files {root().filePath(folder), endings, QDir::Files, QDirIterator::Subdirectories};
        while (files.hasNext())
            found << QDir::cleanPath(root().relativeFilePath(files.next()));
    }
    found.sort();
    return found;
}

/// The folders that a folder may use, by the table.
QStringList usedBy(const QString &folder)
{
    for (const Arrow &arrow : arrows) {
        if (folder == latin(arrow.folder))
            return latin(arrow.uses).split(u' ', Qt::SkipEmptyParts);
    }
    return {};
}

/// Itself and all that it may use, however far away.
QSet<QString> reachable(const QString &folder)
{
    QSet<QString> found {folder};
    for (const QString &used : usedBy(folder))
        found += reachable(used);
    return found;
}

/// The folder of the table that a file belongs to; empty if there is none.
QString folderOf(const QString &file)
{
    for (const Stray &stray : strays) {
        if (file.section(u'.', 0, 0) == latin(stray.file))
            return latin(stray.folder);
    }
    if (file.count(u'/') == 1 && file.startsWith(u"ui/"))
        return QStringLiteral("ui/window");
    for (const Arrow &arrow : arrows) {
        if (file.startsWith(latin(arrow.folder) + u'/'))
            return latin(arrow.folder);
    }
    return {};
}

QStringList includesOf(const QString &file)
{
    static const QRegularExpression include {
        QStringLiteral("^\\s*#\\s*include\\s+\"([^\"]+)\""), QRegularExpression::MultilineOption};
    QFile source {root().filePath(file)};
    if (!source.open(QIODevice::ReadOnly))
        return {QStringLiteral("%1 cannot be read").arg(file)};
    QStringList found;
    auto matches = include.globalMatch(QString::fromUtf8(source.readAll()));
    while (matches.hasNext())
        found << matches.next().captured(1);
    return found;
}

/// The path of what `file` includes as `name`, from the root of the tree; empty if it is not there.
QString resolved(const QString &file, const QString &name)
{
    for (const QString &folder : {QFileInfo {file}.path(), QStringLiteral("core"), QStringLiteral(".")}) {
        const QString path = QDir::cleanPath(folder + u'/' + name);
        if (QFileInfo::exists(root().filePath(path)))
            return path;
    }
    return {};
}

bool isException(const QString &file, const QString &header)
{
    return std::ranges::any_of(
        exceptions, [&](const Include &known) { return file == latin(known.file) && header == latin(known.header); });
}

/// What is against the arrows, exceptions included, as "file includes header".
QMap<QString, bool> wrongIncludes()
{
    QMap<QString, bool> wrong;
    for (const QString &file : sources({QStringLiteral("core"), QStringLiteral("ui"), QStringLiteral("app")},
             {QStringLiteral("*.h"), QStringLiteral("*.cpp")})) {
        const QSet<QString> allowed = reachable(folderOf(file));
        for (const QString &name : includesOf(file)) {
            const QString header = resolved(file, name);
            if (folderOf(file).isEmpty() || header.isEmpty() || !allowed.contains(folderOf(header)))
                wrong.insert(QStringLiteral("%1 includes %2").arg(file, header.isEmpty() ? name : header),
                    isException(file, header));
        }
    }
    return wrong;
}

} // namespace

void TestIncludes::arrowsLeadNowhereBack()
{
    // Each folder uses only those that stand above it in the table: then there is no circle.
    QSet<QString> above;
    for (const Arrow &arrow : arrows) {
        for (const QString &used : usedBy(latin(arrow.folder)))
            QVERIFY2(above.contains(used), qPrintable(latin(arrow.folder) + QStringLiteral(" uses ") + used));
        above << latin(arrow.folder);
    }
}

void TestIncludes::everyIncludeFollowsAnArrow()
{
    const auto wrong = wrongIncludes();
    QStringList faults;
    for (auto found = wrong.begin(); found != wrong.end(); ++found) {
        if (!found.value())
            faults << found.key();
    }
    for (const Include &known : exceptions) {
        const QString words = QStringLiteral("%1 includes %2").arg(latin(known.file), latin(known.header));
        if (!wrong.contains(words))
            faults << words + QStringLiteral(" no more: its row can go");
    }
    QVERIFY2(faults.isEmpty(), qPrintable(faults.join(u'\n')));
}

void TestIncludes::noHeaderOfTheUiIsNamedAsOneOfTheCore()
{
    const QStringList headers {QStringLiteral("*.h")};
    QSet<QString> core;
    for (const QString &file : sources({QStringLiteral("core")}, headers))
        core << QFileInfo {file}.fileName();
    QVERIFY(!core.isEmpty());
    QStringList names;
    for (const QString &file : sources({QStringLiteral("ui")}, headers)) {
        if (const QString name = QFileInfo {file}.fileName(); core.contains(name))
            names << name;
    }
    names.sort();
    QStringList known;
    for (const char *name : doubleNames)
        known << latin(name);
    QCOMPARE(names, known);
}

QTEST_APPLESS_MAIN(TestIncludes)
#include "tst_includes.moc"
