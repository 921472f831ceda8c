// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "settings/profilestore.h"

#include "settings/settingsfile.h"
#include <QCoreApplication>
#include <QJsonArray>

namespace settings {

namespace {

// The result of the numbering test; a profile without them was never tested.
constexpr auto verifiedKey = "numberingVerified";
constexpr auto softwareKey = "numberingSoftware";

QString tr(const char *text) { return QCoreApplication::translate("settings::Profile", text); }

QString profileKey(const QString &key) { return QStringLiteral("profiles/") + key; }

/// What the program itself remembers of a profile; it is not exported with it.
QString memoryOf(const QString &key) { return QStringLiteral("connections/") + key; }
QString connectedKey(const QString &key) { return memoryOf(key) + QStringLiteral("/connected"); }
QString readinessKey(const QString &key) { return memoryOf(key) + QStringLiteral("/readinessSeen"); }

const QString idKey = QStringLiteral("id");
const QString folderKey = QStringLiteral("folder");
const QString formerNamesKey = QStringLiteral("formerNames");

/// The numbers of a profile: JSON key, label, range, and where they live. Reader, writer and checker go through this
/// list.
void describe(auto &&visit, auto &profile)
{
    visit("port", QT_TRANSLATE_NOOP("settings::Profile", "Port"), 1, 65535, profile.port);
    visit("filePort", QT_TRANSLATE_NOOP("settings::Profile", "File port"), 1, 65535, profile.filePort);
    visit("readTimeoutMs", QT_TRANSLATE_NOOP("settings::Profile", "Read time-out"), 20, 60000, profile.readTimeout);
    visit("fileTimeoutMs", QT_TRANSLATE_NOOP("settings::Profile", "File time-out"), 100, 600000, profile.fileTimeout);
    visit("servoTimeoutMs", QT_TRANSLATE_NOOP("settings::Profile", "Servo time-out"), 100, 60000, profile.servoTimeout);
    visit("readRepeats", QT_TRANSLATE_NOOP("settings::Profile", "Repeats of a read"), 0, 10, profile.readRepeats);
    visit("window", QT_TRANSLATE_NOOP("settings::Profile", "Requests outstanding at once"), 1, 8, profile.window);
    visit("requestsPerSecond", QT_TRANSLATE_NOOP("settings::Profile", "Requests a second"), 1, 10000,
        profile.requestsPerSecond);
}

qint64 number(std::chrono::milliseconds duration) { return duration.count(); }
qint64 number(qint64 value) { return value; }

QJsonObject factorsToJson(const Profile &profile)
{
    QJsonObject json;
    for (const auto &[instance, factors] : profile.pulsesPerDegree)
        json[QString::number(instance)] =
            QJsonArray {factors[0], factors[1], factors[2], factors[3], factors[4], factors[5], factors[6], factors[7]};
    return json;
}

/// The reverse; false if something in it is neither absent nor a finite number.
bool readFactors(const QJsonObject &json, Profile &profile)
{
    for (auto it = json.begin(); it != json.end(); ++it) {
        bool isInstance = false;
        const quint16 instance = it.key().toUShort(&isInstance);
        const QJsonArray factors = it.value().toArray();
        if (!isInstance || factors.isEmpty() || factors.size() > values::maxAxes)
            return false;
        for (qsizetype axis = 0; axis < factors.size(); ++axis) {
            if (!factors[axis].isDouble())
                return false;
            profile.pulsesPerDegree[instance][std::size_t(axis)] = factors[axis].toDouble();
        }
    }
    return true;
}

/// Visits everything that a profile can say about motion limits.
void describeMotion(auto &&visit, auto &motion)
{
    visit("toolSpeed", motion.toolSpeed);
    visit("rotationSpeed", motion.rotationSpeed);
    visit("jointSpeed", motion.jointSpeed);
    visit("stepLength", motion.stepLength);
    visit("stepAngle", motion.stepAngle);
    visit("stepPulses", motion.stepPulses);
}

QJsonArray toJson(const motion::Vector &vector) { return {vector[0], vector[1], vector[2]}; }

QJsonObject motionToJson(const motion::Wishes &motion)
{
    QJsonObject json;
    describeMotion(
        [&](const char *key, const std::optional<double> &wish) {
            if (wish)
                json[QLatin1StringView(key)] = *wish;
        },
        motion);
    if (motion.box)
        json[QStringLiteral("box")] = QJsonObject {
            {QStringLiteral("least"), toJson(motion.box->least)}, {QStringLiteral("most"), toJson(motion.box->most)}};
    if (motion.areFramesChecked)
        json[QStringLiteral("framesChecked")] = true;
    return json;
}

/// What is there and no number becomes NaN, which motion::limits() refuses: nothing moves by a limit that nobody
/// understands, and the rest of the profile stays usable.
motion::Vector vectorFrom(const QJsonValue &json)
{
    motion::Vector vector;
    for (qsizetype axis = 0; axis < 3; ++axis)
        vector[std::size_t(axis)] = json[axis].toDouble(qQNaN());
    return vector;
}

motion::Wishes motionFrom(const QJsonObject &json)
{
    motion::Wishes motion;
    describeMotion(
        [&](const char *key, std::optional<double> &wish) {
            if (const auto given = json.value(QLatin1StringView(key)); !given.isUndefined())
                wish = given.toDouble(qQNaN());
        },
        motion);
    if (const auto box = json.value(u"box"); !box.isUndefined())
        motion.box = motion::Box {vectorFrom(box[u"least"]), vectorFrom(box[u"most"])};
    motion.areFramesChecked = json.value(u"framesChecked").toBool();
    return motion;
}

QString rangeSentence(const char *label, int least, int most)
{
    return tr("%1 must be a whole number from %2 to %3.").arg(tr(label)).arg(least).arg(most);
}

} // namespace

QJsonObject toJson(const Profile &profile)
{
    QJsonObject json {{QStringLiteral("name"), profile.name}, {QStringLiteral("host"), profile.host},
        {QStringLiteral("model"), QLatin1StringView(protocol::dialect(profile.model).key)},
        {QStringLiteral("encoding"), QLatin1StringView(protocol::encodingKey(profile.encoding))},
        {QStringLiteral("numbering"), int(profile.numbering)}};
    if (!profile.id.isNull())
        json[idKey] = profile.id.toString(QUuid::WithoutBraces);
    if (!profile.folder.isEmpty())
        json[folderKey] = profile.folder;
    if (!profile.formerNames.isEmpty())
        json[formerNamesKey] = QJsonArray::fromStringList(profile.formerNames);
    if (profile.tag != 0)
        json[QStringLiteral("tag")] = profile.tag;
    if (profile.numberingVerified.isValid()) {
        json[QLatin1StringView(verifiedKey)] = profile.numberingVerified.toUTC().toString(Qt::ISODate);
        json[QLatin1StringView(softwareKey)] = profile.numberingSoftware;
    }
    describe([&](const char *key, const char *, int, int,
                 const auto &value) { json[QLatin1StringView(key)] = number(value); },
        profile);
    if (!profile.pulsesPerDegree.empty())
        json[QStringLiteral("pulsesPerDegree")] = factorsToJson(profile);
    if (profile.motion != motion::Wishes {})
        json[QStringLiteral("motion")] = motionToJson(profile.motion);
    return json;
}

values::Result<Profile> profileFromJson(const QJsonObject &json)
{
    using values::ErrorKind;
    Profile profile;
    profile.name = json.value(u"name").toString();
    profile.host = json.value(u"host").toString();
    profile.id = QUuid::fromString(json.value(idKey).toString());
    profile.folder = json.value(folderKey).toString();
    for (const QJsonValue name : json.value(formerNamesKey).toArray())
        profile.formerNames << name.toString();
    profile.tag = std::clamp(json.value(u"tag").toInt(), 0, 3);
    const QString model = json.value(u"model").toString();
    if (const auto *dialect = protocol::findDialect(model))
        profile.model = dialect->model;
    else
        return values::badInput(tr("The model “%1” is not known.").arg(model));
    const QString encoding = json.value(u"encoding").toString();
    if (const auto found = protocol::findEncoding(encoding))
        profile.encoding = *found;
    else
        return values::badInput(tr("The text encoding “%1” is not known.").arg(encoding));
    const int numbering = json.value(u"numbering").toInt(-1);
    if (numbering != 0 && numbering != 1)
        return values::badInput(tr("The variable numbering must be 0 or 1."));
    profile.numbering = protocol::Numbering(numbering);
    profile.numberingVerified =
        QDateTime::fromString(json.value(QLatin1StringView(verifiedKey)).toString(), Qt::ISODate);
    profile.numberingSoftware = json.value(QLatin1StringView(softwareKey)).toString();
    QString trouble;
    describe(
        [&](const char *key, const char *label, int least, int most, auto &value) {
            const double given = json.value(QLatin1StringView(key)).toDouble(-1);
            if (given < least || given > most || given != int(given))
                trouble = trouble.isEmpty() ? rangeSentence(label, least, most) : trouble;
            else
                value = std::remove_reference_t<decltype(value)>(int(given));
        },
        profile);
    profile.motion = motionFrom(json.value(u"motion").toObject());
    if (!readFactors(json.value(u"pulsesPerDegree").toObject(), profile))
        trouble = tr("Pulses per degree must be lists of numbers, one list for each control group.");
    if (trouble.isEmpty())
        trouble = complaint(profile);
    if (!trouble.isEmpty())
        return values::badInput(trouble);
    return profile;
}

QString complaint(const Profile &profile)
{
    if (profile.name.trimmed().isEmpty())
        return tr("The profile needs a name.");
    if (profile.host.trimmed().isEmpty())
        return tr("The profile needs the controller's host name or IPv4 address.");
    QString trouble;
    describe(
        [&](const char *, const char *label, int least, int most, const auto &value) {
            if (trouble.isEmpty() && (number(value) < least || number(value) > most))
                trouble = rangeSentence(label, least, most);
        },
        profile);
    return trouble;
}

ProfileStore::ProfileStore(SettingsFile &settings) : m_settings {settings}
{
    for (const QString &key : m_settings.keys(QStringLiteral("profiles"))) {
        if (QUuid::fromString(key).isNull())
            takeOver(key);
    }
}

/// A profile that goes by its name gets an id; its folders keep that name.
void ProfileStore::takeOver(const QString &key)
{
    QJsonObject json = m_settings.value(profileKey(key)).toObject();
    const auto profile = profileFromJson(json);
    if (!profile)
        return; // it cannot be read and is left alone
    // The same whichever program comes first.
    static constexpr QUuid space {0x7c1be3a4, 0x9d21, 0x4f0a, 0x8b, 0x5e, 0x1f, 0x62, 0xd3, 0x90, 0x4a, 0xc7};
    const QString id = QUuid::createUuidV5(space, key).toString(QUuid::WithoutBraces);
    json[idKey] = id;
    json[folderKey] = profile->name;
    m_settings.setValue(profileKey(id), json);
    m_settings.remove(profileKey(key));
    move(QStringLiteral("notes/") + key, QStringLiteral("notes/") + id);
    move(memoryOf(key), memoryOf(id));
}

void ProfileStore::move(const QString &from, const QString &to)
{
    for (const QString &key : m_settings.keys(from))
        m_settings.setValue(to + u'/' + key, m_settings.value(from + u'/' + key));
    m_settings.remove(from);
}

QString ProfileStore::keyOf(const Profile &profile)
{
    return profile.id.isNull() ? profile.name : profile.id.toString(QUuid::WithoutBraces);
}

QList<Profile> ProfileStore::profiles() const
{
    QList<Profile> found;
    for (const QString &key : m_settings.keys(QStringLiteral("profiles"))) {
        const QJsonValue json = m_settings.value(QStringLiteral("profiles/") + key);
        if (const auto profile = profileFromJson(json.toObject()))
            found.append(*profile);
    }
    std::ranges::sort(found, {}, &Profile::name);
    return found;
}

std::optional<Profile> ProfileStore::find(const QString &name) const
{
    for (const Profile &profile : profiles()) {
        if (profile.name == name)
            return profile;
    }
    return std::nullopt;
}

Notes ProfileStore::notes(const QString &name) const
{
    const auto profile = find(name);
    return {m_settings, profile ? keyOf(*profile) : name};
}

std::optional<Profile> ProfileStore::find(const QUuid &id) const
{
    for (const Profile &profile : profiles()) {
        if (profile.id == id)
            return profile;
    }
    return std::nullopt;
}

Profile ProfileStore::save(const Profile &profile)
{
    Profile saved = profile;
    const auto known = profile.id.isNull() ? find(profile.name) : find(profile.id);
    if (known) {
        saved.id = known->id;
        saved.folder = known->folderName();
        saved.formerNames = known->formerNames;
        saved.formerNames.removeAll(saved.name);
        if (known->name != saved.name)
            saved.formerNames.prepend(known->name);
    } else {
        saved.id = profile.id.isNull() ? QUuid::createUuid() : profile.id;
        saved.folder = freeFolder(profile);
    }
    m_settings.setValue(profileKey(keyOf(saved)), toJson(saved));
    return saved;
}

/// A name that no other controller's folders have; the controller's own where nobody has it.
QString ProfileStore::freeFolder(const Profile &profile) const
{
    const QString wish = profile.folderName();
    QString folder = wish;
    const auto all = profiles();
    const auto isTaken = [&] {
        return std::ranges::any_of(all, [&](const Profile &one) { return one.folderName() == folder; });
    };
    for (int count = 2; isTaken(); ++count)
        folder = QStringLiteral("%1 (%2)").arg(wish).arg(count);
    return folder;
}

void ProfileStore::remove(const QString &name)
{
    if (const auto profile = find(name)) {
        m_settings.remove(profileKey(keyOf(*profile)));
        m_settings.remove(memoryOf(keyOf(*profile)));
    }
}

/// An id, or the name that was kept by earlier versions.
QString ProfileStore::lastUsed() const
{
    const QString kept = m_settings.value(QStringLiteral("lastProfile")).toString();
    const auto profile = find(QUuid::fromString(kept));
    return profile ? profile->name : kept;
}

void ProfileStore::setLastUsed(const QString &name)
{
    const auto profile = find(name);
    m_settings.setValue(QStringLiteral("lastProfile"), profile ? keyOf(*profile) : name);
}

QList<QUuid> ProfileStore::openStations() const
{
    QList<QUuid> ids;
    for (const QJsonValue id : m_settings.value(QStringLiteral("window/openStations")).toArray())
        ids << QUuid::fromString(id.toString());
    return ids;
}

void ProfileStore::setOpenStations(const QList<QUuid> &ids)
{
    QJsonArray list;
    for (const QUuid &id : ids)
        list << id.toString(QUuid::WithoutBraces);
    m_settings.setValue(QStringLiteral("window/openStations"), list);
}

QList<RecentProfile> ProfileStore::recent(int most) const
{
    QList<RecentProfile> found;
    for (const Profile &profile : profiles()) {
        const QString at = m_settings.value(connectedKey(keyOf(profile))).toString();
        found << RecentProfile {profile, QDateTime::fromString(at, Qt::ISODateWithMs)};
    }
    const auto isNewer = [](const RecentProfile &a, const RecentProfile &b) {
        return a.connected.isValid() && (!b.connected.isValid() || a.connected > b.connected);
    };
    std::stable_sort(found.begin(), found.end(), isNewer);
    return found.mid(0, most);
}

void ProfileStore::noteConnected(const QString &name, const QDateTime &at)
{
    if (const auto profile = find(name))
        m_settings.setValue(connectedKey(keyOf(*profile)), at.toUTC().toString(Qt::ISODateWithMs));
}

bool ProfileStore::isReadinessSeen(const QString &name) const
{
    const auto profile = find(name);
    return profile && m_settings.value(readinessKey(keyOf(*profile))).toBool();
}

void ProfileStore::setReadinessSeen(const QString &name)
{
    if (const auto profile = find(name))
        m_settings.setValue(readinessKey(keyOf(*profile)), true);
}

QStringList ProfileStore::pagesInWindows() const
{
    QStringList ids;
    for (const QJsonValue id : m_settings.value(QStringLiteral("window/pagesInWindows")).toArray())
        ids << id.toString();
    return ids;
}

void ProfileStore::setPagesInWindows(const QStringList &ids)
{
    m_settings.setValue(QStringLiteral("window/pagesInWindows"), QJsonArray::fromStringList(ids));
}

Appearance ProfileStore::appearance() const
{
    return {m_settings.value(QStringLiteral("appearance/language")).toString(),
        m_settings.value(QStringLiteral("appearance/scheme")).toString()};
}

void ProfileStore::setAppearance(const Appearance &appearance)
{
    m_settings.setValue(QStringLiteral("appearance/language"), appearance.language);
    m_settings.setValue(QStringLiteral("appearance/scheme"), appearance.scheme);
}

} // namespace settings
