// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "names/names.h"
#include "settings/notes.h"
#include "settings/profile.h"
#include "values/error.h"
#include <QObject>

namespace session {
class FileSession;
}

namespace robot {

class Controller;

/// The names of a controller's signals and variables, and the remarks that people keep about variables. The
/// controller's own come from its files, the local ones from the settings, where every change goes at once.
class NameBook : public QObject
{
    Q_OBJECT

public:
    /// How reading one of the files went.
    struct Fetch {
        bool isUnderWay = false;
        std::optional<values::Error> error; ///< Why the names are not known.
        int remarks = 0; ///< Lines that could not be read; see remarkList.
        QList<names::Remark> remarkList;
    };

    NameBook(const settings::Profile &profile, settings::Notes notes, QObject *parent = nullptr);

    [[nodiscard]] const names::Names &names() const { return m_names; }
    [[nodiscard]] QString remark(const variables::Reference &variable) const { return m_remarks.value(variable); }

    void setLocalName(const names::Signal &signal, const QString &text);
    void setLocalName(const variables::Reference &variable, const QString &text);
    /// An empty text takes the remark away.
    void setRemark(const variables::Reference &variable, const QString &text);

    /// Reads the names once for each link of `controller`, as soon as it stands; `controller` must outlive the book.
    void follow(Controller &controller);
    /// Reads IONAME.DAT and VARNAME.DAT, which a controller need not have. Nothing that was read before is lost by it.
    void fetch(session::FileSession &files);
    [[nodiscard]] const Fetch &signalFetch() const { return m_signalFetch; }
    [[nodiscard]] const Fetch &variableFetch() const { return m_variableFetch; }

Q_SIGNALS:
    /// Names or remarks are others than before.
    void changed();
    void fetchChanged();

private:
    using Take = void (names::Names::*)(const names::NameFile &);

    void fetch(session::FileSession &files, QByteArrayView name, Fetch &fetch, Take take);
    void onFetched(const values::Result<QByteArray> &file, Fetch &fetch, Take take);
    void keepNames();

    protocol::TextCodec m_codec;
    protocol::Dialect m_dialect;
    settings::Notes m_notes;
    names::Names m_names;
    QHash<variables::Reference, QString> m_remarks;
    Fetch m_signalFetch;
    Fetch m_variableFetch;
};

} // namespace robot
