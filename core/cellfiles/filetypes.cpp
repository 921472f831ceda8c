// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "cellfiles/filetypes.h"

#include "cellfiles/views.h"

namespace cellfiles {

namespace {

constexpr auto configuration = FileClass::Configuration;
constexpr auto log = FileClass::Log;
constexpr auto counter = FileClass::Counter;
constexpr auto allowed = Restore::Allowed;
constexpr auto care = Restore::Care;
constexpr auto never = Restore::Never;

// In the order of the controller files reference §2; the first pattern that fits counts.
constexpr std::array types {
    FileType {"*.JBI", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Job"), configuration, allowed, false, 3, jobView},
    FileType {"TOOL.CND", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Tools"), configuration, care, true, 1, toolView},
    FileType {"UFRAME.CND", QT_TRANSLATE_NOOP("cellfiles::Sentences", "User frames"), configuration, care, true, 1,
        userFrameView},
    FileType {"CUBEINTF.CND", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Interference areas"), configuration, care,
        true, 1, cubeView},
    FileType {"SHOCKLVL.CND", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Collision detection"), configuration, care,
        true, 1, shockView},
    FileType {"WEAV.CND", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Weaving conditions"), configuration, allowed,
        false, 1, weavingView},
    FileType {"ARCSRT.CND", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Arc start conditions"), configuration, allowed,
        false, 1, arcView},
    FileType {"ARCEND.CND", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Arc end conditions"), configuration, allowed,
        false, 1, arcView},
    FileType {"ARCSUP.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Arc auxiliary conditions"), configuration,
        allowed, false, 1, blockView},
    FileType {"WELD*.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Welders"), configuration, allowed, false, 1,
        welderView},
    FileType {"FORMCUT.CND", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Cutting shapes"), configuration, allowed, false,
        1, shapeView},
    FileType {"PMCOND.CND", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Maintenance conditions"), configuration, allowed,
        false, 1, blockView},
    FileType {"VAR.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Variables"), FileClass::Data, allowed, false, 5,
        variableView},
    FileType {"VARNAME.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Names of variables"), configuration, allowed,
        false, 2, variableNameView},
    FileType {"IONAME.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Names of signals"), configuration, allowed,
        false, 2, signalNameView},
    FileType {"EXIONAME.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Names of external signals"), configuration,
        allowed, false, 2, signalNameView},
    FileType {"IOMNAME.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Names of registers"), configuration, allowed,
        false, 2, registerNameView},
    FileType {"TMNAME.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Names of timers"), configuration, allowed, false,
        2, timerNameView},
    FileType {
        "TMVAR.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Timers"), configuration, allowed, false, 2, blockView},
    FileType {"SETTM.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Timer settings"), configuration, allowed, false,
        2, blockView},
    FileType {"USRIOVAR.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Watch list"), configuration, allowed, false, 2,
        blockView},
    FileType {"USRGRP*.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Groups of signals"), configuration, allowed,
        false, 2, signalGroupView},
    FileType {"UWORD.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "User words"), configuration, allowed, false, 2,
        blockView},
    FileType {"USERMENU.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "User menus"), configuration, allowed, false, 2,
        blockView},
    FileType {"FLNAME.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Names of flags"), configuration, allowed, false,
        2, blockView},
    FileType {"KEYALLOC.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Key functions"), configuration, care, false, 2,
        blockView},
    FileType {"IFPANEL.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Interface panels"), configuration, care, false,
        2, blockView},
    FileType {"MACRO.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Macro commands"), configuration, allowed, false,
        4, blockView},
    FileType {
        "CIOPRG.LST", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Ladder"), configuration, never, true, 6, ladderView},
    FileType {"PSEUDOIN.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Pseudo inputs"), configuration, never, true, 6,
        pseudoInputView},
    FileType {"EIOALLOC.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "I/O boards"), configuration, never, true, 6,
        blockView},
    FileType {
        "IOAXIS.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "I/O axes"), configuration, never, true, 6, blockView},
    FileType {"ETHERIP.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "EtherNet/IP"), configuration, never, false, 6,
        addressView},
    FileType {"APEIP.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "EtherNet/IP"), configuration, never, false, 6,
        addressView},
    FileType {"IPNETCFG.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Network"), configuration, never, false, 6,
        networkView},
    FileType {"IPNETEX.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Network"), configuration, never, false, 6,
        networkView},
    FileType {"NATRULE.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Address translation"), configuration, never,
        false, 6, addressView},
    FileType {"RMTUSRID.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Remote users"), configuration, never, false, 6,
        secretView},
    FileType {"ABSO.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Home positions of the encoders"), configuration,
        never, true, 6, encoderOffsetView},
    FileType {"HOME2.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Second home position"), configuration, never,
        true, 6, homePositionView},
    FileType {"OPEORG.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Operation origin"), configuration, never, true,
        6, homePositionView},
    FileType {"RBCALIB.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Robot calibration"), configuration, never, true,
        6, blockView},
    FileType {"TOOLINTF.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Tool interference"), configuration, never,
        true, 6, blockView},
    FileType {"RARRSET.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Arrangement of robots"), configuration, never,
        true, 6, blockView},
    FileType {"APPRBUZR.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Approach buzzer"), configuration, never, true,
        6, blockView},
    FileType {"GCSVASV.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Servo assistance"), configuration, never, true,
        6, blockView},
    FileType {"YSFLOGIC.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Safety logic"), configuration, never, true, 6,
        blockView},
    FileType {"*RNGLMT.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Range limits"), configuration, never, true, 6,
        blockView},
    FileType {"AXSPDMON.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Axis speed monitor"), configuration, never,
        true, 6, blockView},
    FileType {"SPDLMT.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Speed limits"), configuration, never, true, 6,
        speedLimitView},
    FileType {"TLANGMON.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Tool angle monitor"), configuration, never,
        true, 6, blockView},
    FileType {"CRCMON.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Check sums of safety data"), log, never, true, 6,
        blockView},
    FileType {
        "*.PRM", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Parameters"), configuration, never, true, 6, parameterView},
    FileType {
        "SYSTEM.SYS", QT_TRANSLATE_NOOP("cellfiles::Sentences", "System"), configuration, never, false, 6, systemView},
    FileType {"PANELBOX.LOG", QT_TRANSLATE_NOOP("cellfiles::Sentences", "System, options and change dates"),
        configuration, never, false, 6, panelBoxView},
    FileType {"LOGDATA.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Operation log"), log, never, false, 6, logView},
    FileType {
        "ALMHIST.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Alarm history"), log, never, false, 6, alarmView},
    FileType {
        "IOMSGHST.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Message history"), log, never, false, 6, blockView},
    FileType {
        "HISPDLOG.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Fast events"), log, never, false, 6, addressView},
    FileType {"RBSTPFCT.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Reasons of stops"), log, never, false, 6,
        stopReasonView},
    FileType {"PMTMMNG.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Maintenance counters"), counter, never, false,
        6, blockView},
    FileType {"PMLOG.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Maintenance counters"), counter, never, false, 6,
        blockView},
    FileType {"PMHARD.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Maintenance counters"), counter, never, false, 6,
        blockView},
    FileType {"PMTRQDB.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Torque counters"), counter, never, false, 6,
        blockView},
    FileType {"TRQDAT.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Torque counters"), counter, never, false, 6,
        blockView},
    FileType {
        "ENCHEAT.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Encoder heat"), counter, never, false, 6, blockView},
    FileType {"STEPDIAG.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Step diagnosis"), counter, never, false, 6,
        blockView},
    FileType {
        "JOBMONI.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Job monitor"), counter, never, false, 6, blockView},
    FileType {"ROBOMONI.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Robot monitor"), counter, never, false, 6,
        blockView},
    FileType {
        "SVMON.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Servo monitor"), counter, never, false, 6, blockView},
    FileType {"REGENE.DAT", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Regeneration unit"), counter, never, false, 6,
        blockView},
    FileType {"*.BIN", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Memory image"), configuration, never},
    FileType {"*.HEX", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Memory image"), configuration, never},
    FileType {"*.LOG", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Log"), log, never},
    FileType {"*", QT_TRANSLATE_NOOP("cellfiles::Sentences", "Unknown file"), configuration, care, false, 6, blockView},
};

/// With at most one star in the pattern.
bool matches(QByteArrayView pattern, QByteArrayView name)
{
    const auto star = pattern.indexOf('*');
    const auto isSame = [](QByteArrayView a, QByteArrayView b) { return a.compare(b, Qt::CaseInsensitive) == 0; };
    if (star < 0)
        return isSame(pattern, name);
    const QByteArrayView start = pattern.first(star);
    const QByteArrayView end = pattern.sliced(star + 1);
    return name.size() >= start.size() + end.size() && isSame(name.first(start.size()), start)
        && isSame(name.last(end.size()), end);
}

/// A file that was given another name is known by its first header: "//VAR", "/IONAME".
const FileType &typeByContent(QByteArrayView file)
{
    const qsizetype glance = 64;
    Warnings ignored;
    const Outline outline = outlineOf(file.first(std::min(file.size(), glance)), ignored);
    const QByteArray stem = outline.blocks.empty() ? QByteArray {} : outline.blocks.front().word.toByteArray() + '.';
    const auto found = std::ranges::find_if(
        types, [&](const FileType &type) { return stem.size() > 1 && QByteArrayView {type.pattern}.startsWith(stem); });
    return found == types.end() ? types.back() : *found;
}

} // namespace

std::span<const FileType> fileTypes() { return types; }

const FileType &fileTypeOf(QByteArrayView name)
{
    return *std::ranges::find_if(types, [name](const FileType &type) { return matches(type.pattern, name); });
}

bool isText(QByteArrayView file)
{
    constexpr qsizetype glance = 4096;
    return std::ranges::none_of(file.first(std::min(file.size(), glance)),
        [](char byte) { return quint8(byte) < ' ' && byte != '\r' && byte != '\n' && byte != '\t' && byte != '\0'; });
}

View viewOf(QByteArrayView name, QByteArrayView file, const protocol::TextCodec &codec)
{
    const FileType &named = fileTypeOf(name);
    const FileType &type = &named == &types.back() ? typeByContent(file) : named;
    return type.view && isText(file) ? type.view(file, codec) : View {};
}

} // namespace cellfiles
