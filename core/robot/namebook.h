// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "cellfiles/outline.h"
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
        cellfiles::Warnings warnings; ///< Lines that could not be read.
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
    /// Reads IONAME.DAT, EXIONAME.DAT, IOMNAME.DAT and VARNAME.DAT, which a controller need not have. Nothing that was
    /// read before is lost by it.
    void fetch(session::FileSession &files);
    /// How IONAME.DAT and VARNAME.DAT fared.
    [[nodiscard]] const Fetch &signalFetch() const { return m_sources[0].fetch; }
    [[nodiscard]] const Fetch &variableFetch() const { return m_sources[1].fetch; }

Q_SIGNALS:
    /// Names or remarks are others than before.
    void changed();
    void fetchChanged();

private:
    /// What one file of the controller says.
    struct OwnNames {
        QHash<names::Signal, QString> signalNames;
        QHash<variables::Reference, QString> variableNames;
        cellfiles::Warnings warnings;
    };
    struct Source {
        const char *file;
        OwnNames (*read)(const QByteArray &, const protocol::TextCodec &);
        Fetch fetch {};
        OwnNames names {};
    };

    static OwnNames readSignals(const QByteArray &file, const protocol::TextCodec &codec);
    static OwnNames readVariables(const QByteArray &file, const protocol::TextCodec &codec);
    static OwnNames readRegisters(const QByteArray &file, const protocol::TextCodec &codec);
    void fetch(session::FileSession &files, Source &source);
    void onFetched(const values::Result<QByteArray> &file, Source &source);
    void takeOwnNames();
    void keepNames();

    protocol::TextCodec m_codec;
    protocol::Dialect m_dialect;
    settings::Notes m_notes;
    names::Names m_names;
    QHash<variables::Reference, QString> m_remarks;
    std::array<Source, 4> m_sources {Source {"IONAME.DAT", readSignals}, Source {"VARNAME.DAT", readVariables},
        Source {"EXIONAME.DAT", readSignals}, Source {"IOMNAME.DAT", readRegisters}};
};

} // namespace robot
