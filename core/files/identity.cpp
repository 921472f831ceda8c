// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "files/identity.h"

#include "cellfiles/signalnames.h"
#include "cellfiles/systemfile.h"
#include "cellfiles/variablefile.h"
#include <QCoreApplication>

using values::FileName;

namespace files {

namespace {

struct IdentityTexts {
    Q_DECLARE_TR_FUNCTIONS(files::Identity)
};

QByteArray contentOf(const FileSet &files, QByteArrayView bytes)
{
    const auto name = FileName::create(bytes);
    return name && files.hashes.contains(*name) ? files.content(*name).value_or(QByteArray {}) : QByteArray {};
}

QString mechanismText(const cellfiles::System &system)
{
    QStringList texts;
    for (const cellfiles::Mechanism &mechanism : system.mechanisms)
        texts << mechanism.group + u' ' + mechanism.model + u' '
                + QString::number(mechanism.axes, 2).rightJustified(8, u'0');
    return texts.join(QStringLiteral(", "));
}

QString countText(const QByteArray &file)
{
    const auto shares = cellfiles::variablesFrom(file).value.shares;
    QStringList texts;
    for (const variables::Kind kind : cellfiles::sharedKinds) {
        if (shares.contains(kind))
            texts << letters(kind) + u' ' + QString::number(shares[kind]);
    }
    return texts.join(QStringLiteral(", "));
}

} // namespace

Identity identityOf(const BagInfo &info, const FileSet &files)
{
    Identity identity {info.controller, info.host, info.model, info.software, {}, {}};
    const auto system = cellfiles::systemFrom(contentOf(files, "SYSTEM.SYS"), protocol::TextCodec {}).value;
    identity.mechanisms = mechanismText(system);
    if (identity.software.isEmpty())
        identity.software = system.version;
    identity.counts = countText(contentOf(files, "VAR.DAT"));
    return identity;
}

QList<IdentityRow> compareIdentities(const Identity &backup, const Identity &controller)
{
    QList<IdentityRow> rows;
    const auto add = [&](const QString &title, const QString &older, const QString &newer, bool isDecisive) {
        rows << IdentityRow {
            title, older, newer, older.isEmpty() || newer.isEmpty() || older.trimmed() == newer.trimmed(), isDecisive};
    };
    add(IdentityTexts::tr("Name"), backup.name, controller.name, false);
    add(IdentityTexts::tr("Host"), backup.host, controller.host, false);
    add(IdentityTexts::tr("Model"), backup.model, controller.model, true);
    add(IdentityTexts::tr("Robots and axes"), backup.mechanisms, controller.mechanisms, true);
    add(IdentityTexts::tr("Software"), backup.software, controller.software, false);
    add(IdentityTexts::tr("Number of variables"), backup.counts, controller.counts, false);
    return rows;
}

bool isAnotherRobot(const QList<IdentityRow> &rows)
{
    return std::ranges::any_of(rows, [](const IdentityRow &row) { return row.isDecisive && !row.isSame; });
}

} // namespace files
