// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/dialogs/diagnosisdialog.h"

#include "ui/dialogs/ladderview.h"
#include "ui/linkview.h"
#include "ui/widgets/text.h"
#include <QClipboard>
#include <QDialogButtonBox>
#include <QGuiApplication>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

namespace dialogs {

DiagnosisDialog::DiagnosisDialog(const settings::Profile &profile, QWidget *parent)
    : DialogSheet(parent), m_ladder {new LadderView}
{
    setObjectName(QStringLiteral("diagnosisDialog"));
    setWindowTitle(tr("Diagnosis — %1").arg(profile.name));
    resize(620, 560);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    buttons->button(QDialogButtonBox::Close)->setObjectName(QStringLiteral("closeButton"));
    m_copy = buttons->addButton(tr("Copy diagnosis"), QDialogButtonBox::ActionRole);
    m_copy->setObjectName(QStringLiteral("copyDiagnosis"));
    m_copy->setEnabled(false);
    m_copy->setToolTip(tr("The diagnosis is not finished yet."));
    auto *scroll = new QScrollArea;
    scroll->setWidget(m_ladder);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(ui::space::page, ui::space::page, ui::space::page, ui::space::page);
    column->addWidget(
        widgets::text(tr("%1 · %2").arg(profile.name, ui::addressText(profile)), ui::Type::State, ui::Role::Text1));
    column->addWidget(widgets::sentence(tr("It only reads. HOLD works meanwhile: Pause key."), ui::Role::Text2));
    column->addWidget(scroll, 1);
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    connect(m_copy, &QPushButton::clicked, this, &DiagnosisDialog::copy);
    connect(m_ladder, &LadderView::finished, this, [this] {
        m_copy->setEnabled(true);
        m_copy->setToolTip({});
    });
    m_ladder->diagnose(profile);
}

void DiagnosisDialog::copyWhenFinished() { connect(m_ladder, &LadderView::finished, this, &DiagnosisDialog::copy); }

void DiagnosisDialog::copy()
{
    QGuiApplication::clipboard()->setText(m_ladder->toText());
    m_copy->setText(tr("Copied"));
}

} // namespace dialogs
