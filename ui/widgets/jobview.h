// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "inform/token.h"
#include <QPlainTextEdit>
#include <optional>

namespace widgets {

class InformHighlighter;

/// The instructions of a job with their line numbers. The line being executed stands on the accent ground with an
/// arrow before it.
class JobView : public QPlainTextEdit
{
    Q_OBJECT

public:
    explicit JobView(QWidget *parent = nullptr);

    /// `aliases` are the job's. Showing the same again costs nothing and keeps the scroll.
    void showLines(const QStringList &lines, const inform::Aliases &aliases = {});
    /// nullopt while nothing of this job is executed; a line beyond the text marks nothing.
    void setExecutingLine(std::optional<int> line);
    [[nodiscard]] std::optional<int> executingLine() const { return m_executing; }
    /// Keeps the executing line in view.
    void setFollowing(bool isFollowing);
    void goTo(int line);

protected:
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    class Gutter;

    [[nodiscard]] int gutterWidth() const;
    void paintGutter(QWidget *gutter, const QRect &area) const;
    void markExecuting();

    InformHighlighter *m_highlighter;
    QWidget *m_gutter;
    QStringList m_lines;
    std::optional<int> m_executing;
    bool m_isFollowing = true;
};

} // namespace widgets
