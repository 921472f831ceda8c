// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "virtualcontroller/filestore.h"

#include "inform/job.h"

#include <algorithm>

namespace virtualcontroller::filestore {

namespace {

enum Refusal : quint16 {
    Running = 0x2010,
    NotLoadable = 0x2120,
    Protected = 0x4020,
    IllegalName = 0x4190,
    OtherSyntax = 0x5310,
    BackupSetting = 0xE24F,
    FileEmpty = 0xE29C,
    WrongPath = 0xE2A0,
    NotInList = 0xE2A7,
    NotDeletable = 0xE2AF,
    NotFound = 0xE2B3,
    PathTooLong = 0xE2B4,
};

constexpr qsizetype maxBaseName = 32;
constexpr QByteArrayView batchBackup = "/SPDRV/CMOSBK.BIN";
const QByteArrayList loadable {"JBI", "JBR", "CND", "DAT", "PRM", "LST"};
const QByteArrayList listed = loadable + QByteArrayList {"SYS"};

QByteArray extension(const QByteArray &name)
{
    const auto dot = name.lastIndexOf('.');
    return dot < 0 ? QByteArray {} : name.sliced(dot + 1).toUpper();
}

QByteArray baseName(const QByteArray &name)
{
    const auto dot = name.lastIndexOf('.');
    return dot < 0 ? name : name.first(dot);
}

bool isJob(const QByteArray &name) { return extension(name) == "JBI" || extension(name) == "JBR"; }

/// A plain name, nothing with folders in it.
quint16 nameFault(const QByteArray &name)
{
    if (name.contains('/') || name.contains('\\'))
        return WrongPath;
    return baseName(name).size() > maxBaseName ? PathTooLong : 0;
}

/// A job that may be neither replaced nor deleted.
quint16 changeRefusal(const Memory &memory, const QByteArray &name)
{
    if (!isJob(name))
        return 0;
    if (memory.isJobInUse(baseName(name)))
        return Running;
    const auto job = memory.program(baseName(name));
    return job && job->isReadOnly ? Protected : 0;
}

quint16 overwriteRefusal(const Memory &memory, const QByteArray &name)
{
    if (!memory.files.contains(name))
        return 0;
    if (!memory.settings.mayOverwriteFiles)
        return memory.settings.overwriteRefusal;
    return changeRefusal(memory, name);
}

quint16 loadJob(Memory &memory, const QByteArray &contents)
{
    const auto job = parseProgram(contents);
    if (!job)
        return job.error();
    const QByteArray name = job->name + ".JBI";
    if (const quint16 refusal = overwriteRefusal(memory, name))
        return refusal;
    memory.files[name] = contents;
    return 0;
}

} // namespace

tl::expected<QByteArray, quint16> list(const Memory &memory, const QByteArray &filter)
{
    const bool meansJobs = filter.isEmpty() || filter == "*" || filter == "**";
    const QByteArray wanted = meansJobs ? QByteArray {"JBI"}
        : filter.startsWith("*.")       ? filter.sliced(2)
                                        : QByteArray {};
    if (wanted != "*" && !listed.contains(wanted))
        return tl::unexpected<quint16>(NotInList);
    QByteArray names;
    for (const auto &[name, contents] : memory.files) {
        if (wanted == "*" || extension(name) == wanted)
            names += name + "\r\n";
    }
    if (names.isEmpty() && memory.settings.refusesEmptyLists)
        return tl::unexpected<quint16>(NotInList);
    return names;
}

tl::expected<QByteArray, quint16> save(const Memory &memory, const QByteArray &name)
{
    const bool isBackup = name == batchBackup;
    if (isBackup && !memory.settings.hasBatchBackup)
        return tl::unexpected<quint16>(BackupSetting);
    if (const quint16 fault = isBackup ? 0 : nameFault(name))
        return tl::unexpected(fault);
    const auto file = memory.files.find(isBackup ? QByteArray {"CMOSBK.BIN"} : name);
    if (file == memory.files.end())
        return tl::unexpected<quint16>(NotFound);
    if (file->second.isEmpty())
        return tl::unexpected<quint16>(FileEmpty);
    return file->second;
}

quint16 remove(Memory &memory, const QByteArray &name)
{
    if (const quint16 fault = nameFault(name))
        return fault;
    if (!memory.files.contains(name))
        return NotFound;
    if (!isJob(name))
        return NotDeletable;
    if (const quint16 refusal = changeRefusal(memory, name))
        return refusal;
    memory.files.erase(name);
    return 0;
}

quint16 loadRefusal(const Memory &memory, const QByteArray &name)
{
    if (const quint16 fault = nameFault(name))
        return fault;
    if (!loadable.contains(extension(name)))
        return listed.contains(extension(name)) ? NotLoadable : NotInList;
    if (isJob(name) && !inform::isJobName(baseName(name)))
        return IllegalName;
    return overwriteRefusal(memory, name);
}

quint16 load(Memory &memory, const QByteArray &name, const QByteArray &contents)
{
    if (isJob(name))
        return loadJob(memory, contents);
    const bool isText = extension(name) == "LST" || contents.startsWith("//");
    if (!isText || contents.contains('\0'))
        return OtherSyntax;
    memory.files[name] = contents;
    return 0;
}

} // namespace virtualcontroller::filestore
