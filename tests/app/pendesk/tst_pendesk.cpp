// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include <QDir>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

/// The program as a person starts it.
class TestPendesk : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void options_data();
    void options();
    void demoWritesPictures();
    void nobodyAnswers();

private:
    struct Outcome {
        int exitCode;
        QString out;
        QString err;
    };
    [[nodiscard]] Outcome run(const QStringList &arguments) const
    {
        QProcess process;
        auto environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("XDG_CONFIG_HOME"), m_folder.path());
        environment.insert(QStringLiteral("XDG_DATA_HOME"), m_folder.path());
        process.setProcessEnvironment(environment);
        process.start(QStringLiteral(PENDESK_BIN "/pendesk"), arguments);
        if (!process.waitForFinished(60000))
            return {-1, {}, process.errorString()};
        return {process.exitCode(), QString::fromUtf8(process.readAllStandardOutput()),
            QString::fromUtf8(process.readAllStandardError())};
    }
    QTemporaryDir m_folder;
};

void TestPendesk::options_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("exitCode");
    QTest::addColumn<QString>("says");
    const auto row = [](const char *arguments, int exitCode, const char *says) {
        QTest::newRow(arguments) << QString::fromUtf8(arguments).split(u' ') << exitCode << QString::fromUtf8(says);
    };
    row("--version", 0, "pendesk " PENDESK_VERSION);
    row("--help", 0, "--pictures");
    row("--nonsense", 2, "nonsense");
    row("positional", 2, "positional");
    row("--theme grey", 2, "light, dark or auto");
    row("--host h --port 0", 2, "--port must be a whole number from 1 to 65535");
    row("--host h --port 65536", 2, "--port must be");
    row("--host h --file-port x", 2, "--file-port must be");
    row("--port 10040", 2, "--port needs --host or --profile");
    row("--profile nobody", 2, "“nobody”");
    row("--demo --host h", 2, "--demo brings its own controller");
    row("--pictures p", 2, "--pictures needs");
}

void TestPendesk::options()
{
    QFETCH(QStringList, arguments);
    QFETCH(int, exitCode);
    QFETCH(QString, says);
    const Outcome outcome = run(arguments);
    QCOMPARE(outcome.exitCode, exitCode);
    const QString &stream = exitCode == 0 ? outcome.out : outcome.err;
    QVERIFY2(stream.contains(says), qPrintable(stream));
}

void TestPendesk::demoWritesPictures()
{
    const QString pictures = m_folder.filePath(QStringLiteral("pictures"));
    const Outcome outcome = run({QStringLiteral("--demo"), QStringLiteral("--pictures"), pictures});
    QVERIFY2(outcome.exitCode == 0, qPrintable(outcome.err));
    QVERIFY2(outcome.out.contains(QStringLiteral("Mode: REMOTE PLAY")), qPrintable(outcome.out));
    const QStringList files = QDir(pictures).entryList(QDir::Files, QDir::Name);
    QStringList expected;
    for (const auto *page : {"alarms", "backup", "files", "fleet", "io", "jobs", "journal", "motion", "overview",
             "position", "registers", "trend", "variables"}) {
        for (const auto *state : {"live", "notconnected"}) {
            for (const auto *scheme : {"dark", "light"})
                expected << QStringLiteral("%1-%2-%3.png")
                                .arg(QLatin1String(page), QLatin1String(state), QLatin1String(scheme));
        }
    }
    QCOMPARE(files, expected);
}

void TestPendesk::nobodyAnswers()
{
    const Outcome outcome = run({QStringLiteral("--host"), QStringLiteral("127.0.0.1"), QStringLiteral("--port"),
        QStringLiteral("9"), QStringLiteral("--pictures"), m_folder.filePath(QStringLiteral("none"))});
    QCOMPARE(outcome.exitCode, 3);
    QVERIFY2(outcome.err.contains(QStringLiteral("no live controller within 5 s")), qPrintable(outcome.err));
}

QTEST_GUILESS_MAIN(TestPendesk)
#include "tst_pendesk.moc"
