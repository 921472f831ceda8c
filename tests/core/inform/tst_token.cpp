// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "inform/token.h"

#include <QTest>

using namespace inform;

namespace {

QString nameOf(TokenKind kind)
{
    static constexpr const char *names[] {"header", "comment", "label", "prefix", "part", "word", "tag", "keyword",
        "job", "alias", "variable", "point", "signal", "numbered", "element", "number", "operator", "string",
        "trailing", "unknown"};
    return QString::fromLatin1(names[int(kind)]);
}

} // namespace

/// One line is cut as reference §5.5 says.
class TestToken : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void cuts_data();
    void cuts();
};

void TestToken::cuts_data()
{
    QTest::addColumn<QByteArray>("line");
    QTest::addColumn<QString>("tokens");
    const auto row = [](const char *line, const char *tokens) {
        QTest::addRow("%s", line) << QByteArray(line) << QString::fromLatin1(tokens);
    };
    row("", "");
    row("  \t ", "");
    row("///TOOL 0", "header[///TOOL 0]");
    row("C00000=1,2", "point[C00000] operator[=] number[1,2]");
    row("'A // B", "comment['A // B]");
    row("*MY LAB", "label[*MY LAB]");
    row("COMM 'A", "prefix[COMM] comment['A]");
    row("EDTLCK COMM \t MOVJ P001", "prefix[EDTLCK] prefix[COMM] word[MOVJ] variable[P001]");
    row("MOVJ C00000 VJ=5.00  +MOVJ EC00001  //A \"B",
        "word[MOVJ] point[C00000] tag[VJ=] number[5.00] part[+] word[MOVJ] "
        "point[EC00001] trailing[//A \"B]");
    row("JUMP *MY LAB IF IN#(1)=ON", "word[JUMP] label[*MY LAB] keyword[IF] signal[IN#(1)] operator[=] keyword[ON]");
    row("JUMP LABEL: B011", "word[JUMP] keyword[LABEL:] variable[B011]");
    row("CALL JOB:A-B ARGFWidth ARGF-2.5 ARGF\"m /s\" ARGFB001",
        "word[CALL] job[JOB:A-B] tag[ARGF] alias[Width] tag[ARGF] number[-2.5] tag[ARGF] string[\"m /s\"] tag[ARGF] "
        "variable[B001]");
    row("SET D000  EXPRESS ( D001 * 2 ) / -I003 - 5",
        "word[SET] variable[D000] keyword[EXPRESS] operator[(] "
        "variable[D001] operator[*] number[2] operator[)] operator[/] "
        "operator[-] variable[I003] operator[-] number[5]");
    row("SETE P001 (1) -100", "word[SETE] variable[P001] element[(1)] number[-100]");
    row("IFTHENEXP Mode=1 ANDEXP LI000<>-9",
        "word[IFTHENEXP] alias[Mode] operator[=] number[1] keyword[ANDEXP] variable[LI000] operator[<>] number[-9]");
    row("WAIT IN#(LI004)=OFF T=I001", "word[WAIT] signal[IN#(LI004)] operator[=] keyword[OFF] tag[T=] variable[I001]");
    row("CAT$ S011 S010 \" mm\"", "word[CAT$] variable[S011] variable[S010] string[\" mm\"]");
    row("GETS PX010 $PX001", "word[GETS] variable[PX010] variable[$PX001]");
    row("GETS B000 $RV", "word[GETS] variable[B000] variable[$RV]");
    row("COMARCON AMP=1.0 U/D=0.5", "word[COMARCON] tag[AMP=] number[1.0] tag[U/D=] number[0.5]");
    row("MOVL P[I007] V=Speed UF#(1)", "word[MOVL] variable[P[I007]] tag[V=] unknown[Speed] numbered[UF#(1)]");
    row("SKILLSND SL5 \"OPEN", "word[SKILLSND] keyword[SL5] string[\"OPEN]");
    row("007=1", "unknown[007=1]");
    row("MSG \"\x83[//\x95\\\"", "word[MSG] string[\"\x83[//\x95\\\"]");
    row("CALL JOB:\x83\x8F\x81[\x83N IF B001=1",
        "word[CALL] job[JOB:\x83\x8F\x81[\x83N] keyword[IF] variable[B001] operator[=] number[1]");
}

void TestToken::cuts()
{
    QFETCH(QByteArray, line);
    QStringList found;
    for (const Token &token : tokenize(line, {{"Width", "LD000"}, {"Mode", "LI000"}}))
        found << nameOf(token.kind) + u'[' + QString::fromLatin1(token.in(line).toByteArray()) + u']';
    QTEST(found.join(u' '), "tokens");
}

QTEST_GUILESS_MAIN(TestToken)

#include "tst_token.moc"
