// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QImage>

namespace pendesk {

/// Small pictures in rows and columns with a heading over each column, to see whether they are sisters.
class ContactSheet
{
public:
    ContactSheet(int rows, const QStringList &headings);

    void add(int row, int column, const QImage &picture);
    /// False if the file cannot be written.
    [[nodiscard]] bool save(const QString &path) const { return m_image.save(path); }

private:
    QImage m_image;
};

} // namespace pendesk
