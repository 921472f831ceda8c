// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "named.h"
#include "protocol/requests.h"
#include "verbs.h"
#include <memory>

using values::Result;

namespace pendeskctl {

namespace {

/// "5", "0..99" with what `registers` means by them.
QString registerWord(const QString &word) { return word.startsWith(u'M') ? word : u'M' + word; }

int getNamed(const Call &call, const QStringList &words)
{
    const auto wanted = selectionsFromText(call, words);
    if (!wanted)
        return Usage;
    return run(call, [wanted](Desk &desk) {
        readAll(desk, *wanted, [&desk](const Result<QList<NamedValue>> &values) {
            if (!values)
                return desk.fail(values.error());
            print(desk.call(), *values);
            desk.finish(Done);
        });
    });
}

int setVariable(const Call &call, const QString &word, const QString &typed)
{
    const auto reference = variables::referenceFromText(word, call.profile.dialect());
    if (!reference)
        return mistake(reference.error().detail);
    if (variables::isPosition(reference->kind))
        return mistake(tr("Positions are not written from the command line."));
    const bool isRegister = reference->kind == variables::Kind::M;
    if (reference->number >= writableCountOf(reference->kind, call.profile.dialect()))
        return mistake(tr("%1 cannot be written.").arg(toString(*reference)));
    if (!isRegister && !call.hasNumbering)
        return mistake(
            tr("Nobody has verified which instance a variable has on this controller. Compare one value with "
               "the pendant, then say --numbering 0 or --numbering 1."));
    if (const auto end = requireYes(call))
        return *end;
    return run(call, [reference, typed](Desk &desk) {
        write(desk, *reference, typed, [&desk](const Result<NamedValue> &written) {
            if (written) {
                print(desk.call(), {*written});
                return desk.finish(Done);
            }
            if (written.error().kind != values::ErrorKind::Malformed)
                return desk.fail(written.error());
            complain(tr("Another value was read back: %1").arg(written.error().detail));
            desk.finish(VerificationFailed);
        });
    });
}

/// Reads the group, changes one bit, writes the group and reads it back: eight signals travel together.
struct SignalWriter : std::enable_shared_from_this<SignalWriter> {
    SignalWriter(Desk &someDesk, const Selection &someSelection, bool someValue)
        : desk {someDesk}, selection {someSelection}, isOn {someValue}
    {
    }
    using Group = values::IoGroup;

    void begin()
    {
        desk.robot().send(protocol::ReadItem<Group> {instance()}, &desk,
            [self = shared_from_this()](const Result<Group> &group) { self->change(group); });
    }
    void change(const Result<Group> &group)
    {
        if (!group)
            return desk.fail(group.error());
        const Group wanted = group->with(selection.bit, isOn);
        desk.robot().send(protocol::WriteItem<Group> {instance(), wanted}, &desk,
            [self = shared_from_this()](const Result<void> &done) {
                if (!done)
                    return self->desk.fail(done.error());
                self->readBack();
            });
    }
    void readBack()
    {
        readAll(desk, {selection}, [self = shared_from_this()](const Result<QList<NamedValue>> &values) {
            if (!values)
                return self->desk.fail(values.error());
            print(self->desk.call(), *values);
            self->desk.finish(values->first().json.toInt() == int(self->isOn) ? Done : VerificationFailed);
        });
    }
    [[nodiscard]] quint16 instance() const { return quint16(selection.first); }

    Desk &desk;
    Selection selection;
    bool isOn;
};

int setSignal(const Call &call, const QString &word, const QString &typed)
{
    const auto selection = selectionFromText(word, call.profile.dialect());
    if (!selection)
        return mistake(selection.error().detail);
    if (selection->what != Selection::What::Signal || (typed != u"0" && typed != u"1"))
        return mistake(tr("io set takes one signal, such as 27010, and 0 or 1."));
    if (call.profile.dialect().ioArea(quint32(selection->first)) != protocol::IoArea::NetworkInput)
        return mistake(tr("%1 cannot be written: HSES writes network inputs alone.").arg(word));
    if (const auto end = requireYes(call))
        return *end;
    return run(call,
        [selection, typed](Desk &desk) { std::make_shared<SignalWriter>(desk, *selection, typed == u"1")->begin(); });
}

using Setter = int (*)(const Call &call, const QString &word, const QString &typed);

int getOrSet(const QStringList &arguments, const VerbHelp &help, QString (*wordOf)(const QString &), Setter set)
{
    Call call;
    QCommandLineParser parser;
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
