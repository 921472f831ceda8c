// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "robot/namebook.h"

#include "cellfiles/signalnames.h"
#include "robot/controller.h"
#include "session/filesession.h"

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
        for (Source &source : m_sources)
            source.fetch.isUnderWay = false; // a transfer ends with its link
        const bool isNew = controller.linkState() == LinkState::Monitoring && controller.timesLost() == 0;
        if (isNew && controller.files())
            fetch(*controller.files());
    });
}

NameBook::OwnNames NameBook::readSignals(const QByteArray &file, const protocol::TextCodec &codec)
{
    const auto parsed = cellfiles::signalNamesFrom(file, codec);
    OwnNames own;
    for (auto name = parsed.value.names.begin(); name != parsed.value.names.end(); ++name)
        own.signalNames.insert({name.key() / 10, name.key() % 10}, name.value());
    own.warnings = parsed.warnings;
    return own;
}

NameBook::OwnNames NameBook::readVariables(const QByteArray &file, const protocol::TextCodec &codec)
{
    const auto parsed = cellfiles::variableNamesFrom(file, codec);
    return {{}, parsed.value.byVariable(), parsed.warnings};
}

NameBook::OwnNames NameBook::readRegisters(const QByteArray &file, const protocol::TextCodec &codec)
{
    const auto parsed = cellfiles::registerNamesFrom(file, codec);
    OwnNames own;
    for (auto name = parsed.value.names.begin(); name != parsed.value.names.end(); ++name)
        own.variableNames.insert({variables::Kind::M, name.key()}, name.value());
    own.warnings = parsed.warnings;
    return own;
}

void NameBook::fetch(session::FileSession &files)
{
    for (Source &source : m_sources)
        fetch(files, source);
}

void NameBook::fetch(session::FileSession &files, Source &source)
{
    if (std::exchange(source.fetch.isUnderWay, true))
        return;
    files.save(*FileName::create(source.file), this,
        [this, &source](const Result<QByteArray> &file) { onFetched(file, source); });
    Q_EMIT fetchChanged();
}

void NameBook::onFetched(const Result<QByteArray> &file, Source &source)
{
    source.fetch = {};
    if (file) {
        source.names = source.read(*file, m_codec);
        source.fetch.warnings = source.names.warnings;
        takeOwnNames();
    } else {
        source.fetch.error = file.error();
    }
    Q_EMIT fetchChanged();
}

void NameBook::takeOwnNames()
{
    OwnNames all;
    for (const Source &source : m_sources) {
        all.signalNames.insert(source.names.signalNames);
        all.variableNames.insert(source.names.variableNames);
    }
    m_names.takeSignalNames(all.signalNames);
    m_names.takeVariableNames(all.variableNames);
    Q_EMIT changed();
}

} // namespace robot
