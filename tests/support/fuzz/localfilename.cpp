// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "support/fuzz/target.h"

#include "files/localname.h"

namespace fuzz {

namespace {

/// A name in a folder of this computer, as a file of a controller or as a controller's folder.
void isPlain(const QString &local)
{
    require(!local.isEmpty() && !local.startsWith(u'.') && !local.contains(u'/') && !local.contains(u'\\')
            && !local.contains(QChar::Null),
        "a local name leads elsewhere");
}

/// Any bytes are a local name that leads nowhere; those that a controller may send come back.
void take(QByteArrayView data)
{
    if (const auto name = values::FileName::create(data)) {
        const QString local = files::toLocalName(name->bytes());
        isPlain(local);
        require(files::fromLocalName(local) == *name, "a name changed on the way");
        files::LocalNames names;
        const auto other = values::FileName::create(name->bytes().toLower());
        require(!other || *other == *name || names.take(*name).toUpper() != names.take(*other).toUpper(),
            "two files of one name");
    }
    const QString typed = QString::fromUtf8(data);
    (void)files::fromLocalName(typed);
    isPlain(files::toFolderName(typed));
}

Seeds seeds()
{
    return {"HOME.JBI", "CON", "lpt1.JBI", "%8A.JBI", "../x", "\x8A\x5C.JBI", "a b", "CELL 4 / \xE2\x80\xAE", "."};
}

} // namespace

extern const Target localFileName;
const Target localFileName {"localFileName", take, seeds, 60};

} // namespace fuzz
