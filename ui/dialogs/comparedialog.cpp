// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/dialogs/comparedialog.h"

#include "ui/theme.h"
#include "ui/widgets/diffview.h"
#include <QDialogButtonBox>
#include <QPushButton>
#include <QVBoxLayout>

namespace dialogs {

CompareDialog::CompareDialog(const QString &title, const QByteArray &older, const QByteArray &newer,
    const protocol::TextCodec &codec, const QString &goOn, QWidget *parent)
    : DialogSheet(parent)
{
    setObjectName(QStringLiteral("compareDialog"));
    setWindowTitle(title);
    resize(860, 560);
    auto *view = new widgets::DiffView(codec);
    if (older == newer)
        view->showSentence(tr("Both are the same, byte for byte."));
    else
        view->showFiles(older, newer, files::NoiseFilter::none());
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    buttons->button(QDialogButtonBox::Close)->setObjectName(QStringLiteral("closeComparison"));
    buttons->button(QDialogButtonBox::Close)->setDefault(true);
    if (!goOn.isEmpty())
        widgets::writing(buttons->addButton(goOn, QDialogButtonBox::AcceptRole))->setObjectName(QStringLiteral("goOn"));
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(ui::space::page, ui::space::page, ui::space::page, ui::space::page);
    column->setSpacing(ui::space::gap);
    column->addWidget(view, 1);
    column->addWidget(buttons);
}

} // namespace dialogs
