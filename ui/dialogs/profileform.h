// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "settings/profile.h"
#include <QWidget>

class QComboBox;
class QFormLayout;
class QLineEdit;
class QSpinBox;

namespace dialogs {

class MotionForm;

/// The fields of one profile, with their ranges.
class ProfileForm : public QWidget
{
    Q_OBJECT

public:
    explicit ProfileForm(QWidget *parent = nullptr);

    void setProfile(const settings::Profile &profile);
    [[nodiscard]] settings::Profile profile() const;

Q_SIGNALS:
    /// The person changed a field.
    void edited();

private:
    [[nodiscard]] QComboBox *addChoice(QFormLayout *form, const char *name, const QString &label);
    [[nodiscard]] QSpinBox *addNumber(
        QFormLayout *form, const char *name, const QString &label, int least, int most, const QString &suffix = {});

    QLineEdit *m_name;
    QLineEdit *m_host;
    QComboBox *m_model;
    QComboBox *m_encoding;
    QComboBox *m_numbering;
    QSpinBox *m_port;
    QSpinBox *m_filePort;
    QSpinBox *m_readTimeout;
    QSpinBox *m_fileTimeout;
    QSpinBox *m_servoTimeout;
    QSpinBox *m_repeats;
    QSpinBox *m_window;
    QSpinBox *m_ceiling;
    MotionForm *m_motion;
    settings::Profile m_original; ///< For what the form does not show.
    bool m_isFilling = false;
};

} // namespace dialogs
