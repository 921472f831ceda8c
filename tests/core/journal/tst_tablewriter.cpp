// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "journal/tablewriter.h"
#include <QBuffer>
#include <QDateTime>
#include <QTest>

using namespace journal;

class TestTableWriter : public QObject
{
    Q_OBJECT

private:
    static QByteArray written(Format format, const QList<QVariantList> &rows)
    {
        QBuffer buffer;
        buffer.open(QIODevice::WriteOnly);
        TableWriter table {buffer, format, {QStringLiteral("time"), QStringLiteral("text"), QStringLiteral("number")}};
        for (const QVariantList &row : rows)
            table.row(row);
        table.end();
        return buffer.data();
    }

private Q_SLOTS:
    void cellsAreQuotedAsTheStandardSays_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QByteArray>("cell");
        QTest::newRow("plain") << QStringLiteral("start job") << QByteArray("start job");
        QTest::newRow("empty") << QString() << QByteArray();
        QTest::newRow("comma") << QStringLiteral("1,5 mm") << QByteArray("\"1,5 mm\"");
        QTest::newRow("quote") << QStringLiteral("the \"home\"") << QByteArray("\"the \"\"home\"\"\"");
        QTest::newRow("line feed") << QStringLiteral("a\nb") << QByteArray("\"a\nb\"");
        QTest::newRow("carriage return") << QStringLiteral("a\rb") << QByteArray("\"a\rb\"");
        QTest::newRow("semicolon stays") << QStringLiteral("a;b") << QByteArray("a;b");
        QTest::newRow("unreadable byte") << QStringLiteral("⟨8A⟩")
                                         << QByteArray("\xE2\x9F\xA8"
                                                       "8A\xE2\x9F\xA9");
    }

    void cellsAreQuotedAsTheStandardSays()
    {
        QFETCH(const QString, text);
        QFETCH(const QByteArray, cell);
        QCOMPARE(written(Format::Csv, {{QDateTime(), text, 7}}), "time,text,number\r\n," + cell + ",7\r\n");
    }

    void timesAreUtcAndNumbersPlain()
    {
        const QDateTime berlin {{2026, 1, 12}, {9, 30, 5, 42}, Qt::OffsetFromUTC, 3600};
        QCOMPARE(written(Format::Csv, {{berlin, QString(), qint64(1234567)}}),
            QByteArray("time,text,number\r\n2026-01-12T08:30:05.042Z,,1234567\r\n"));
        QCOMPARE(written(Format::Json, {{berlin, QStringLiteral("a\"b"), 7}, {QDateTime(), QString(), 8}}),
            QByteArray("[\n{\"number\":7,\"text\":\"a\\\"b\",\"time\":\"2026-01-12T08:30:05.042Z\"},\n"
                       "{\"number\":8,\"text\":\"\",\"time\":\"\"}\n]\n"));
        QCOMPARE(written(Format::Json, {}), QByteArray("[\n]\n"));
    }
};

QTEST_APPLESS_MAIN(TestTableWriter)
#include "tst_tablewriter.moc"
