// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "inform/job.h"
#include "robot/joblibrary.h"
#include "ui/pages/page.h"
#include "ui/widgets/card.h"

class QCheckBox;
class QListWidget;
class QPushButton;

namespace widgets {
class JobView;
} // namespace widgets

namespace pages {

/// The text of one job, followed live while it is executed, with its labels and calls beside it.
class JobTextCard : public widgets::Card
{
    Q_OBJECT

public:
    /// `library` must outlive the card.
    JobTextCard(const Context &context, robot::JobLibrary &library, QWidget *parent = nullptr);

    /// Shows this job, and reads it if that was not done yet.
    void showJob(const values::FileName &job);
    [[nodiscard]] const std::optional<values::FileName> &job() const { return m_job; }

Q_SIGNALS:
    /// Another job is executed now and the person wants to follow.
    void followed(const values::FileName &job);

private:
    [[nodiscard]] QWidget *outline();
    void showCopy();
    [[nodiscard]] static QList<inform::Mark> marksOf(const inform::Job &parsed);
    void showOutline(const inform::Job &text);
    void showNotes(const robot::JobLibrary::Copy &copy, const inform::Job &text);
    void onStateChanged(const robot::TopicRange &range);
    void showExecutingLine();
    [[nodiscard]] QString text(QByteArrayView bytes) const;

    const robot::RobotState &m_state;
    robot::JobLibrary &m_library;
    protocol::Encoding m_encoding;
    std::optional<values::FileName> m_job;
    QByteArray m_executing; ///< Name of the job that was executed last.
    widgets::JobView *m_view;
    QLabel *m_empty;
    QListWidget *m_outline;
    QList<inform::Mark> m_marks;
    QCheckBox *m_follow;
    QPushButton *m_read;
};

} // namespace pages
