// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "support/fuzz/target.h"

#include "disk/durable.h"
#include "files/bag.h"
#include "files/bagtext.h"
#include <QDir>
#include <QTemporaryDir>

namespace fuzz {

namespace {

const QStringList tagNames {QStringLiteral("bagit.txt"), QStringLiteral("bag-info.txt"),
    QStringLiteral("manifest-sha256.txt"), QStringLiteral("tagmanifest-sha256.txt"), QStringLiteral("data/A.JBI")};

void write(const QString &path, const QByteArray &content)
{
    QFile file {path};
    require(file.open(QIODevice::WriteOnly) && file.write(content) == content.size(), "no room for a bag");
}

/// A small good backup on the disk, of which one file at a time is something else.
struct Backup {
    Backup()
    {
        auto writer = files::BagWriter::create(folder.path(), QDateTime::currentDateTimeUtc());
        require(writer && (*writer)->add(*values::FileName::create("A.JBI"), "/JOB\r\n").has_value(), "no bag");
        const auto sealed = (*writer)->seal({});
        require(sealed.has_value(), "no bag");
        path = *sealed;
        for (const QString &name : tagNames)
            good << disk::readFile(path + u'/' + name).value_or(QByteArray {});
    }
    QTemporaryDir folder;
    QString path;
    QList<QByteArray> good;
};

/// The first byte chooses a file of a backup; its content follows. Only what was written is good.
void take(QByteArrayView data)
{
    static const Backup backup;
    Source source {data};
    const qsizetype which = source.byte() % tagNames.size();
    const QByteArray content = source.rest().toByteArray();
    const QString path = backup.path + u'/' + tagNames[which];
    write(path, content);
    (void)files::Bag::open(backup.path);
    require(files::verify(backup.path).isGood() == (content == backup.good[which]), "a changed backup is good");
    write(path, backup.good[which]);
}

Seeds seeds()
{
    const QByteArray declaration = files::bagDeclaration();
    return {'\0' + declaration, '\1' + files::toText(files::BagInfo {}, 6, 1),
        '\2' + files::sha256("/JOB\r\n") + "  data/A.JBI\n", '\3' + files::sha256(declaration) + "  bagit.txt\n",
        "\4/JOB\r\n"};
}

} // namespace

extern const Target bag;
const Target bag {"bag", take, seeds, 320, 200};

} // namespace fuzz
