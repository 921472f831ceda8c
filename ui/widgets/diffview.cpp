// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/widgets/diffview.h"

#include "files/compare.h"
#include "ui/widgets/text.h"
#include <QHeaderView>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace widgets {

namespace {

QString lineNumber(int line) { return line < 0 ? QString() : QString::number(line + 1); }

} // namespace

DiffView::DiffView(const protocol::TextCodec &codec, QWidget *parent)
    : QWidget(parent), m_codec {codec}, m_summary {sentence({}, ui::Role::Text1)}, m_lines {new QTreeWidget}
{
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_summary);
    column->addWidget(m_lines, 1);
    m_summary->setObjectName(QStringLiteral("edits"));
    m_summary->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_lines->setObjectName(QStringLiteral("comparedLines"));
    m_lines->setAccessibleName(tr("Lines of both versions"));
    m_lines->setHeaderLabels({tr("Line"), tr("Older"), tr("Line"), tr("Newer")});
    m_lines->setRootIsDecorated(false);
    m_lines->setUniformRowHeights(true);
    m_lines->setFrameShape(QFrame::NoFrame);
    m_lines->setFont(ui::font(ui::Type::Mono));
    m_lines->header()->setStretchLastSection(true);
    m_lines->header()->setFont(ui::font(ui::Type::Label));
    m_lines->setColumnWidth(0, 52);
    m_lines->setColumnWidth(1, 300);
    m_lines->setColumnWidth(2, 52);
}

void DiffView::showSentence(const QString &sentence)
{
    m_summary->setText(sentence);
    m_lines->clear();
    m_lines->hide();
}

void DiffView::showFiles(const QByteArray &older, const QByteArray &newer, const files::NoiseFilter &noise)
{
    constexpr int mostShown = 12;
    QStringList edits = files::jobEdits(older, newer, noise, m_codec);
    const int more = int(edits.size()) - mostShown;
    if (more > 0)
        edits = edits.first(mostShown) << tr("and %n more", nullptr, more);
    m_summary->setText(edits.join(u'\n'));
    m_summary->setVisible(!edits.isEmpty());
    m_lines->clear();
    m_lines->show();
    for (const files::ComparedLine &line : compareText(older, newer, noise))
        addLine(line.oldLine, line.newLine, line.older, line.newer, line.isSame);
}

void DiffView::addLine(int oldLine, int newLine, const QByteArray &older, const QByteArray &newer, bool isSame)
{
    const QString mark = isSame ? QString() : QStringLiteral("≠ ");
    auto *item = new QTreeWidgetItem({lineNumber(oldLine), oldLine < 0 ? QString() : mark + m_codec.decode(older),
        lineNumber(newLine), newLine < 0 ? QString() : mark + m_codec.decode(newer)});
    if (!isSame) {
        for (int column = 0; column < 4; ++column)
            item->setBackground(column, ui::color(ui::Role::AccentGround, this));
    }
    m_lines->addTopLevelItem(item);
    if (!isSame && !m_lines->currentItem())
        m_lines->setCurrentItem(item);
}

} // namespace widgets
