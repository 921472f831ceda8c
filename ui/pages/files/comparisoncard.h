// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "station/differences.h"
#include "ui/widgets/card.h"
#include <QFutureWatcher>

class QCheckBox;
class QTreeWidget;
class QTreeWidgetItem;

namespace widgets {
class DiffView;
class Flow;
} // namespace widgets

namespace pages {

/// What differs between two sets of files: which files, in words below each, and line by line in the chosen one. What
/// may move the robot elsewhere comes first; counters, logs and the like are folded. What is noise can be chosen.
class ComparisonCard : public widgets::Card
{
    Q_OBJECT

public:
    explicit ComparisonCard(const protocol::TextCodec &codec, QWidget *parent = nullptr);

    /// A place for what belongs above the comparison.
    [[nodiscard]] widgets::Flow *tools() const { return m_tools; }
    /// `older` and `newer` in words: "12.03.26 08:30", "the controller now".
    void showSets(
        const files::FileSet &older, const files::FileSet &newer, const QString &olderName, const QString &newerName);
    /// Nothing is compared any more: another backup was chosen.
    void forget();
    /// A sentence instead of a comparison.
    void showSentence(const QString &sentence);

private:
    [[nodiscard]] QLayout *noiseRules();
    [[nodiscard]] files::NoiseFilter noise() const;
    void compareSets();
    void showDifferences(const QList<station::FileDifference> &differences);
    [[nodiscard]] QTreeWidgetItem *rowOf(const station::FileDifference &difference) const;
    void showFile();

    protocol::TextCodec m_codec;
    files::FileSet m_older;
    files::FileSet m_newer;
    QFutureWatcher<QList<station::FileDifference>> m_comparing;
    widgets::Flow *m_tools;
    QList<QCheckBox *> m_noise;
    QTreeWidget *m_files;
    widgets::DiffView *m_diff;
};

} // namespace pages
