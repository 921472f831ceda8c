// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/dialogs/profileform.h"

#include "protocol/dialect.h"
#include "ui/dialogs/motionform.h"
#include "ui/widgets/text.h"
#include <QComboBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QScopedValueRollback>
#include <QSpinBox>

namespace dialogs {

namespace {

QLineEdit *lineEdit(const char *name, const QString &accessibleName)
{
    auto *edit = new QLineEdit;
    edit->setObjectName(QLatin1String(name));
    edit->setAccessibleName(accessibleName);
    edit->setMaxLength(253); // as long as a host name may be
    return edit;
}

} // namespace

ProfileForm::ProfileForm(QWidget *parent)
    : QWidget(parent),
      m_name {lineEdit("profileName", tr("Name"))},
      m_host {lineEdit("profileHost", tr("Host name or address"))}
{
    setFocusProxy(m_name);
    auto *form = new QFormLayout(this);
    form->setContentsMargins(0, 0, 0, 0);
    form->addRow(tr("Name"), m_name);
    form->addRow(tr("Host name or address"), m_host);
    m_model = addChoice(form, "profileModel", tr("Model"));
    for (const auto model : protocol::allModels)
        m_model->addItem(QLatin1String(protocol::dialect(model).name), int(model));
    m_encoding = addChoice(form, "profileEncoding", tr("Text encoding"));
    for (const auto &encoding : protocol::encodings())
        m_encoding->addItem(QLatin1String(encoding.key), int(encoding.encoding));
    m_numbering = addChoice(form, "profileNumbering", tr("Variable numbering"));
    m_numbering->addItem(tr("B000 is number 0 on the wire"), int(protocol::Numbering::FromZero));
    m_numbering->addItem(tr("B000 is number 1 on the wire"), int(protocol::Numbering::FromOne));
    m_port = addNumber(form, "profilePort", tr("Port"), 1, 65535);
    m_filePort = addNumber(form, "profileFilePort", tr("File port"), 1, 65535);
    m_readTimeout = addNumber(form, "profileReadTimeout", tr("Read time-out"), 20, 60000, tr(" ms"));
    m_fileTimeout = addNumber(form, "profileFileTimeout", tr("File time-out"), 100, 600000, tr(" ms"));
    m_servoTimeout = addNumber(form, "profileServoTimeout", tr("Servo time-out"), 100, 60000, tr(" ms"));
    m_repeats = addNumber(form, "profileRepeats", tr("Repeats of a read"), 0, 10);
    m_window = addNumber(form, "profileWindow", tr("Requests outstanding at once"), 1, 8);
    m_ceiling = addNumber(form, "profileCeiling", tr("Requests a second, at most"), 1, 10000);
    m_motion = new MotionForm;
    form->addRow(widgets::text(tr("Jog and move, at most"), ui::Type::Heading, ui::Role::Text2));
    form->addRow(m_motion);
    connect(m_motion, &MotionForm::edited, this, &ProfileForm::edited);
    const auto tell = [this] {
        if (!m_isFilling)
            Q_EMIT edited();
    };
    connect(m_name, &QLineEdit::textChanged, this, tell);
    connect(m_host, &QLineEdit::textChanged, this, tell);
    const auto choices = findChildren<QComboBox *>(Qt::FindDirectChildrenOnly);
    for (const QComboBox *choice : choices)
        connect(choice, &QComboBox::currentIndexChanged, this, tell);
    const auto numbers = findChildren<QSpinBox *>(Qt::FindDirectChildrenOnly);
    for (const QSpinBox *number : numbers)
        connect(number, &QSpinBox::valueChanged, this, tell);
}

QComboBox *ProfileForm::addChoice(QFormLayout *form, const char *name, const QString &label)
{
    auto *box = new QComboBox;
    box->setObjectName(QLatin1String(name));
    box->setAccessibleName(label);
    form->addRow(label, box);
    return box;
}

QSpinBox *ProfileForm::addNumber(
    QFormLayout *form, const char *name, const QString &label, int least, int most, const QString &suffix)
{
    auto *box = new QSpinBox;
    box->setObjectName(QLatin1String(name));
    box->setAccessibleName(label);
    box->setRange(least, most);
    box->setSuffix(suffix);
    box->setToolTip(tr("From %1 to %2").arg(locale().toString(least), locale().toString(most)));
    form->addRow(label, box);
    return box;
}

void ProfileForm::setProfile(const settings::Profile &profile)
{
    const QScopedValueRollback filling(m_isFilling, true);
    m_original = profile;
    m_name->setText(profile.name);
    m_host->setText(profile.host);
    m_model->setCurrentIndex(m_model->findData(int(profile.model)));
    m_encoding->setCurrentIndex(m_encoding->findData(int(profile.encoding)));
    m_numbering->setCurrentIndex(m_numbering->findData(int(profile.numbering)));
    m_port->setValue(profile.port);
    m_filePort->setValue(profile.filePort);
    m_readTimeout->setValue(int(profile.readTimeout.count()));
    m_fileTimeout->setValue(int(profile.fileTimeout.count()));
    m_servoTimeout->setValue(int(profile.servoTimeout.count()));
    m_repeats->setValue(profile.readRepeats);
    m_window->setValue(profile.window);
    m_ceiling->setValue(profile.requestsPerSecond);
    m_motion->setWishes(profile.motion);
}

settings::Profile ProfileForm::profile() const
{
    using std::chrono::milliseconds;
    settings::Profile profile = m_original;
    profile.name = m_name->text().trimmed();
    profile.host = m_host->text().trimmed();
    profile.model = protocol::Model(m_model->currentData().toInt());
    profile.encoding = protocol::Encoding(m_encoding->currentData().toInt());
    profile.numbering = protocol::Numbering(m_numbering->currentData().toInt());
    profile.port = quint16(m_port->value());
    profile.filePort = quint16(m_filePort->value());
    profile.readTimeout = milliseconds {m_readTimeout->value()};
    profile.fileTimeout = milliseconds {m_fileTimeout->value()};
    profile.servoTimeout = milliseconds {m_servoTimeout->value()};
    profile.readRepeats = m_repeats->value();
    profile.window = m_window->value();
    profile.requestsPerSecond = m_ceiling->value();
    profile.motion = m_motion->wishes();
    if (profile.numbering != m_original.numbering || profile.host != m_original.host)
        profile.numberingVerified = {}; // it was compared with something else
    return profile;
}

} // namespace dialogs
