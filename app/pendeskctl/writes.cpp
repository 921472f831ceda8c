// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "writes.h"

#include "named.h"
#include "protocol/datarequests.h"
#include "robot/numbering.h"
#include <memory>

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
    const protocol::ReadSystemInformation order {robot::topics::systemInformation.number};
    desk.robot().send(order, &desk, [&desk, reference, typed](const Result<values::SystemInformation> &system) {
        if (!system)
            return desk.fail(system.error());
        if (robot::isNumberingKnown(desk.call().profile, *system))
            return writeNow(desk, reference, typed);
        desk.fail({values::ErrorKind::NotSent, 0, 0,
            tr("The software of the controller is another than that with which the numbering was verified. Verify it "
               "again, or say --numbering 0 or --numbering 1.")});
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

} // namespace

int setVariable(const Call &call, const QString &word, const QString &typed)
{
    const auto reference = variables::referenceFromText(word, askedDialect(call));
    if (!reference)
        return mistake(reference.error().detail);
    if (variables::isPosition(reference->kind))
        return mistake(tr("Positions are not written from the command line."));
    if (reference->number >= writableCountOf(reference->kind, askedDialect(call)))
        return mistake(tr("%1 cannot be written.").arg(toString(*reference)));
    const bool isToldNumbering = reference->kind == variables::Kind::M || call.hasNumbering;
    if (!isToldNumbering && !call.profile.numberingVerified.isValid())
        return mistake(
            tr("Nobody has verified which instance a variable has on this controller. Compare one value with "
               "the pendant, then say --numbering 0 or --numbering 1."));
    if (const auto end = requireYes(call))
        return *end;
    return run(call, [=](Desk &desk) {
        isToldNumbering ? writeNow(desk, *reference, typed) : writeIfVerified(desk, *reference, typed);
    });
}

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

} // namespace pendeskctl
