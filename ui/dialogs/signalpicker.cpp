// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/dialogs/signalpicker.h"

#include "trend/catalogue.h"
#include "ui/models/signallistmodel.h"
#include "ui/widgets/text.h"
#include <QCoreApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListView>
#include <QPushButton>
#include <QVBoxLayout>

namespace dialogs {

namespace {

models::SignalListModel *makeModel(const trend::Recorder &recorder, const protocol::Dialect &dialect, QObject *parent)
{
    const auto list = trend::allSignals(dialect, recorder.state());
    QStringList labels;
    for (const trend::Signal &signal : list)
        labels << trend::label(recorder.state(), signal);
    return new models::SignalListModel(list, labels, parent);
}

} // namespace

SignalPicker::SignalPicker(trend::Recorder &recorder, const protocol::Dialect &dialect, QWidget *parent)
    : DialogSheet(parent),
      m_recorder {recorder},
      m_model {makeModel(recorder, dialect, this)},
      m_filter {new models::SignalFilter(*m_model, this)},
      m_search {new QLineEdit},
      m_list {new QListView}
{
    setObjectName(QStringLiteral("signalPicker"));
    setWindowTitle(tr("Add a signal"));
    resize(420, 480);
    m_search->setObjectName(QStringLiteral("signalSearch"));
    m_search->setPlaceholderText(tr("For example: R1 torque, B005, #00010, M012"));
    m_search->setAccessibleName(tr("Search"));
    m_search->setClearButtonEnabled(true);
    m_search->installEventFilter(this);
    m_list->setObjectName(QStringLiteral("signalList"));
    m_list->setAccessibleName(tr("Signals"));
    m_list->setUniformItemSizes(true);
    m_list->setModel(m_filter);
    auto *addButton = new QPushButton(tr("Add"));
    addButton->setObjectName(QStringLiteral("addSignalNow"));
    addButton->setProperty("primary", true);
    addButton->setDefault(true);
    auto *closeButton = new QPushButton(tr("Close"));
    closeButton->setObjectName(QStringLiteral("closePicker"));
    auto *row = new QHBoxLayout;
    row->addStretch();
    row->addWidget(closeButton);
    row->addWidget(addButton);
    auto *column = new QVBoxLayout(this);
    column->addWidget(m_search);
    column->addWidget(m_list, 1);
    column->addLayout(row);
    connect(m_search, &QLineEdit::textChanged, this, &SignalPicker::search);
    connect(m_list, &QListView::activated, this, &SignalPicker::addCurrent);
    connect(addButton, &QPushButton::clicked, this, &SignalPicker::addCurrent);
    connect(closeButton, &QPushButton::clicked, this, &QDialog::close);
    search({});
}

void SignalPicker::search(const QString &text)
{
    m_filter->search(text);
    m_list->setCurrentIndex(m_filter->index(0, 0));
}

void SignalPicker::addCurrent()
{
    const QModelIndex index = m_filter->mapToSource(m_list->currentIndex());
    if (index.isValid())
        m_recorder.add(m_model->signalOf(index.row()));
}

/// Up and down in the search move through the list.
bool SignalPicker::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent *>(event)->key();
        if (key == Qt::Key_Up || key == Qt::Key_Down) {
            QCoreApplication::sendEvent(m_list, event);
            return true;
        }
    }
    return QDialog::eventFilter(watched, event);
}

} // namespace dialogs
