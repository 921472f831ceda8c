// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "protocol/text.h"
#include "ui/widgets/dialogsheet.h"

namespace dialogs {

/// Two versions of a file, and whether to go on with the newer one.
class CompareDialog : public widgets::DialogSheet
{
    Q_OBJECT

public:
    /// `goOn` is the button that accepts; without one the dialog can only be closed.
    CompareDialog(const QString &title, const QByteArray &older, const QByteArray &newer,
        const protocol::TextCodec &codec, const QString &goOn = {}, QWidget *parent = nullptr);
};

} // namespace dialogs
