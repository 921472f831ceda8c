// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "files/bag.h"

#include "disk/durable.h"
#include <QCoreApplication>
#include <QDir>
#include <QDirIterator>

namespace files {

namespace {

struct VerifyTexts {
    Q_DECLARE_TR_FUNCTIONS(files::Verify)
};

/// Goes through one bag.
class Verifier
{
public:
    explicit Verifier(const QString &path) : m_path {QDir {path}.absolutePath()} { }
    Verification run();

private:
    std::optional<Manifest> readManifest(const QString &name);
    void check(const Manifest &manifest);
    void checkFile(const QByteArray &inside, const QByteArray &hash);
    void findExtra();
    void add(FaultKind kind, const QString &inside) { m_result.faults << BagFault {kind, inside}; }

    QString m_path;
    std::set<QString> m_listed {QStringLiteral("tagmanifest-sha256.txt")};
    Verification m_result;
};

Verification Verifier::run()
{
    if (disk::readFile(m_path + QStringLiteral("/bagit.txt")) != bagDeclaration()) {
        add(FaultKind::NotABag, QStringLiteral("bagit.txt"));
        return m_result;
    }
    for (const char *name : {"manifest-sha256.txt", "tagmanifest-sha256.txt"}) {
        if (const auto manifest = readManifest(QLatin1String(name)))
            check(*manifest);
    }
    findExtra();
    return m_result;
}

std::optional<Manifest> Verifier::readManifest(const QString &name)
{
    const auto text = disk::readFile(m_path + u'/' + name);
    auto manifest = text ? manifestFrom(*text) : std::nullopt;
    if (!manifest)
        add(text ? FaultKind::Malformed : FaultKind::NotABag, name);
    return manifest;
}

void Verifier::check(const Manifest &manifest)
{
    for (const auto &[inside, hash] : manifest)
        checkFile(inside, hash);
}

void Verifier::checkFile(const QByteArray &inside, const QByteArray &hash)
{
    const QString name = QString::fromUtf8(inside);
    m_listed.insert(name);
    const QFileInfo file {m_path + u'/' + name};
    if (file.isSymLink())
        return add(FaultKind::Extra, name);
    const auto content = disk::readFile(file.filePath());
    if (!content)
        return add(FaultKind::Missing, name);
    if (sha256(*content) != hash)
        add(FaultKind::Changed, name);
    if (inside.startsWith("data/")) {
        ++m_result.files;
        m_result.bytes += content->size();
    }
}

void Verifier::findExtra()
{
    const QDir bag {m_path};
    QDirIterator files {m_path, QDir::Files | QDir::System | QDir::Hidden, QDirIterator::Subdirectories};
    while (files.hasNext()) {
        const QString inside = bag.relativeFilePath(files.next());
        if (!m_listed.contains(inside))
            add(FaultKind::Extra, inside);
    }
}

} // namespace

Verification verify(const QString &path) { return Verifier {path}.run(); }

QString explain(const BagFault &fault)
{
    switch (fault.kind) {
    case FaultKind::NotABag:
        return VerifyTexts::tr("This is no backup: %1 is missing or of another kind.").arg(fault.path);
    case FaultKind::Malformed: return VerifyTexts::tr("%1 is not as it was written.").arg(fault.path);
    case FaultKind::Changed: return VerifyTexts::tr("%1 was changed.").arg(fault.path);
    case FaultKind::Missing: return VerifyTexts::tr("%1 is missing.").arg(fault.path);
    case FaultKind::Extra: return VerifyTexts::tr("%1 does not belong to the backup.").arg(fault.path);
    }
    return {};
}

} // namespace files
