// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "files/bagtext.h"
#include "files/fileset.h"
#include "files/operation.h"

namespace files {

/// Lists the files of a controller type by type and reads them one by one. What cannot be listed or read is noted, and
/// the rest goes on; what was not answered is asked for again. Only a controller that stays silent, a full disk or a
/// person ends it early.
class Collection : public Operation
{
    Q_OBJECT

public:
    /// Takes a file when it has come. An error ends the collection.
    using Sink = std::function<values::Result<void>(const values::FileName &name, const QByteArray &content)>;
    /// Whether a listed file is wanted.
    using Filter = std::function<bool(const values::FileName &name)>;

    /// "*.JBI", "*.DAT" and so on: all types that a list can be had of (reference §7.4).
    [[nodiscard]] static QByteArrayList allPatterns();

    Collection(session::FileSession &session, Sink sink, QObject *parent = nullptr);

    void setPatterns(const QByteArrayList &patterns) { m_patterns = patterns; }
    void setFilter(Filter filter) { m_filter = std::move(filter); }
    /// Also asks for PANELBOX.LOG, which no list holds; refused, it is not offered, which is no failure. Leaves ALL.PRM
    /// out where the single files that it repeats are listed too, unless it is wanted: it takes a real controller 45 s.
    void readWhatBackupsHold(bool withAllParameters = false);
    /// Only lists: the names are in results(), and nothing goes to the sink.
    void setListingOnly(bool isListingOnly) { m_isListingOnly = isListingOnly; }

    /// So far: one a file that was listed and tried, and one a list that failed, named by its pattern.
    [[nodiscard]] const QList<FileResult> &results() const { return m_results; }
    [[nodiscard]] int filesDone() const { return int(m_results.size()); }
    /// 0 until all lists are there.
    [[nodiscard]] int filesTotal() const { return m_total; }
    /// The file that is being read; empty while listing.
    [[nodiscard]] QByteArray current() const { return m_current; }
    /// Of the files that came.
    [[nodiscard]] qint64 bytesDone() const { return m_bytes; }

protected:
    void run() override;
    void interrupt() override;

private:
    void listNext();
    void list(const QByteArray &pattern);
    void takeList(const QByteArray &pattern, const values::Result<protocol::FileList> &list);
    void beginReading();
    void readNext();
    void read(const values::FileName &name);
    void takeFile(const values::FileName &name, const values::Result<QByteArray> &content);
    [[nodiscard]] bool isHopeless(const std::optional<values::Error> &error);
    [[nodiscard]] bool isSilence() const { return m_silences > 0; }
    void note(const QByteArray &name, const std::optional<values::Error> &error);

    Sink m_sink;
    Filter m_filter;
    QByteArrayList m_patterns = allPatterns();
    bool m_isListingOnly = false;
    session::FileSession::TransferId m_transfer = 0;
    QByteArrayList m_toList;
    std::set<values::FileName> m_listed;
    QList<values::FileName> m_toRead; ///< In the order that keeps them true to each other.
    QByteArrayList m_unlisted;
    bool m_skipsRepeated = false;
    qint64 m_bytes = 0;
    QList<FileResult> m_results;
    QByteArray m_current;
    int m_total = 0;
    int m_silences = 0; ///< In a row.
};

/// Reads into memory: the files of a controller as they are now.
class Snapshot : public Collection
{
    Q_OBJECT

public:
    explicit Snapshot(session::FileSession &session, QObject *parent = nullptr);
    /// Complete when it is Done. What could not be read is in it as unread.
    [[nodiscard]] FileSet files() const;

private:
    std::map<values::FileName, QByteArray> m_contents;
};

} // namespace files
