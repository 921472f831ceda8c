// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "files/bag.h"

#include "disk/durable.h"
#include <QDir>

using values::ErrorKind;
using values::FileName;
using values::Result;

namespace files {

namespace {

const QString declarationName = QStringLiteral("bagit.txt");
const QString infoName = QStringLiteral("bag-info.txt");
const QString manifestName = QStringLiteral("manifest-sha256.txt");

QString partial(const QString &path) { return path + QStringLiteral(".partial"); }

/// The first name for `taken` that is free in `folder`.
QString freeId(const QString &folder, const QDateTime &taken)
{
    const QString stem = taken.toUTC().toString(QStringLiteral("yyyy-MM-dd'T'HHmmss'Z'"));
    QString id = stem;
    for (int number = 2; QFileInfo::exists(folder + u'/' + id); ++number)
        id = QStringLiteral("%1-%2").arg(stem).arg(number);
    return id;
}

tl::unexpected<values::Error> local(const QString &detail) { return values::failure(ErrorKind::LocalFile, detail); }

} // namespace

Result<std::unique_ptr<BagWriter>> BagWriter::create(const QString &folder, const QDateTime &taken)
{
    std::unique_ptr<BagWriter> writer {new BagWriter {folder, freeId(folder, taken)}};
    QDir {writer->path()}.removeRecursively();
    if (!QDir {}.mkpath(writer->path() + QStringLiteral("/data")))
        return local(QStringLiteral("%1: the folder cannot be made").arg(writer->path()));
    // Addresses, users and passwords of the controller are among the files.
    QFile::setPermissions(writer->path(), QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    return writer;
}

BagWriter::~BagWriter()
{
    if (!m_isSealed)
        QDir {path()}.removeRecursively();
}

QString BagWriter::path() const { return partial(m_folder + u'/' + m_id); }

Result<void> BagWriter::add(const FileName &name, const QByteArray &content)
{
    const QString inside = QStringLiteral("data/") + m_names.take(name);
    auto written = disk::writeNew(path() + u'/' + inside, content);
    if (written) {
        m_manifest[inside.toUtf8()] = sha256(content);
        m_bytes += content.size();
    }
    return written;
}

Result<void> BagWriter::addTag(Manifest &tags, const QString &name, const QByteArray &content)
{
    tags[name.toUtf8()] = sha256(content);
    return disk::writeNew(path() + u'/' + name, content);
}

Result<void> BagWriter::writeTags(const BagInfo &info)
{
    Manifest tags;
    return addTag(tags, declarationName, bagDeclaration())
        .and_then([&] { return addTag(tags, infoName, toText(info, m_bytes, int(m_manifest.size()))); })
        .and_then([&] { return addTag(tags, manifestName, toText(m_manifest)); })
        .and_then([&] { return disk::writeNew(path() + QStringLiteral("/tagmanifest-sha256.txt"), toText(tags)); });
}

Result<QString> BagWriter::seal(const BagInfo &info)
{
    if (const auto written = writeTags(info).and_then([this] { return disk::syncTree(path()); }); !written)
        return tl::unexpected(written.error());
    QString target = m_folder + u'/' + m_id;
    if (!QDir {}.rename(path(), target))
        return local(QStringLiteral("%1: the folder cannot be renamed").arg(path()));
    m_isSealed = true;
    return disk::sync(m_folder).map([&] { return target; });
}

Result<Bag> Bag::open(const QString &path)
{
    const auto declaration = disk::readFile(path + u'/' + declarationName);
    const auto manifest = disk::readFile(path + u'/' + manifestName).map(manifestFrom);
    const auto info = disk::readFile(path + u'/' + infoName);
    if (!declaration || *declaration != bagDeclaration() || !manifest || !info)
        return local(QStringLiteral("%1: this is no backup").arg(path));
    if (!*manifest)
        return local(QStringLiteral("%1: the list of files is damaged").arg(path));
    Bag bag;
    bag.m_path = path;
    bag.m_info = bagInfoFrom(*info);
    bag.m_manifest = **manifest;
    return bag;
}

FileSet Bag::files() const
{
    FileSet set;
    std::map<FileName, QString> paths;
    for (const auto &[inside, hash] : m_manifest) {
        const auto name = fromLocalName(QString::fromUtf8(inside.mid(5)));
        if (!name || !inside.startsWith("data/"))
            continue;
        set.hashes[*name] = hash;
        paths[*name] = m_path + u'/' + QString::fromUtf8(inside);
    }
    markUnread(set, m_info.results);
    set.content = [paths, hashes = set.hashes](const FileName &name) -> Result<QByteArray> {
        const auto path = paths.find(name);
        if (path == paths.end())
            return local(QStringLiteral("%1 is not in the backup").arg(QString::fromLatin1(name.bytes())));
        auto content = disk::readFile(path->second);
        if (content && sha256(*content) != hashes.at(name))
            return local(QStringLiteral("%1 is not as it was written").arg(path->second));
        return content;
    };
    return set;
}

} // namespace files
