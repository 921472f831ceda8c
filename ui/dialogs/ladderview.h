// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/diagnosis.h"
#include <QWidget>

class QVBoxLayout;

namespace dialogs {

/// The diagnosis, one rung under the other: ✓ passed, ✗ failed, – not reached.
class LadderView : public QWidget
{
    Q_OBJECT

public:
    using QWidget::QWidget;

    /// Starts over with this profile.
    void diagnose(const settings::Profile &profile);
    [[nodiscard]] bool isFinished() const { return m_isFinished; }
    /// For support: a line a rung, with the profile's name and address.
    [[nodiscard]] QString toText() const;

Q_SIGNALS:
    void finished();

private:
    void add(const robot::Rung &rung);

    settings::Profile m_profile;
    std::unique_ptr<robot::Diagnosis> m_diagnosis;
    std::unique_ptr<QWidget> m_rungs;
    bool m_isFinished = false;
};

} // namespace dialogs
