// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "inform/jobdiff.h"
#include "support/jobs.h"

#include <QLocale>
#include <QTest>
#include <random>

using namespace inform;

namespace {

QString latin1(QByteArrayView bytes) { return QString::fromLatin1(bytes); }

QStringList explained(const QByteArray &older, const QByteArray &newer, const Clean &clean = {})
{
    QStringList texts;
    for (const JobEdit &edit : diffJobs(parse(older), parse(newer), clean))
        texts << explain(edit, latin1);
    return texts;
}

const QByteArray sample =
    "/JOB\r\n//NAME A\r\n//POS\r\n///NPOS 2,0,0,2,0,0\r\n///TOOL 0\r\n///POSTYPE PULSE\r\n///PULSE\r\n"
    "C00000=0,100,-200,0,0,0\r\nC00001=1,2,3,4,5,6\r\n///POSTYPE BASE\r\n///RECTAN\r\n"
    "P00012=1000.000,50.000,620.000,180.0000,0.0000,0.0000\r\n"
    "P00013=1.000,1.000,1.000,1.0000,1.0000,1.0000\r\n//INST\r\n///DATE 2026/01/12 08:30\r\n"
    "///COMM OLD\r\n///ATTR SC,RW\r\n///GROUP1 RB1\r\nNOP\r\n'START 08:30\r\nMOVJ C00000 VJ=25.00\r\n"
    "MOVL C00001 V=100.0\r\nDOUT OT#(1) ON\r\nTIMER T=0.30\r\nCALL JOB:SUB IF B000>=20\r\n"
    "SET D000  EXPRESS D001 + 1\r\nMSG \"A  B\"\r\nEND\r\n";

/// A step or another line of a generated job.
struct Step {
    QByteArray word; ///< "MOVJ"; empty for other lines.
    QByteArray text; ///< Speed of a step; all of another line.
    bool isCartesian = false;
    int tool = 0;
    QList<int> values = {};
    bool hasFlip = false;
};

struct Version {
    QByteArray name = "A";
    QByteArray groups = "///GROUP1 RB1\r\n";
    int firstNumber = 0; ///< Of the C points.
    QList<Step> steps = {};
};

QByteArray valuesOf(const Step &step)
{
    QByteArrayList texts;
    for (int axis = 0; axis < step.values.size(); ++axis)
        texts << QByteArray::number(step.values[axis])
                + (step.isCartesian ? (axis < 3 ? QByteArray(".000") : QByteArray(".0000")) : QByteArray());
    return texts.join(',');
}

QByteArray print(const Version &version)
{
    QByteArray positions;
    QByteArray lines;
    int number = version.firstNumber;
    for (const Step &step : version.steps) {
        if (step.word.isEmpty()) {
            lines += step.text + "\r\n";
            continue;
        }
        const QByteArray point = 'C' + QByteArray::number(number++).rightJustified(5, '0');
        positions += "///TOOL " + QByteArray::number(step.tool) + "\r\n///POSTYPE "
            + (step.isCartesian ? "BASE\r\n///RECTAN\r\n///RCONF " + QByteArray(step.hasFlip ? "0" : "1") + ",0,0\r\n"
                                : QByteArray("PULSE\r\n///PULSE\r\n"))
            + point + '=' + valuesOf(step) + "\r\n";
        lines += step.word + ' ' + point + ' ' + step.text + "\r\n";
    }
    return "/JOB\r\n//NAME " + version.name + "\r\n//POS\r\n" + positions + "//INST\r\n" + version.groups + "NOP\r\n"
        + lines + "END\r\n";
}

/// Makes pairs of jobs, and says how they differ.
class Generator
{
public:
    explicit Generator(quint32 seed) : m_random {seed} { }
    void run();

    Version older;
    Version newer;
    QStringList edits; ///< See summary().

private:
    Step randomStep();
    void editStep(Step step);
    void keep(const Step &step);
    [[nodiscard]] int oldLine() const { return int(older.steps.size()) + 1; } ///< Of the next one.
    [[nodiscard]] int newLine() const { return int(newer.steps.size()) + 1; }
    int below(int limit) { return int(m_random() % quint32(limit)); }

    std::mt19937 m_random;
    int m_serial = 0;
};

/// What matters of an edit.
QString summary(const JobEdit &edit)
{
    switch (edit.kind) {
    case EditKind::NameChanged: return QStringLiteral("name");
    case EditKind::GroupChanged: return QStringLiteral("group ") + latin1(edit.subject) + u' ' + latin1(edit.newer);
    case EditKind::LineAdded: return QStringLiteral("added %1").arg(edit.line);
    case EditKind::LineRemoved: return QStringLiteral("removed %1").arg(edit.line);
    case EditKind::LineChanged: return QStringLiteral("changed %1").arg(edit.line);
    case EditKind::OperandChanged:
        return QStringLiteral("operand %1 %2 %3").arg(edit.line).arg(latin1(edit.subject), latin1(edit.newer));
    case EditKind::PointChanged: break;
    default: return QStringLiteral("unexpected %1").arg(int(edit.kind));
    }
    QString text = QStringLiteral("point %1").arg(edit.line);
    if (edit.point.tool.isChanged())
        text += QStringLiteral(" tool ") + latin1(edit.point.tool.newer);
    if (edit.point.type.isChanged())
        text += QStringLiteral(" type ") + latin1(edit.point.type.newer);
    for (const int field : edit.point.form)
        text += QStringLiteral(" form %1").arg(field);
    for (const Shift &shift : edit.point.shifts)
        text += QStringLiteral(" axis %1 %2").arg(shift.axis).arg(shift.amount);
    return text;
}

Step Generator::randomStep()
{
    const bool isCartesian = below(3) == 0;
    Step step {below(2) ? "MOVJ" : "MOVL", {}, isCartesian, below(3)};
    step.text = (step.word == "MOVJ" ? "VJ=" : "V=") + QByteArray::number(1 + below(99)) + ".0";
    for (int axis = 0; axis < 6; ++axis)
        step.values << (isCartesian && axis >= 3 ? below(80) : below(200000) - 100000);
    return step;
}

void Generator::keep(const Step &step)
{
    older.steps << step;
    newer.steps << step;
}

void Generator::editStep(Step step)
{
    const QString line = QString::number(newLine());
    Step changed = step;
    switch (below(8)) {
    case 0:
        edits << QStringLiteral("added ") + line;
        newer.steps << randomStep();
        return keep(step);
    case 1:
        edits << QStringLiteral("removed %1").arg(oldLine());
        older.steps << step;
        return;
    case 2:
        changed.values[2] += 15;
        edits << QStringLiteral("point %1 axis 2 15").arg(line);
        break;
    case 3:
        changed.tool = step.tool + 5;
        changed.values[0] -= 7;
        edits << QStringLiteral("point %1 tool %2 axis 0 -7").arg(line).arg(changed.tool);
        break;
    case 4:
        changed.text = step.text.split('=').first() + "=99.5";
        edits << QStringLiteral("operand %1 %2 99.5").arg(line, latin1(step.text.split('=').first()));
        break;
    case 5:
        changed.hasFlip = step.isCartesian;
        if (step.isCartesian)
            edits << QStringLiteral("point %1 form -1").arg(line);
        break;
    case 6:
        changed.isCartesian = !step.isCartesian;
        edits << QStringLiteral("point %1 type %2").arg(line, step.isCartesian ? u"PULSE" : u"BASE");
        break;
    default: changed.word = step.word == "MOVJ" ? "MOVS" : "MOVC"; edits << QStringLiteral("changed ") + line;
    }
    older.steps << step;
    newer.steps << changed;
}

void Generator::run()
{
    newer.firstNumber = below(3) == 0 ? below(100) : 0;
    if (below(5) == 0) {
        newer.name = "B";
        edits << QStringLiteral("name");
    }
    if (below(5) == 0) {
        newer.groups += "///GROUP2 ST1\r\n";
        edits << QStringLiteral("group 2 ST1");
    }
    for (int block = 1 + below(6); block > 0; --block) {
        keep(randomStep());
        keep({{}, "SET D000 " + QByteArray::number(++m_serial)});
        below(3) == 0 ? editStep(randomStep()) : keep(randomStep());
        keep({{}, "'NUMBER " + QByteArray::number(++m_serial)});
    }
}

} // namespace

/// Two versions of a job are compared in words, and nothing is said that was not done.
class TestJobDiff : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void comparesPairs_data();
    void comparesPairs();
    void comparesSamplesWithThemselves_data();
    void comparesSamplesWithThemselves();
    void explains_data();
    void explains();
    void takesNoiseOut();
    void hasOneTextInAllLocales();
    void insertedStepIsOneEdit();
    void saysWhichLinesMoved();
    void findsExactlyTheEdits();
    void bearsSize_data();
    void bearsSize();
};

void TestJobDiff::comparesPairs_data()
{
    QTest::addColumn<QStringList>("texts");
    QTest::newRow("renumber") << QStringList {
        QStringLiteral("Line 1 added: MOVJ C00000 VJ=10.00 (new point: PULSE 7,7,7,0,0,0 TOOL 0)")};
    QTest::newRow("tool-hides-move") << QStringList {QStringLiteral("P001: tool 3 → 4; moved -200 mm in Z")};
    QTest::newRow("rconf") << QStringList {
        QStringLiteral("Line 1 C00000: arm form: flip → no flip; arm form: upper arm → lower arm")};
    QTest::newRow("silent-headers") << QStringList {QStringLiteral("Relative frame: USER 1 → USER 9"),
        QStringLiteral("Control group GROUP2 added: ST1"), QStringLiteral("Local variables LB: 1 → 5")};
    QTest::newRow("angle-unit") << QStringList {QStringLiteral("Line 1 EC00000: moved 5° in axis 1")};
    QTest::newRow("words") << QStringList {QStringLiteral("Line 1 SET B005: 1 → 2"),
        QStringLiteral("Line 2 +MOVJ of RB2: VJ 10.00 → 50.00"), QStringLiteral("Line 3 MSG: \"A  B\" → \"A B\"")};
    QTest::newRow("locale") << QStringList {QStringLiteral("Line 1 C00000: moved 12496 pulses in S, 5 pulses in L")};
}

void TestJobDiff::comparesPairs()
{
    const QString name = QString::fromLatin1(QTest::currentDataTag());
    QTEST(explained(testdata::job(QStringLiteral("pairs/%1-older.JBI").arg(name)),
              testdata::job(QStringLiteral("pairs/%1-newer.JBI").arg(name))),
        "texts");
}

void TestJobDiff::comparesSamplesWithThemselves_data()
{
    QTest::addColumn<QString>("name");
    for (const char *name : {"MINIMAL", "OLDNX", "PULSE6", "POSTYPES", "RELUSER", "R1B1", "COORD-S1", "TWO-ROBOTS",
             "R1B1S1", "SJIS-COMM", "ALIASES", "ARGS-SUB", "MAIN-FLOW", "STRUCT", "IO-ALL", "MATH-POS", "MACRO-GRIP",
             "CONVEYOR", "ARC-WELD", "SPOT-GUN"})
        QTest::newRow(name) << QString::fromLatin1(name);
}

/// Also when only what the controller writes as it likes is different (reference §10.3).
void TestJobDiff::comparesSamplesWithThemselves()
{
    QFETCH(QString, name);
    const QByteArray older = testdata::job(name + QStringLiteral(".JBI"));
    QByteArray newer = older;
    newer.replace("///DATE 2026/03/02", "///DATE 2026/03/03").replace("\t", "").replace("T=2.00", "T=2.000");
    newer.replace("\r\n", "\n").replace(".00 ", ".0 ");
    QCOMPARE(explained(older, newer), QStringList());
}

void TestJobDiff::explains_data()
{
    QTest::addColumn<QByteArray>("before");
    QTest::addColumn<QByteArray>("after");
    QTest::addColumn<QStringList>("texts");
    const auto row = [](const char *before, const char *after, const QStringList &texts) {
        QTest::newRow(QByteArray(before).simplified() + " / " + QByteArray(after).simplified())
            << QByteArray(before) << QByteArray(after) << texts;
    };
    row("620.000", "623.200", {QStringLiteral("P012: moved 3.2 mm in Z")});
    row("1000.000,50.000", "1003.000,46.000", {QStringLiteral("P012: moved 3 mm in X, -4 mm in Y (5 mm in all)")});
    row("180.0000,0.0000,0.0000", "-179.5000,0.0000,0.0000", {QStringLiteral("P012: moved 0.5° in Rx")});
    row("180.0000,0.0000,0.0000", "180.0000,0.0000,-1.5000", {QStringLiteral("P012: moved -1.5° in Rz")});
    row("0,100,-200", "0,150,-260", {QStringLiteral("Line 2 C00000: moved 50 pulses in L, -60 pulses in U")});
    row("1,2,3,4,5,6", "1,2,3,4,5", {QStringLiteral("Line 3 C00001: values 1,2,3,4,5,6 → 1,2,3,4,5")});
    row("C00001=1", "///TOOL 2\r\nC00001=1",
        {QStringLiteral("Line 3 C00001: tool 0 → 2"), QStringLiteral("P012: tool 0 → 2"),
            QStringLiteral("P013: tool 0 → 2")});
    row("POSTYPE BASE", "POSTYPE ROBOT",
        {QStringLiteral("P012: type BASE → ROBOT"), QStringLiteral("P013: type BASE → ROBOT")});
    row("POSTYPE BASE", "LIMIT ON\r\n///POSTYPE BASE",
        {QStringLiteral("P012: marked as beyond the limit"), QStringLiteral("P013: marked as beyond the limit")});
    row("V=100.0", "V=150.0", {QStringLiteral("Line 3 MOVL: V 100.0 → 150.0")});
    row("V=100.0", "V=100.0 PL=0", {QStringLiteral("Line 3 MOVL: PL 0 added")});
    row("VJ=25.00", "", {QStringLiteral("Line 2 MOVJ: VJ 25.00 removed")});
    row("V=100.0", "V=100.0  //CAREFUL", {QStringLiteral("Line 3, comment added: “CAREFUL”")});
    row("DOUT OT", "COMM DOUT OT", {QStringLiteral("Line 4 commented out: COMM DOUT OT#(1) ON")});
    row("DOUT OT", "EDTLCK DOUT OT", {QStringLiteral("Line 4 locked against editing: EDTLCK DOUT OT#(1) ON")});
    row("OT#(1) ON", "OT#(1) OFF", {QStringLiteral("Line 4 DOUT OT#(1): ON → OFF")});
    row("OT#(1) ON", "OT#(2) ON", {QStringLiteral("Line 4 DOUT: OT#(1) → OT#(2)")});
    row("TIMER T=0.30", "WAIT IN#(1)=ON", {QStringLiteral("Line 5: TIMER T=0.30 → WAIT IN#(1)=ON")});
    row("TIMER T=0.30\r\n", "", {QStringLiteral("Line 5 removed: TIMER T=0.30")});
    row("END", "DOUT OT#(1) OFF\r\nEND", {QStringLiteral("Line 9 added: DOUT OT#(1) OFF")});
    row("B000>=20", "B000>=21", {QStringLiteral("Line 6 CALL: IF B000>=20 → B000>=21")});
    row("JOB:SUB", "JOB:OTHER", {QStringLiteral("Line 6 CALL: JOB:SUB → JOB:OTHER")});
    row("D001 + 1", "D001 + 2", {QStringLiteral("Line 7 SET: EXPRESS D001 + 1 → D001 + 2")});
    row("'START", "'BEGIN", {QStringLiteral("Line 1: 'START 08:30 → 'BEGIN 08:30")});
    row("COMM OLD", "COMM NEW", {QStringLiteral("Comment of the job: “OLD” → “NEW”")});
    row("SC,RW", "SC,RO", {QStringLiteral("The job is locked against editing")});
    row("SC,RW", "SC,RW,RJ", {QStringLiteral("Made a relative job")});
    row("//NAME A", "//NAME B", {QStringLiteral("Job name: “A” → “B”")});
    row("GROUP1 RB1", "GROUP1 RB1,ST1", {QStringLiteral("Control group GROUP1: RB1 → RB1,ST1")});
    row("//INST", "//ALIAS\r\n///GVARS 1,0,0,0,0,0,0,0\r\nB001 Count\r\n//INST",
        {QStringLiteral("Alias of B001 added: Count")});
    row("P00013=1.000,1.000,1.000,1.0000,1.0000,1.0000\r\n", "",
        {QStringLiteral("P013 removed: BASE 1.000,1.000,1.000,1.0000,1.0000,1.0000 TOOL 0")});
    row("2026/01/12", "2026/01/13", {});
    row("\r\n", "\n", {});
    row("1000.000", "1000.0", {});
    row("VJ=25.00", "VJ=25.0", {});
    row("TIMER", "\t TIMER", {});
}

void TestJobDiff::explains()
{
    QFETCH(QByteArray, before);
    QFETCH(QByteArray, after);
    QVERIFY(sample.contains(before));
    QTEST(explained(sample, QByteArray(sample).replace(before, after)), "texts");
}

void TestJobDiff::takesNoiseOut()
{
    const QByteArray newer = QByteArray(sample).replace("08:30\r\nMOVJ", "09:00\r\nMOVJ");
    QCOMPARE(explained(sample, newer).size(), 1);
    const Clean clean = [](const QByteArray &text) { return text.chopped(std::min<qsizetype>(5, text.size())); };
    QCOMPARE(explained(sample, newer, clean), QStringList());
}

void TestJobDiff::hasOneTextInAllLocales()
{
    QLocale::setDefault(QLocale(QLocale::German));
    const QStringList texts = explained(sample, QByteArray(sample).replace("620.000", "1623.200"));
    QLocale::setDefault(QLocale::c());
    QCOMPARE(texts, QStringList {QStringLiteral("P012: moved 1003.2 mm in Z")});
}

/// The example of reference §11.
void TestJobDiff::insertedStepIsOneEdit()
{
    const QByteArray head =
        "/JOB\r\n//NAME A\r\n//POS\r\n///NPOS 2,0,0,0,0,0\r\n///TOOL 0\r\n///POSTYPE PULSE\r\n///PULSE\r\n";
    const QByteArray inst = "//INST\r\n///DATE 2026/03/02 10:15\r\n///ATTR SC,RW\r\n///GROUP1 RB1\r\nNOP\r\n";
    const QByteArray older = head + "C00000=100,200,300,0,-400,0\r\nC00001=150,250,350,0,-450,0\r\n" + inst
        + "MOVJ C00000 VJ=10.00\r\nMOVL C00001 V=50.0\r\nEND\r\n";
    const QByteArray newer = head + "C00000=100,200,300,0,-400,0\r\nC00001=200,300,400,0,-500,0\r\n"
        + "C00002=150,250,350,0,-450,0\r\n" + inst
        + "MOVJ C00000 VJ=10.00\r\nMOVJ C00001 VJ=10.00\r\nMOVL C00002 V=50.0\r\nEND\r\n";
    const QStringList expected {
        QStringLiteral("Line 2 added: MOVJ C00001 VJ=10.00 (new point: PULSE 200,300,400,0,-500,0 TOOL 0)")};
    QCOMPARE(explained(older, newer), expected);
}

void TestJobDiff::saysWhichLinesMoved()
{
    const auto job = [](const QByteArray &lines) { return "/JOB\r\n//INST\r\nNOP\r\n" + lines + "END\r\n"; };
    const QByteArray block = "DOUT OT#(1) ON\r\nTIMER T=0.50\r\n";
    const QByteArray others = "SET B001 1\r\nSET B002 2\r\nSET B003 3\r\nSET B004 4\r\n";
    QCOMPARE(explained(job(block + others), job(others + block)),
        QStringList {QStringLiteral("2 line(s) moved from line 1 to line 5")});
}

void TestJobDiff::findsExactlyTheEdits()
{
    for (quint32 seed = 1; seed <= 2000; ++seed) {
        Generator generator {seed};
        generator.run();
        QStringList found;
        const Job newer = parse(print(generator.newer));
        for (const JobEdit &edit : diffJobs(parse(print(generator.older)), newer))
            found << summary(edit);
        if (found != generator.edits)
            qInfo("seed %u\n%s\n%s", seed, print(generator.older).constData(), print(generator.newer).constData());
        QCOMPARE(found, generator.edits);
    }
}

void TestJobDiff::bearsSize_data()
{
    QTest::addColumn<QByteArray>("older");
    QTest::addColumn<QByteArray>("newer");
    const auto lines = [](const char *format, int count) {
        QByteArray text = "/JOB\n//INST\nNOP\n";
        for (int line = 0; line < count; ++line)
            text += format + QByteArray::number(line) + '\n';
        return text;
    };
    QTest::newRow("everything is different") << lines("SET B001 ", 20000) << lines("SET B002 ", 20000);
    QTest::newRow("a long line") << "//INST\nMOVJ " + QByteArray("C00000 ").repeated(50000)
                                 << "//INST\nMOVJ " + QByteArray("C00001 ").repeated(50000);
    QTest::newRow("the same line") << lines("", 0) + QByteArray("NOP\n").repeated(50000)
                                   << lines("", 0) + QByteArray("NOP\n").repeated(60000);
}

void TestJobDiff::bearsSize()
{
    QFETCH(QByteArray, older);
    QFETCH(QByteArray, newer);
    QVERIFY(!diffJobs(parse(older), parse(newer)).isEmpty());
}

QTEST_GUILESS_MAIN(TestJobDiff)

#include "tst_jobdiff.moc"
