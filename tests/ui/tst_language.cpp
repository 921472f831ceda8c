// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/language.h"

#include <QDir>
#include <QLocale>
#include <QTest>

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
        QCOMPARE(codes.takeFirst(), u"en");
        QStringList files;
        for (QString file : QDir(QStringLiteral(":/translations")).entryList())
            files << file.remove(QStringLiteral("pendesk_")).remove(QStringLiteral(".qm"));
        codes.sort();
        QCOMPARE(files, codes);
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
