// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "files/compare.h"
#include "protocol/text.h"
#include "ui/widgets/card.h"

class QCheckBox;
class QTreeWidget;

namespace widgets {
class DiffView;
class Flow;
} // namespace widgets

namespace pages {

/// What differs between two sets of files: which files, and what in the chosen one. What is noise can be chosen.
class ComparisonCard : public widgets::Card
{
    Q_OBJECT

public:
    explicit ComparisonCard(const protocol::TextCodec &codec, QWidget *parent = nullptr);

    /// A place for what belongs above the comparison.
    [[nodiscard]] widgets::Flow *tools() const { return m_tools; }
    void showSets(const files::FileSet &older, const files::FileSet &newer);
    /// A sentence instead of a comparison.
    void showSentence(const QString &sentence);

private:
    [[nodiscard]] QLayout *noiseRules();
    [[nodiscard]] files::NoiseFilter noise() const;
    void showFile();

    protocol::TextCodec m_codec;
    files::FileSet m_older;
    files::FileSet m_newer;
    widgets::Flow *m_tools;
    QList<QCheckBox *> m_noise;
    QTreeWidget *m_files;
    widgets::DiffView *m_diff;
};

} // namespace pages
