// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "protocol/catalog.h"
#include <QTest>

using namespace protocol;

Q_DECLARE_METATYPE(protocol::Effect)
Q_DECLARE_METATYPE(protocol::Model)

/// The catalogue says what the reference says of each command, written down here a second time.
class CatalogTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void hasEveryCommand();
    void shape_data();
    void shape();
    void instances_data();
    void instances();
    void numberingShiftsVariablesAlone();
    void writable_data();
    void writable();
    void effects_data();
    void effects();
    void modelOfSoftware_data();
    void modelOfSoftware();
};

namespace {

QByteArray word(quint32 value)
{
    QByteArray bytes(4, '\0');
    qToLittleEndian(value, bytes.data());
    return bytes;
}

} // namespace

/// Reference §2; which models lack a command is in instances().
void CatalogTest::hasEveryCommand()
{
    QList<quint16> expected;
    for (quint16 number = 0x70; number <= 0x8C; ++number)
        expected += number;
    for (quint16 number = 0x300; number <= 0x30C; ++number)
        expected += number;
    expected += {0x411, 0x413};
    QList<quint16> found;
    for (const Command &command : commands())
        found += command.number;
    QCOMPARE(found, expected);
    QVERIFY(!findCommand(0x412));
    QVERIFY(!findCommand(0));
}

void CatalogTest::shape_data()
{
    QTest::addColumn<int>("number");
    QTest::addColumn<int>("elements");
    QTest::addColumn<int>("size");
    const auto row = [](int number, int elements, int size) {
        QTest::addRow("0x%03X", number) << number << elements << size;
    };
    // Sections 3, 4 and 6; 0x75 to 0x77 with all eight axes.
    row(0x70, 5, 60);
    row(0x71, 5, 60);
    row(0x72, 2, 8);
    row(0x73, 4, 44);
    row(0x74, 8, 32);
    row(0x75, 13, 52);
    row(0x76, 8, 32);
    row(0x77, 8, 32);
    row(0x78, 1, 1);
    row(0x79, 1, 2);
    row(0x7A, 1, 1);
    row(0x7B, 1, 2);
    row(0x7C, 1, 4);
    row(0x7D, 1, 4);
    row(0x7E, 1, 16);
    row(0x7F, 13, 52);
    row(0x80, 9, 36);
    row(0x81, 9, 36);
    row(0x82, 1, 4);
    row(0x83, 1, 4);
    row(0x84, 1, 4);
    row(0x85, 1, 32);
    row(0x86, 1, 4);
    row(0x88, 2, 28);
    row(0x89, 3, 48);
    row(0x8C, 1, 32);
    row(0x30A, 8, 268);
    row(0x30B, 8, 268);
    row(0x411, 1, 32);
    row(0x413, 1, 24);
    row(0x300, 0, 1);
    row(0x301, 0, 2);
    row(0x302, 0, 1);
    row(0x303, 0, 2);
    row(0x304, 0, 4);
    row(0x305, 0, 4);
    row(0x306, 0, 16);
    row(0x307, 0, 52);
    row(0x308, 0, 36);
    row(0x309, 0, 36);
    row(0x30C, 0, 32);
}

void CatalogTest::shape()
{
    QFETCH(int, number);
    const Command *command = findCommand(quint16(number));
    QVERIFY(command);
    QTEST(command->elements, "elements");
    QTEST(int(command->size), "size");
}

void CatalogTest::instances_data()
{
    QTest::addColumn<int>("number");
    QTest::addColumn<Model>("model");
    QTest::addColumn<QString>("ranges");
    const auto row = [](int number, Model model, const char *ranges) {
        QTest::addRow("0x%03X %s", number, dialect(model).name) << number << model << QString::fromLatin1(ranges);
    };
    using enum Model;
    row(0x70, YRC1000, "1-4");
    row(0x71, YRC1000, "1-100 1001-1100 2001-2100 3001-3100 4001-4100");
    row(0x72, DX100, "1-1");
    row(0x73, YRC1000, "1-16");
    row(0x73, FS100, "1-6");
    row(0x73, YRC1000micro, "1-6");
    row(0x74, YRC1000, "1-8 11-18 21-44 101-108 111-118");
    row(0x74, FS100, "1-2 11-12 21-23 101-102 111-112");
    row(0x75, YRC1000, "1-8 11-18 21-44 101-108");
    row(0x75, YRC1000micro, "1-2 11-12 21-23 101-102");
    row(0x76, DX200, "1-8 11-18 21-44");
    row(0x77, YRC1000micro, "1-2 11-12 21-23");
    row(0x78, DX100,
        "1-256 1001-1256 2001-2256 2501-2756 3001-3256 3501-3756 4001-4160 5001-5200 6001-6064 7001-7999 "
        "8001-8064 8201-8220");
    row(0x78, YRC1000,
        "1-512 1001-1512 2001-2512 2701-2956 3001-3512 3701-3956 4001-4256 5001-5512 6001-6064 "
        "7001-7999 8001-8512 8701-8720");
    row(0x300, FS100,
        "1-512 1001-1512 2001-2128 2701-2956 3001-3128 3701-3956 4001-4256 5001-5512 6001-6064 "
        "7001-7999 8001-8512 8701-8720");
    row(0x79, YRC1000, "0-999");
    row(0x301, YRC1000, "0-999");
    row(0x7A, YRC1000, "0-99");
    row(0x306, YRC1000, "0-99");
    row(0x7F, YRC1000, "0-127");
    row(0x309, YRC1000, "0-127");
    row(0x82, YRC1000, "1-2");
    row(0x83, YRC1000, "1-3");
    row(0x84, YRC1000, "2-2");
    row(0x85, YRC1000, "1-1");
    row(0x86, YRC1000, "1-1");
    row(0x87, YRC1000, "1-1 10-25");
    row(0x87, FS100, "1-1 10-15");
    row(0x88, YRC1000, "1-1 10-10 11-18 21-44 110-110 111-118 121-144 210-210 211-218 221-244 301-308");
    row(0x88, FS100, "1-1 10-10 11-12 21-23 110-110 111-112 121-123 210-210 211-212 221-223 301-301");
    row(0x89, YRC1000, "11-18 21-44 101-108");
    row(0x89, YRC1000micro, "11-12 21-23 101-101");
    row(0x8A, YRC1000, "1-3");
    row(0x8B, DX100, "1-2");
    row(0x8C, DX100, "");
    row(0x8C, DX200, "");
    row(0x8C, FS100, "");
    row(0x8C, YRC1000micro, "0-99");
    row(0x30C, FS100, "");
    row(0x30C, YRC1000, "0-99");
    row(0x30A, FS100, "1-4");
    row(0x30B, DX200, "1-100 1001-1100 2001-2100 3001-3100 4001-4100");
    row(0x411, DX200, "");
    row(0x411, FS100, "");
    row(0x411, YRC1000, "1-8 11-18 21-44");
    row(0x413, YRC1000micro, "1-2");
    row(0x413, DX100, "");
}

void CatalogTest::instances()
{
    QFETCH(int, number);
    QFETCH(Model, model);
    QStringList ranges;
    for (const InstanceRange range : findCommand(quint16(number))->instances(dialect(model)))
        ranges += QStringLiteral("%1-%2").arg(range.first).arg(range.last);
    QTEST(ranges.join(u' '), "ranges");
}

/// RS022 shifts B I D R S P BP EX and nothing else.
void CatalogTest::numberingShiftsVariablesAlone()
{
    Dialect shifted = dialect(Model::YRC1000);
    shifted.numbering = Numbering::FromOne;
    const QList<quint16> variables {0x7A, 0x7B, 0x7C, 0x7D, 0x7E, 0x7F, 0x80, 0x81, 0x8C, 0x302, 0x303, 0x304, 0x305,
        0x306, 0x307, 0x308, 0x309, 0x30C};
    for (const Command &command : commands()) {
        const InstanceRange plain = command.instances(dialect(Model::YRC1000)).first();
        const InstanceRange moved = command.instances(shifted).first();
        const int shift = variables.contains(command.number) ? 1 : 0;
        QCOMPARE(moved.first - plain.first, shift);
        QCOMPARE(moved.last - plain.last, shift);
    }
    QCOMPARE(variableInstance(5, Numbering::FromZero), quint16(5));
    QCOMPARE(variableInstance(5, Numbering::FromOne), quint16(6));
}

void CatalogTest::writable_data()
{
    QTest::addColumn<int>("number");
    QTest::addColumn<int>("instance");
    QTest::addColumn<Model>("model");
    QTest::addColumn<bool>("isWritable");
    const auto row = [](const char *name, int number, int instance, Model model, bool isWritable) {
        QTest::newRow(name) << number << instance << model << isWritable;
    };
    using enum Model;
    row("first network input", 0x78, 2701, YRC1000, true);
    row("last network input", 0x300, 2956, YRC1000, true);
    row("first network input of a DX100", 0x78, 2501, DX100, true);
    row("user output", 0x78, 1001, YRC1000, false);
    row("user input", 0x300, 1, YRC1000, false);
    row("register 559", 0x79, 559, YRC1000, true);
    row("register 560", 0x79, 560, YRC1000, false);
    row("register 560, plural", 0x301, 560, YRC1000, false);
    row("B099", 0x7A, 99, YRC1000, true);
    row("B100", 0x7A, 100, YRC1000, false);
}

void CatalogTest::writable()
{
    QFETCH(int, number);
    QFETCH(int, instance);
    QFETCH(Model, model);
    QTEST(findCommand(quint16(number))->isWritable(quint32(instance), dialect(model)), "isWritable");
}

void CatalogTest::effects_data()
{
    QTest::addColumn<Request>("request");
    QTest::addColumn<Effect>("effect");
    const auto row = [](const char *name, const Request &request, Effect effect) {
        QTest::newRow(name) << request << effect;
    };
    using enum Service;
    row("status", {0x72, 1, 0, GetAll}, Effect::Reads);
    row("B read", {0x7A, 0, 1, GetSingle}, Effect::Reads);
    row("B write", {0x7A, 0, 1, SetSingle, QByteArray("\1")}, Effect::Writes);
    row("P write", {0x7F, 0, 0, SetAll, QByteArray(52, '\0')}, Effect::Writes);
    row("plural read", {0x302, 0, 0, ReadPlural, word(2)}, Effect::Reads);
    row("plural write", {0x302, 0, 0, WritePlural, word(2) + QByteArray(2, '\0')}, Effect::Writes);
    row("hold on", {0x83, 1, 1, SetSingle, word(1)}, Effect::Stops);
    row("hold off", {0x83, 1, 1, SetSingle, word(2)}, Effect::Writes);
    row("hold without a word", {0x83, 1, 1, SetSingle}, Effect::Writes);
    row("servo on", {0x83, 2, 1, SetSingle, word(1)}, Effect::Starts);
    row("servo off", {0x83, 2, 1, SetSingle, word(2)}, Effect::Stops);
    row("servo with a short word", {0x83, 2, 1, SetSingle, QByteArray("\1")}, Effect::Starts);
    row("servo with another word", {0x83, 2, 1, SetSingle, word(0x101)}, Effect::Starts);
    row("hlock", {0x83, 3, 1, SetSingle, word(1)}, Effect::Writes);
    row("start", {0x86, 1, 1, SetSingle, word(1)}, Effect::Starts);
    row("start without a word", {0x86, 1, 1, SetSingle}, Effect::Starts);
    row("select", {0x87, 1, 0, SetAll, QByteArray(36, '\0')}, Effect::Writes);
    row("cartesian move", {0x8A, 1, 1, SetAll, QByteArray(104, '\0')}, Effect::Moves);
    row("pulse move", {0x8B, 1, 1, SetAll, QByteArray(88, '\0')}, Effect::Moves);
    row("move without a payload", {0x8A, 1, 1, SetAll}, Effect::Moves);
    row("unknown command", {0x99F, 1, 1, GetAll}, Effect::Writes);
}

void CatalogTest::effects()
{
    QFETCH(Request, request);
    QTEST(effectOf(request), "effect");
}

void CatalogTest::modelOfSoftware_data()
{
    QTest::addColumn<QByteArray>("version");
    QTest::addColumn<std::optional<Model>>("model");
    // reference §0 (a recording of a YRC1000) and §2 (first versions with a command)
    QTest::newRow("YRC1000") << QByteArray {"YAS2.02.11A(JP/EN)-97"} << std::optional {Model::YRC1000};
    QTest::newRow("YRC1000micro") << QByteArray {"YBS3.10-00"} << std::optional {Model::YRC1000micro};
    QTest::newRow("FS100") << QByteArray {"FS1.14"} << std::optional {Model::FS100};
    QTest::newRow("unknown") << QByteArray {"PENDESK VIRTUAL 1.00-00"} << std::optional<Model> {};
    QTest::newRow("empty") << QByteArray {} << std::optional<Model> {};
}

void CatalogTest::modelOfSoftware()
{
    QFETCH(QByteArray, version);
    QFETCH(std::optional<Model>, model);
    QVERIFY(protocol::modelOfSoftware(version) == model);
}

QTEST_APPLESS_MAIN(CatalogTest)
#include "tst_catalog.moc"
