// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/language.h"

#include "ui/actioncatalog.h"
#include "ui/conditionwords.h"
#include "ui/pagecatalog.h"

#include <QDir>
#include <QLocale>
#include <QTest>
#include <QXmlStreamReader>

class TestLanguage : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void cleanup() { QVERIFY(ui::speak(*qApp, QStringLiteral("en"))); }

    /// A file that no row names would never be spoken, a row without a file would be English.
    void everyFileHasARow()
    {
        QStringList codes;
        for (const ui::Language &language : ui::languages())
            codes << QLatin1String(language.code);
        QCOMPARE(codes.first(), u"en");
        QStringList files;
        for (QString file : QDir(QStringLiteral(":/translations")).entryList())
            files << file.remove(QStringLiteral("pendesk_")).remove(QStringLiteral(".qm"));
        codes.sort();
        QCOMPARE(files, codes);
    }

    void everySentenceIsTranslated_data()
    {
        QTest::addColumn<QString>("path");
        const QDir folder {QStringLiteral(PENDESK_TEST_DATA "/../../translations")};
        for (const QString &file : folder.entryList({QStringLiteral("*.ts")}))
            QTest::newRow(qPrintable(file)) << folder.filePath(file);
    }

    /// Every form of it, with the placeholders of the English one.
    void everySentenceIsTranslated()
    {
        QFETCH(QString, path);
        QFile file {path};
        QVERIFY(file.open(QIODevice::ReadOnly));
        QXmlStreamReader xml {&file};
        QString source;
        int sentences = 0;
        while (!xml.atEnd()) {
            xml.readNext();
            if (!xml.isStartElement())
                continue;
            if (xml.name() == u"source") {
                source = xml.readElementText();
            } else if (xml.name() == u"translation") {
                QVERIFY2(!xml.attributes().hasAttribute(QLatin1String("type")), qPrintable(source));
                const QString text = xml.readElementText(QXmlStreamReader::IncludeChildElements);
                QVERIFY2(!text.trimmed().isEmpty() || source.trimmed().isEmpty(), qPrintable(source));
                for (const QString &placeholder : {QStringLiteral("%1"), QStringLiteral("%2"), QStringLiteral("%3")})
                    QVERIFY2(text.contains(placeholder) == source.contains(placeholder), qPrintable(source));
                ++sentences;
            }
        }
        QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
        QVERIFY(sentences > (path.endsWith(u"_en.ts") ? 40 : 1000)); // English has its plurals alone
    }

    /// Words that stand in tables, and not where they are shown.
    void tablesAreTranslated()
    {
        for (const ui::Language &language : ui::languages().subspan(1)) {
            QVERIFY(ui::speak(*qApp, QLatin1String(language.code)));
            QVERIFY2(ui::title(ui::pageCatalog().front()) != u"Overview", language.code);
            QVERIFY2(ui::text(ui::actionCatalog()[2]) != u"Open this page in its own window", language.code);
            QVERIFY2(ui::title(robot::Condition::LinkUp) != u"The link to the controller is up", language.code);
            QVERIFY2(ui::remedy(robot::Condition::LinkUp, protocol::Model::YRC1000)
                    != u"connect, or wait until it answers again",
                language.code);
        }
    }

    void englishCounts()
    {
        QVERIFY(ui::speak(*qApp, QStringLiteral("en")));
        QCOMPARE(QCoreApplication::translate("pages::FilePane", "%n file(s)", nullptr, 1), u"1 file");
        QCOMPARE(QCoreApplication::translate("pages::FilePane", "%n file(s)", nullptr, 8), u"8 files");
    }

    void numbersFollow()
    {
        QVERIFY(ui::speak(*qApp, QStringLiteral("de")));
        QCOMPARE(QLocale().toString(1.5), u"1,5");
        QVERIFY(ui::speak(*qApp, QStringLiteral("en")));
        QCOMPARE(QLocale().toString(1.5), u"1.5");
    }

    void anUnknownLanguageChangesNothing()
    {
        QVERIFY(ui::speak(*qApp, QStringLiteral("de")));
        QVERIFY(!ui::speak(*qApp, QStringLiteral("tlh")));
        QCOMPARE(QLocale().language(), QLocale::German);
    }
};

QTEST_MAIN(TestLanguage)

#include "tst_language.moc"
