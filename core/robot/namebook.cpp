// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "robot/namebook.h"

#include "robot/controller.h"
#include "session/filesession.h"
#include <functional>

namespace robot {

using values::ErrorKind;
using values::FileName;
using values::Result;

namespace {

const QString namesSubject = QStringLiteral("names");
const QString remarksSubject = QStringLiteral("remarks");

} // namespace

NameBook::NameBook(const settings::Profile &profile, settings::Notes notes, QObject *parent)
    : QObject {parent}, m_codec {profile.encoding}, m_dialect {profile.dialect()}, m_notes {std::move(notes)}
{
    m_names.setLocalNames(m_notes.read(namesSubject), m_dialect);
    const QJsonObject remarks = m_notes.read(remarksSubject);
    for (auto remark = remarks.begin(); remark != remarks.end(); ++remark) {
        if (const auto variable = variables::referenceFromText(remark.key(), m_dialect))
            m_remarks.insert(*variable, remark.value().toString());
    }
}

void NameBook::keepNames()
{
    m_notes.write(namesSubject, m_names.localNames());
    Q_EMIT changed();
}

void NameBook::setLocalName(const names::Signal &signal, const QString &text)
{
    m_names.setLocal(signal, text);
    keepNames();
}

void NameBook::setLocalName(const variables::Reference &variable, const QString &text)
{
    m_names.setLocal(variable, text);
    keepNames();
}

void NameBook::setRemark(const variables::Reference &variable, const QString &text)
{
    if (text.trimmed().isEmpty())
        m_remarks.remove(variable);
    else
        m_remarks.insert(variable, text.trimmed());
    QJsonObject json;
    for (auto remark = m_remarks.cbegin(); remark != m_remarks.cend(); ++remark)
        json[toString(remark.key())] = remark.value();
    m_notes.write(remarksSubject, json);
    Q_EMIT changed();
}

void NameBook::follow(Controller &controller)
{
    connect(&controller, &Controller::linkStateChanged, this, [this, &controller] {
        m_signalFetch.isUnderWay = false; // a transfer ends with its link
        m_variableFetch.isUnderWay = false;
        const bool isNew = controller.linkState() == LinkState::Monitoring && controller.timesLost() == 0;
        if (isNew && controller.files())
            fetch(*controller.files());
    });
}

void NameBook::fetch(session::FileSession &files)
{
    fetch(files, "IONAME.DAT", m_signalFetch, &names::Names::takeSignalNames);
    fetch(files, "VARNAME.DAT", m_variableFetch, &names::Names::takeVariableNames);
}

void NameBook::fetch(session::FileSession &files, QByteArrayView name, Fetch &fetch, Take take)
{
    if (std::exchange(fetch.isUnderWay, true))
        return;
    files.save(*FileName::create(name), this,
        [this, &fetch, take](const Result<QByteArray> &file) { onFetched(file, fetch, take); });
    Q_EMIT fetchChanged();
}

void NameBook::onFetched(const Result<QByteArray> &file, Fetch &fetch, Take take)
{
    fetch = {};
    if (file) {
        names::NameFile read = names::readNames(*file, m_codec, m_dialect);
        fetch.remarks = read.remarkCount;
        fetch.remarkList = std::move(read.remarks);
        std::invoke(take, m_names, read);
        Q_EMIT changed();
    } else {
        fetch.error = file.error();
    }
    Q_EMIT fetchChanged();
}

} // namespace robot
