// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "motion/limits.h"
#include <QWidget>

class QCheckBox;
class QDoubleSpinBox;
class QFormLayout;

namespace dialogs {

/// How far a controller's profile lowers the limits of jogging and moving, and the box that its tool point must stay
/// in.
class MotionForm : public QWidget
{
    Q_OBJECT

public:
    explicit MotionForm(QWidget *parent = nullptr);

    void setWishes(const motion::Wishes &wishes);
    /// What was set, untouched, until the person changes a field: a limit that cannot be understood is not lost by
    /// looking at it.
    [[nodiscard]] motion::Wishes wishes() const;

Q_SIGNALS:
    /// The person changed a field.
    void edited();

private:
    struct Field {
        QDoubleSpinBox *box;
        std::optional<double> motion::Wishes::*wish;
    };

    void addLimit(QFormLayout *form, const char *name, const QString &label, double most,
        std::optional<double> motion::Wishes::*wish);
    void addBox(QFormLayout *form);
    [[nodiscard]] QDoubleSpinBox *corner(const QString &name, const QString &title);
    void onEdited();

    QList<Field> m_limits;
    QCheckBox *m_hasBox;
    QList<QDoubleSpinBox *> m_least; ///< X Y Z
    QList<QDoubleSpinBox *> m_most;
    QCheckBox *m_framesChecked;
    motion::Wishes m_original;
    bool m_isEdited = false;
    bool m_isFilling = false;
};

} // namespace dialogs
