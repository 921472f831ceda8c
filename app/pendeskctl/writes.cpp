// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "writes.h"

#include "named.h"
#include "robot/iowrite.h"

using values::Result;

namespace pendeskctl {

namespace {

void writeNow(Desk &desk, const variables::Reference &reference, const QString &typed)
{
    write(desk, reference, typed, [&desk](const Result<NamedValue> &written) {
        if (written) {
            print(desk.call(), {*written});
            return desk.finish(Done);
        }
        if (written.error().kind != values::ErrorKind::Malformed)
            return desk.fail(written.error());
        complain(tr("Another value was read back: %1").arg(written.error().detail));
        desk.finish(VerificationFailed);
    });
}

/// Writes if the controller still is what the profile's numbering was compared with.
void writeIfVerified(Desk &desk, const variables::Reference &reference, const QString &typed)
{
    const bool isRegister = reference.kind == variables::Kind::M;
    if (isRegister || desk.station().orders.situation().isNumberingVerified)
        return writeNow(desk, reference, typed);
    desk.fail({values::ErrorKind::NotSent, 0, 0,
        tr("The software of the controller is another than that with which the numbering was verified. Verify it "
           "again, or say --numbering 0 or --numbering 1.")});
}

/// Ends the program with what was wrong with the call.
void refuse(Desk &desk, const QString &sentence) { desk.finish(mistake(sentence)); }

void setVariableAt(Desk &desk, const QString &word, const QString &typed)
{
    const auto reference = variables::referenceFromText(word, askedDialect(desk.call()));
    if (!reference)
        return refuse(desk, reference.error().detail);
    if (variables::isPosition(reference->kind))
        return refuse(desk, tr("Positions are not written from the command line."));
    if (reference->number >= writableCountOf(reference->kind, askedDialect(desk.call())))
        return refuse(desk, tr("%1 cannot be written.").arg(toString(*reference)));
    const Call &call = desk.call();
    if (reference->kind != variables::Kind::M && !call.hasNumbering && !call.profile.numberingVerified.isValid())
        return refuse(desk,
            tr("Nobody has verified which instance a variable has on this controller. Compare one value with "
               "the pendant, then say --numbering 0 or --numbering 1."));
    desk.openStation([&desk, reference, typed] { writeIfVerified(desk, *reference, typed); });
}

/// The group is read first, since eight signals travel together; see robot::IoWrite.
void switchSignal(Desk &desk, const names::Signal &signal, bool isOn)
{
    using Step = robot::IoWrite::Step;
    auto *write = new robot::IoWrite(desk.station().orders, signal, &desk);
    QObject::connect(write, &robot::IoWrite::changed, &desk, [&desk, write, isOn] {
        switch (write->step()) {
        case Step::Reading:
        case Step::Writing: return;
        case Step::Ready: return write->isOn() == isOn ? write->write() : write->setOn(isOn); // which leads here again
        case Step::Changed:
            return desk.fail({values::ErrorKind::NotSent, 0, 0,
                tr("Another signal of the group changed meanwhile; nothing was sent.")});
        case Step::Done:
        case Step::Mismatch: {
            const int now = int(write->readBack()->isOn(write->signal().bit));
            print(desk.call(), {{toString(write->signal()), QString::number(now), now}});
            return desk.finish(write->step() == Step::Done ? Done : VerificationFailed);
        }
        case Step::Refused:
        case Step::Unknown:
        case Step::Failed: return desk.fail(write->error());
        }
    });
    write->read();
}

void setSignalAt(Desk &desk, const QString &word, const QString &typed)
{
    const auto selection = selectionFromText(word, desk.dialect());
    if (!selection)
        return refuse(desk, selection.error().detail);
    if (selection->what != Selection::What::Signal)
        return refuse(desk, tr("io set takes one signal, such as 27010, and 0 or 1."));
    if (desk.dialect().ioArea(quint32(selection->first)) != protocol::IoArea::NetworkInput)
        return refuse(desk, tr("%1 cannot be written: HSES writes network inputs alone.").arg(word));
    const names::Signal signal {selection->first, selection->bit};
    desk.openStation([&desk, signal, isOn = typed == u"1"] { switchSignal(desk, signal, isOn); });
}

} // namespace

int setVariable(const Call &call, const QString &word, const QString &typed)
{
    if (const auto end = requireYes(call))
        return *end;
    return run(call, [word, typed](Desk &desk) { setVariableAt(desk, word, typed); });
}

int setSignal(const Call &call, const QString &word, const QString &typed)
{
    if (typed != u"0" && typed != u"1")
        return mistake(tr("io set takes one signal, such as 27010, and 0 or 1."));
    if (const auto end = requireYes(call))
        return *end;
    return run(call, [word, typed](Desk &desk) { setSignalAt(desk, word, typed); });
}

} // namespace pendeskctl
