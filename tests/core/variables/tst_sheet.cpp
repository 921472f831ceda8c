// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "variables/sheet.h"
#include <QTest>

using namespace variables;

Q_DECLARE_METATYPE(QList<variables::Problem>)

/// CSV and pasted blocks: what they would change, and what is wrong with them.
class SheetTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void readsTables_data();
    void readsTables();
    void refusesTables_data();
    void refusesTables();
    void decodesFiles_data();
    void decodesFiles();
    void previews();
    void complains_data();
    void complains();
    void previewsPositions();
    void complainsOfPositions_data();
    void complainsOfPositions();
    void previewsBlocks_data();
    void previewsBlocks();
    void manyLines();
    void whatIsWrittenComesBack();
};

namespace {

const protocol::Dialect &yrc() { return protocol::dialect(protocol::Model::YRC1000); }
const Format plain {};

std::optional<Value> unread(const Reference &) { return std::nullopt; }

Preview previewOf(const QString &text, const Lookup &now = unread)
{
    const auto table = readTable(text);
    return table ? preview(*table, plain, yrc(), now) : Preview {{}, {{0, table.error().detail}}, 0};
}

QString told(const Preview &preview)
{
    QStringList lines;
    for (const Difference &difference : preview.differences)
        lines << toString(difference.variable) + u'=' + toText(difference.value, plain);
    return lines.join(u' ');
}

QList<int> linesOf(const Preview &preview)
{
    QList<int> lines;
    for (const Problem &problem : preview.problems)
        lines << problem.line;
    return lines;
}

} // namespace

void SheetTest::readsTables_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QList<QStringList>>("cells");
    QTest::addColumn<QList<int>>("lines");
    const auto row = [](const char *name, const char *text, const QList<QStringList> &cells, const QList<int> &lines) {
        QTest::newRow(name) << QString::fromUtf8(text) << cells << lines;
    };
    const QStringList ab {QStringLiteral("a"), QStringLiteral("b")};
    const QStringList c12 {QStringLiteral("1"), QStringLiteral("2")};
    row("comma", "a,b\r\n1,2\r\n", {ab, c12}, {1, 2});
    row("semicolon", "a;b\n1;2", {ab, c12}, {1, 2});
    row("tab", "a\tb\n1\t2\n", {ab, c12}, {1, 2});
    row("carriage returns", "a,b\r1,2\r", {ab, c12}, {1, 2});
    row("comma in a semicolon file", "a;b\n1,5;2\n", {ab, {QStringLiteral("1,5"), QStringLiteral("2")}}, {1, 2});
    row("separators in quotes do not count", "\"a,,,\";b\n", {{QStringLiteral("a,,,"), QStringLiteral("b")}}, {1});
    row("quotes", "a,\"b \"\"c\"\"\"\n", {{QStringLiteral("a"), QStringLiteral("b \"c\"")}}, {1});
    row("line break in a cell", "\"a\nb\",c\nd,e\n",
        {{QStringLiteral("a\nb"), QStringLiteral("c")}, {QStringLiteral("d"), QStringLiteral("e")}}, {1, 3});
    row("blank lines", "\na,b\n\n\n1,2\n", {ab, c12}, {2, 5});
    row("empty cells", "a,b\n,\n1,\n", {ab, {QStringLiteral("1"), QString()}}, {1, 3});
    row("one column", "a\nb\n", {{QStringLiteral("a")}, {QStringLiteral("b")}}, {1, 2});
    row("nothing", "", {}, {});
}

void SheetTest::readsTables()
{
    QFETCH(QString, text);
    QFETCH(QList<QStringList>, cells);
    QFETCH(QList<int>, lines);
    const auto table = readTable(text);
    QVERIFY2(table, table ? "" : qPrintable(table.error().detail));
    QCOMPARE(table->lines.size(), cells.size());
    for (qsizetype i = 0; i < cells.size(); ++i) {
        QCOMPARE(table->lines[i].cells, cells[i]);
        QCOMPARE(table->lines[i].line, lines[i]);
    }
}

void SheetTest::refusesTables_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("part");
    QTest::newRow("open quote") << QStringLiteral("a,b\n1,\"2\n3,4\n") << QStringLiteral("Line 2");
    QTest::newRow("text behind a quote") << QStringLiteral("a,b\n\"1\"x,2\n") << QStringLiteral("Line 2");
}

void SheetTest::refusesTables()
{
    QFETCH(QString, text);
    QFETCH(QString, part);
    const auto table = readTable(text);
    QVERIFY(!table);
    QVERIFY2(table.error().detail.startsWith(part), qPrintable(table.error().detail));
}

void SheetTest::decodesFiles_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("text"); // null: refused
    QTest::newRow("utf-8") << QByteArray("a\xC3\xA9") << QStringLiteral("aé");
    QTest::newRow("with a mark") << QByteArray("\xEF\xBB\xBF"
                                               "a")
                                 << QStringLiteral("a");
    QTest::newRow("utf-16") << QByteArray("\xFF\xFE"
                                          "a\0;\0",
        6) << QStringLiteral("a;");
    QTest::newRow("windows-1252") << QByteArray("a\xE9,b") << QString();
}

void SheetTest::decodesFiles()
{
    QFETCH(QByteArray, bytes);
    QFETCH(QString, text);
    const auto read = textOfFile(bytes);
    QCOMPARE(read.has_value(), !text.isNull());
    if (read)
        QCOMPARE(*read, text);
}

void SheetTest::previews()
{
    const auto now = [](const Reference &variable) -> std::optional<Value> {
        if (variable.kind == Kind::B)
            return values::ByteVariable {quint8(variable.number)};
        return std::nullopt;
    };
    const Preview result = previewOf(QStringLiteral("Value;VARIABLE;comment\n5;B005;as it is\n17;b 6;\n1,5;R000;new\n"
                                                    "text;S001;\n;S002;\n"),
        now);
    QVERIFY2(result.problems.isEmpty(), result.problems.isEmpty() ? "" : qPrintable(result.problems.first().reason));
    QCOMPARE(result.unchanged, 1);
    QCOMPARE(told(result), QStringLiteral("B006=17 R000=1.5 S001=text S002="));
    QCOMPARE(result.differences[0].line, 3);
    QVERIFY(result.differences[0].was == Value {values::ByteVariable {6}});
    QVERIFY(!result.differences[1].was);
}

void SheetTest::complains_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QList<int>>("lines");
    QTest::addColumn<QString>("part"); // of the first reason
    const auto row = [](const char *name, const char *text, const QList<int> &lines, const char *part) {
        QTest::newRow(name) << QString::fromUtf8(text) << lines << QString::fromUtf8(part);
    };
    row("empty file", "", {0}, "header is missing");
    row("no header", "B001,5\nB002,6\n", {1}, "header is missing");
    row("wrong header", "name,value\nB001,5\n", {1}, "header is missing");
    row("no values", "variable,name\nB001,5\n", {1}, "neither a column");
    row("column twice", "variable,value,value\nB001,5,6\n", {1}, "stands there twice");
    row("missing number", "variable,value\n,5\nB002,6\n", {2}, "variable is missing");
    row("missing value", "variable,value\nB001,\nB002\n", {2, 3}, "value is missing");
    row("duplicate", "variable,value\nB001,5\nB002,6\nb 1,7\n", {4}, "B001 stands in line 2 already");
    row("unknown", "variable,value\nQ001,5\n", {2}, "is not a variable");
    row("beyond", "variable,value\nB100,5\n", {2}, "There is no B100");
    row("out of range", "variable,value\nB001,256\n", {2}, "B001: 256 is out of range");
    row("text for a number", "variable,value\nI001,many\n", {2}, "is not a number");
    row("character", "variable,value\nS001,☃\n", {2}, "☃");
    row("too long", "variable,value\nS001,seventeen bytes!!\n", {2}, "takes 17 bytes");
    row("read-only register", "variable,value\nM560,1\n", {2}, "M560 can only be read");
    row("too many cells", "variable,value\nB001,1,5\n", {2}, "more cells");
    row("several", "variable,value\nB001,300\nB002,5\nB003,x\n", {2, 4}, "out of range");
}

void SheetTest::complains()
{
    QFETCH(QString, text);
    QFETCH(QString, part);
    const Preview result = previewOf(text);
    QTEST(linesOf(result), "lines");
    QVERIFY2(result.problems.first().reason.contains(part), qPrintable(result.problems.first().reason));
    for (const Problem &problem : result.problems)
        QVERIFY2(problem.reason.endsWith(u'.'), qPrintable(problem.reason));
}

void SheetTest::previewsPositions()
{
    const auto now = [](const Reference &variable) -> std::optional<Value> {
        values::Position position;
        position.type = values::PositionType::Base;
        position.tool = 3;
        position.axes = {1000, 2000, 3000};
        return variable.number == 1 ? std::optional {valueWith(Kind::P, position)} : std::nullopt;
    };
    const Preview result =
        previewOf(QStringLiteral("variable;type;tool;form;axis 1;axis 2;axis 3;axis 4;axis 5;axis 6\n"
                                 "P001;;;5;;-12,5;;;;\n"
                                 "P002;pulse;1;;10;20;30;40;50;60\n"),
            now);
    QVERIFY2(result.problems.isEmpty(), result.problems.isEmpty() ? "" : qPrintable(result.problems.first().reason));
    QCOMPARE(result.differences.size(), 2);
    const auto first = *positionOf(result.differences[0].value);
    QVERIFY(first.type == values::PositionType::Base);
    QCOMPARE(first.tool, 3U);
    QCOMPARE(first.form, 5U);
    QVERIFY((first.axes == values::AxisWords {1000, -12500, 3000, 0, 0, 0, 0, 0}));
    const auto second = *positionOf(result.differences[1].value);
    QVERIFY((second.axes == values::AxisWords {10, 20, 30, 40, 50, 60, 0, 0}));
}

void SheetTest::complainsOfPositions_data()
{
    QTest::addColumn<QString>("cells");
    QTest::addColumn<QString>("part");
    const auto row = [](const char *name, const char *cells, const char *part) {
        QTest::newRow(name) << QString::fromUtf8(cells) << QString::fromUtf8(part);
    };
    row("unknown type", "P001,elbow,0,0,1,2,3,4,5,6", "not a type");
    row("type of another kind", "EX001,base,,,1,2,3,4,5,6", "not a type");
    row("no type", "P001,,0,0,1,2,3,4,5,6", "type is missing");
    row("axis missing", "P001,pulse,0,0,1,2,,4,5,6", "axis 3 is missing");
    row("tool", "P001,pulse,64,0,1,2,3,4,5,6", "from 0 to 63");
    row("form", "P001,pulse,1,256,1,2,3,4,5,6", "from 0 to 255");
    row("pulse with decimals", "P001,pulse,1,0,1.5,2,3,4,5,6", "whole number");
    row("too fine", "P001,base,1,0,1.0005,2,3,4,5,6", "too fine");
    row("no number", "P001,base,1,0,here,2,3,4,5,6", "axis 1: “here” is not a number");
}

void SheetTest::complainsOfPositions()
{
    QFETCH(QString, cells);
    QFETCH(QString, part);
    const Preview result =
        previewOf(QStringLiteral("variable,type,tool,form,axis 1,axis 2,axis 3,axis 4,axis 5,axis 6\n") + cells);
    QCOMPARE(linesOf(result), QList<int> {2});
    QVERIFY2(result.problems.first().reason.contains(part), qPrintable(result.problems.first().reason));
}

void SheetTest::previewsBlocks_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("told");
    QTest::addColumn<QList<int>>("lines");
    const auto row = [](const char *name, const char *text, const char *told, const QList<int> &lines) {
        QTest::newRow(name) << QString::fromUtf8(text) << QString::fromUtf8(told) << lines;
    };
    row("values", "1\n2\n3\n", "B097=1 B098=2 B099=3", {});
    row("values beyond the last", "1\n2\n3\n4\n", "B097=1 B098=2 B099=3", {4});
    row("variables and values", "B005\t7\nI001\t-5\n", "B005=7 I001=-5", {});
    row("with a header", "variable\tvalue\nB005\t7\n", "B005=7", {});
    row("bad value", "1\nx\n", "B097=1", {2});
    row("three columns", "B001\tDOOR\t5\n", "", {1});
    row("open quote", "\"1\n", "", {0});
    row("nothing", "", "", {});
}

void SheetTest::previewsBlocks()
{
    QFETCH(QString, text);
    const Preview result = previewBlock(text, {Kind::B, 97}, plain, yrc(), unread);
    QTEST(told(result), "told");
    QTEST(linesOf(result), "lines");
}

void SheetTest::manyLines()
{
    QString text = QStringLiteral("variable,value\n");
    for (int number = 0; number < 10'000; ++number)
        text += QStringLiteral("D%1,5\n").arg(number);
    const Preview result = previewOf(text);
    QCOMPARE(result.differences.size(), 100);
    QCOMPARE(result.problems.size(), 9'900);
    QCOMPARE(result.problems.last().line, 10'001);
}

void SheetTest::whatIsWrittenComesBack()
{
    values::Position position;
    position.type = values::PositionType::User;
    position.userFrame = 2;
    position.tool = 1;
    position.form = 4;
    position.extendedForm = 3;
    position.axes = {812500, -12001, 3, 1800000, -1, 450000, 0, 0};
    Format german = plain;
    german.locale = QLocale(QStringLiteral("de_DE"));
    const QList<ExportRow> rows {
        {{Kind::B, 0}, QStringLiteral("Parts, \"good\""), values::ByteVariable {255}},
        {{Kind::R, 1}, {}, values::RealVariable {0.1F}},
        {{Kind::S, 2}, {}, *fromText(Kind::S, u"a;b,\"c\"", german)},
        {{Kind::P, 3}, {}, valueWith(Kind::P, position)},
        {{Kind::BP, 4}, {}, valueWith(Kind::BP, values::Position {})},
    };
    const QString text = toCsv(rows, german);
    QVERIFY(text.startsWith(QStringLiteral("variable,name,value,type,")));
    QVERIFY(text.contains(QStringLiteral("R001,,0.1,")));
    const Preview result = previewOf(text);
    QVERIFY2(result.problems.isEmpty(), result.problems.isEmpty() ? "" : qPrintable(result.problems.first().reason));
    QCOMPARE(result.differences.size(), rows.size());
    for (qsizetype i = 0; i < rows.size(); ++i) {
        QVERIFY(result.differences[i].variable == rows[i].variable);
        QVERIFY(isSame(result.differences[i].value, *rows[i].value));
    }
    const QList<ExportRow> simple {{{Kind::I, 5}, {}, std::nullopt}};
    QCOMPARE(toCsv(simple, plain), QStringLiteral("variable,name,value\r\nI005,,\r\n"));
}

QTEST_APPLESS_MAIN(SheetTest)
#include "tst_sheet.moc"
