// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/pages/variablesheet.h"

namespace pages {

/// M000 to M999 in four ways of writing them. The first 560 can be written (reference §4.2).
class RegistersPage : public Page
{
    Q_OBJECT

public:
    explicit RegistersPage(const Context &context, QWidget *parent = nullptr);

    [[nodiscard]] QList<robot::TopicRange> topics() const override;

private:
    void choose(variables::Base base);

    variables::Format m_format;
    models::VariableDesk m_desk;
    models::VariableModel *m_model;
    VariableSheet *m_sheet;
};

/// All variables of a kind.
[[nodiscard]] QList<variables::Reference> allOf(variables::Kind kind, const protocol::Dialect &dialect);
/// A flat sheet around a page's content.
[[nodiscard]] QWidget *sheetCard(QWidget *content);

} // namespace pages
