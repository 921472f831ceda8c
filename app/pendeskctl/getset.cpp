// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "named.h"
#include "protocol/requests.h"
#include "verbs.h"
#include "writes.h"

using values::Result;

namespace pendeskctl {

namespace {

/// "5", "0..99" with what `registers` means by them.
QString registerWord(const QString &word) { return word.startsWith(u'M') ? word : u'M' + word; }

int getNamed(const Call &call, const QStringList &words)
{
    return run(call, [words](Desk &desk) {
        const auto wanted = selectionsFromText(desk.call(), words);
        if (!wanted)
            return desk.finish(Usage);
        readAll(desk, *wanted, [&desk](const Result<QList<NamedValue>> &values) {
            if (!values)
                return desk.fail(values.error());
            print(desk.call(), *values);
            desk.finish(Done);
        });
    });
}

using Setter = int (*)(const Call &call, const QString &word, const QString &typed);

int getOrSet(const QStringList &arguments, VerbHelp help, QString (*wordOf)(const QString &), Setter set)
{
    Call call;
    QCommandLineParser parser;
    help.mostWords = anyNumber;
    if (const auto end = read(call, parser, help, arguments))
        return *end;
    QStringList words = call.words.mid(1);
    const QString what = call.words.value(0);
    if (what == u"get") {
        for (QString &word : words)
            word = wordOf(word);
        return getNamed(call, words);
    }
    if (what == u"set" && words.size() == 2)
        return set(call, wordOf(words[0]), words[1]);
    return mistake(tr("Say “get NAME…” or “set NAME VALUE”."));
}

QString asItIs(const QString &word) { return word; }

} // namespace

int runIo(const QStringList &arguments)
{
    return getOrSet(arguments,
        {tr("Reads rows of I/O groups (2701..2710) or signals (27010, IN#(1)); writes one network input."),
            QStringLiteral("get GROUP[..GROUP]|SIGNAL… | set SIGNAL 0|1")},
        asItIs, setSignal);
}

int runRegisters(const QStringList &arguments)
{
    return getOrSet(arguments,
        {tr("Reads registers; writes one and reads it back."), QStringLiteral("get N[..N]… | set N VALUE")},
        registerWord, setVariable);
}

int runVar(const QStringList &arguments)
{
    return getOrSet(arguments,
        {tr("Reads variables B I D R S P BP EX; writes one and reads it back."),
            QStringLiteral("get NAME[..NAME]… | set NAME VALUE")},
        asItIs, setVariable);
}

} // namespace pendeskctl
