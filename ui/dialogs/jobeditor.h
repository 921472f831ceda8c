// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "protocol/text.h"
#include "ui/widgets/dialogsheet.h"
#include "values/filename.h"

class QLabel;
class QPlainTextEdit;
class QPushButton;

namespace dialogs {

/// The text of a file, to be changed and sent. What the look before an upload finds is said while typing.
class JobEditor : public widgets::DialogSheet
{
    Q_OBJECT

public:
    JobEditor(const values::FileName &name, const QByteArray &content, const protocol::TextCodec &codec,
        QWidget *parent = nullptr);

    /// As it would be sent: every line ends in CR LF. BadInput if the controller's encoding lacks a character.
    [[nodiscard]] values::Result<QByteArray> content() const;

Q_SIGNALS:
    /// The person wants to see what has changed, and send it then.
    void sendRequested(const QByteArray &content);

private:
    void check();

    values::FileName m_name;
    protocol::TextCodec m_codec;
    QPlainTextEdit *m_text;
    QLabel *m_findings;
    QPushButton *m_send;
};

} // namespace dialogs
