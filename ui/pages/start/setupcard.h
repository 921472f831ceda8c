// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "protocol/dialect.h"
#include "ui/widgets/card.h"

namespace pages::start {

/// What must be set at the controller before it answers, and before it takes orders (reference §10.1): a list to go
/// through at the pendant.
class SetupCard : public widgets::Card
{
    Q_OBJECT

public:
    /// The names of menus follow the model.
    explicit SetupCard(protocol::Model model, QWidget *parent = nullptr);

private:
    void addStep(const QString &title, const QString &sentence);

    int m_steps = 0;
};

} // namespace pages::start
