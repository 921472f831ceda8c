// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "values/foreigntext.h"
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

using namespace values;

/// Text from outside, for each place where it is put.
class TestForeignText : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void onOneLine_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("line");
        const auto row = [](const char *name, const QString &text, const QString &line) {
            QTest::newRow(name) << text << line;
        };
        row("plain", QStringLiteral("WELD 1 ÄÖ テスト 😀"), QStringLiteral("WELD 1 ÄÖ テスト 😀"));
        row("escape sequence", QStringLiteral("a\x1b[31mb"), QStringLiteral("a⟨1B⟩[31mb"));
        row("8-bit control", QStringLiteral("a\u009b31m"), QStringLiteral("a⟨9B⟩31m"));
        row("forged line", QStringLiteral("A\r\npendeskctl: done"), QStringLiteral("A⟨0D⟩⟨0A⟩pendeskctl: done"));
        row("tabulator", QStringLiteral("a\tb"), QStringLiteral("a⟨09⟩b"));
        row("delete", QStringLiteral("a\u007f"), QStringLiteral("a⟨7F⟩"));
        row("right to left", QStringLiteral("\u202eIBJ.A"), QStringLiteral("⟨U+202E⟩IBJ.A"));
        row("isolates", QStringLiteral("\u2066a\u2069"), QStringLiteral("⟨U+2066⟩a⟨U+2069⟩"));
        row("without width", QStringLiteral("a\u200bb\ufeff"), QStringLiteral("a⟨U+200B⟩b⟨U+FEFF⟩"));
        row("line separator", QStringLiteral("a\u2028b"), QStringLiteral("a⟨U+2028⟩b"));
        row("half a pair", QString(QChar(0xD83D)), QStringLiteral("⟨U+D83D⟩"));
    }
    void onOneLine()
    {
        QFETCH(QString, text);
        QTEST(oneLine(text), "line");
    }

    void cutsLongLines()
    {
        const QString line = oneLine(QString(1'000'000, u'x'));
        QVERIFY(line.startsWith(QString(longestShownLine, u'x')));
        QVERIFY(line.size() < longestShownLine + 50 && line.contains(u"998000"));
    }

    void inHtml() { QCOMPARE(htmlLine(u"<b>\n&"), QStringLiteral("&lt;b&gt;⟨0A⟩&amp;")); }

    void inJson()
    {
        const QJsonObject object {{QStringLiteral("a"), QStringLiteral("\x1b\u009b\u202e\u007f テ 😀")}};
        const QByteArray plain = plainJson(QJsonDocument {object}.toJson(QJsonDocument::Indented));
        QVERIFY(plain.contains("\\u001b\\u009b\\u202e\\u007f テ 😀"));
        QCOMPARE(QJsonDocument::fromJson(plain).object(), object);
    }

    void inATable_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("cell");
        for (const char *plain : {"", "A", "'A", "1=2", "''"})
            QTest::addRow("%s", plain) << QString::fromLatin1(plain) << QString::fromLatin1(plain);
        for (const char *formula : {"=1+1", "+1", "-1", "@SUM(A1)", "\t=1", "'=1", "''-1"})
            QTest::addRow("%s", formula) << QString::fromLatin1(formula) << u'\'' + QString::fromLatin1(formula);
    }
    void inATable()
    {
        QFETCH(QString, text);
        QFETCH(QString, cell);
        QCOMPARE(csvText(text), cell);
        QCOMPARE(fromCsvText(cell), text);
    }
};

QTEST_GUILESS_MAIN(TestForeignText)
#include "tst_foreigntext.moc"
