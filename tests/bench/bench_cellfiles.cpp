// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
//
// Joins a backup of 70 files and 500 jobs, reads each file as tables, and compares it with the next day. Prints what
// each costs beside hashing the same bytes, which every backup costs anyway. Nothing here passes or fails.
#include "cellfiles/filetypes.h"
#include "files/compare.h"
#include "station/differences.h"
#include "support/samples.h"
#include <QDir>
#include <QElapsedTimer>
#include <cstdio>

using values::FileName;

namespace {

constexpr int jobCount = 500;
constexpr int fileCount = 70;

/// A job of a hundred lines that moves with tool 1.
QByteArray job(int number)
{
    QByteArray text = "/JOB\r\n//NAME J" + QByteArray::number(number)
        + "\r\n//POS\r\n///NPOS 50,0,0,0,0,0\r\n///TOOL 1\r\n///POSTYPE PULSE\r\n///PULSE\r\n";
    for (int position = 0; position < 50; ++position)
        text += "C" + QByteArray::number(position).rightJustified(5, '0') + "=41000,52000,-30100,2500,-61200,"
            + QByteArray::number(number + position) + "\r\n";
    text += "//INST\r\n///DATE 2026/01/12 08:30\r\n///ATTR SC,RW\r\n///GROUP1 RB1\r\nNOP\r\n";
    for (int line = 0; line < 50; ++line)
        text += "MOVL C" + QByteArray::number(line).rightJustified(5, '0') + " V=200.0\r\n";
    return text + "END\r\n";
}

/// The samples of `folder` over those of the first day, and copies of one of them up to `fileCount`.
std::map<FileName, QByteArray> backup(const QStringList &folders)
{
    std::map<FileName, QByteArray> contents;
    for (const QString &folder : folders) {
        const QDir dir {QStringLiteral(PENDESK_TEST_DATA "/cell/") + folder};
        for (const QString &name : dir.entryList(QDir::Files))
            contents[*FileName::create(name.toLatin1())] = samples::read(folder + u'/' + name);
    }
    const QByteArray filler = samples::read(QStringLiteral("yrc1000/WEAV.CND"));
    for (int number = 0; int(contents.size()) < fileCount; ++number)
        contents[*FileName::create("WEAV" + QByteArray::number(number) + ".CND")] = filler;
    for (int number = 0; number < jobCount; ++number)
        contents[*FileName::create("J" + QByteArray::number(number) + ".JBI")] = job(number);
    return contents;
}

template <typename Work> double milliseconds(Work work)
{
    QElapsedTimer clock;
    clock.start();
    work();
    return double(clock.nsecsElapsed()) / 1e6;
}

void report(const char *what, double cost, double hashing)
{
    std::printf("%-32s %9.1f ms %8.1f times hashing\n", what, cost, cost / hashing);
}

} // namespace

int main()
{
    const auto first = backup({QStringLiteral("yrc1000")});
    files::FileSet older;
    const double hashing = milliseconds([&] { older = files::fileSetOf(first); });
    const auto newer = files::fileSetOf(backup({QStringLiteral("yrc1000"), QStringLiteral("yrc1000-later")}));
    qint64 bytes = 0;
    for (const auto &[name, content] : first)
        bytes += content.size();
    std::printf("%d files, %lld bytes\n", int(first.size()), static_cast<long long>(bytes));
    report("hashing", hashing, hashing);
    report("joining", milliseconds([&] { (void)station::knowledgeOf(older, samples::codec()); }), hashing);
    report("tables of all files", milliseconds([&] {
        for (const auto &[name, content] : first)
            (void)cellfiles::viewOf(name.bytes(), content, samples::codec());
    }),
        hashing);
    report("comparing with the next day",
        milliseconds([&] { (void)station::differencesOf(older, newer, files::NoiseFilter {}, samples::codec()); }),
        hashing);
}
