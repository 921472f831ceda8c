// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/orders.h"
#include "robot/reading.h"
#include "values/filename.h"
#include <map>

namespace robot {

/// The jobs on a controller: their list, and the text of those that were looked at. Everything is read when somebody
/// asks and kept until it is read again; HSES does not tell when a job was changed.
class JobLibrary : public QObject
{
    Q_OBJECT

public:
    /// A job as it was read.
    struct Copy {
        Reading<QByteArray> text; ///< The JBI file.
        std::optional<values::Error> trouble; ///< Why the last try to read it failed, if it did.
        bool isReading = false;
        bool mayBeOld = false; ///< Since it was read the controller was in TEACH or the link was lost.
    };

    /// `orders` must outlive the library.
    explicit JobLibrary(Orders &orders, QObject *parent = nullptr);

    /// In the order of their bytes.
    [[nodiscard]] const Reading<QList<values::FileName>> &list() const { return m_list; }
    [[nodiscard]] const std::optional<values::Error> &listTrouble() const { return m_listTrouble; }
    [[nodiscard]] bool isListing() const { return m_isListing; }
    /// The list was read on a link that was lost since.
    [[nodiscard]] bool isListOld() const { return m_isListOld; }
    /// Empty if it was never read.
    [[nodiscard]] const Copy &copy(const values::FileName &job) const;

    /// Reads the list, unless that is under way.
    void readList();
    /// Reads one job, unless that is under way.
    void readText(const values::FileName &job);

Q_SIGNALS:
    void listChanged();
    void copyChanged(const values::FileName &job);

private:
    void onList(const values::Result<QList<values::FileName>> &names);
    void onText(const values::FileName &job, const values::Result<QByteArray> &text);
    void onSituationChanged();
    void onLinkDropped();
    void markOld();

    Orders &m_orders;
    Reading<QList<values::FileName>> m_list;
    std::optional<values::Error> m_listTrouble;
    bool m_isListing = false;
    bool m_isListOld = false;
    std::map<values::FileName, Copy> m_copies;
};

} // namespace robot
