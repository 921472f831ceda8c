// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "files/noise.h"
#include "protocol/text.h"
#include <QWidget>

class QLabel;
class QTreeWidget;

namespace widgets {

/// Two versions of a file beside each other: what was done to a job in words, and all lines with their differences.
class DiffView : public QWidget
{
    Q_OBJECT

public:
    explicit DiffView(const protocol::TextCodec &codec, QWidget *parent = nullptr);

    void showFiles(const QByteArray &older, const QByteArray &newer, const files::NoiseFilter &noise);
    /// A sentence instead of a comparison.
    void showSentence(const QString &sentence);

private:
    void addLine(int oldLine, int newLine, const QByteArray &older, const QByteArray &newer, bool isSame);

    protocol::TextCodec m_codec;
    QLabel *m_summary;
    QTreeWidget *m_lines;
};

} // namespace widgets
