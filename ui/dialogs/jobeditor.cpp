// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/dialogs/jobeditor.h"

#include "files/preflight.h"
#include "ui/widgets/informhighlighter.h"
#include "ui/widgets/text.h"
#include <QDialogButtonBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace dialogs {

JobEditor::JobEditor(
    const values::FileName &name, const QByteArray &content, const protocol::TextCodec &codec, QWidget *parent)
    : DialogSheet(parent),
      m_name {name},
      m_codec {codec},
      m_text {new QPlainTextEdit(codec.decode(content))},
      m_findings {widgets::sentence({}, ui::Role::Amber)}
{
    setObjectName(QStringLiteral("jobEditor"));
    setWindowTitle(tr("Edit “%1”").arg(codec.decode(name.bytes())));
    resize(720, 640);
    m_text->setObjectName(QStringLiteral("jobText"));
    m_text->setAccessibleName(tr("Text of the file"));
    m_text->setTabChangesFocus(true);
    m_text->setFont(ui::font(ui::Type::Mono));
    new widgets::InformHighlighter(m_text->document(), m_text);
    m_text->setLineWrapMode(QPlainTextEdit::NoWrap);
    m_findings->setObjectName(QStringLiteral("findings"));
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    buttons->button(QDialogButtonBox::Close)->setObjectName(QStringLiteral("closeEditor"));
    m_send = buttons->addButton(tr("Compare and send…"), QDialogButtonBox::ActionRole);
    m_send->setObjectName(QStringLiteral("compareAndSend"));
    m_send->setAutoDefault(false);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(ui::space::page, ui::space::page, ui::space::page, ui::space::page);
    column->setSpacing(ui::space::gap);
    column->addWidget(m_text, 1);
    column->addWidget(m_findings);
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(
        m_send, &QPushButton::clicked, this, [this] { Q_EMIT sendRequested(this->content().value_or(QByteArray())); });
    connect(m_text, &QPlainTextEdit::textChanged, this, &JobEditor::check);
    check();
}

values::Result<QByteArray> JobEditor::content() const
{
    QString text = m_text->toPlainText();
    if (!text.isEmpty() && !text.endsWith(u'\n'))
        text += u'\n';
    return m_codec.encode(text.replace(u'\n', QStringLiteral("\r\n")));
}

void JobEditor::check()
{
    const auto bytes = content();
    QStringList sentences;
    if (!bytes)
        sentences << tr("The controller's encoding lacks a character of this text.");
    const auto findings = bytes ? files::preflight(m_name, *bytes) : QList<inform::Finding>();
    for (const inform::Finding &finding : findings)
        sentences << (finding.isError() ? QStringLiteral("▲ ") : QStringLiteral("· "))
                + files::explain(finding, m_codec);
    m_findings->setText(sentences.join(u'\n'));
    m_findings->setVisible(!sentences.isEmpty());
    m_send->setEnabled(bytes && files::mayBeSent(findings));
}

} // namespace dialogs
