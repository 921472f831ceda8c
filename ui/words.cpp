// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/words.h"

#include "values/form.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

namespace ui {

using values::Status;
using widgets::Lamp;
using widgets::Word;

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(Words)
};

QString joined(const QStringList &words) { return words.join(QStringLiteral(" + ")); }

Word onOff(bool isOn, const QString &on, const QString &off)
{
    return isOn ? Word {on, Lamp::Filled} : Word {off, Lamp::Hollow};
}

Word held(bool isHeld)
{
    return isHeld ? Word {Words::tr("HELD"), Lamp::Warning} : Word {Words::tr("no"), Lamp::Hollow};
}

QStringList holdCauses(const Status &status)
{
    QStringList causes;
    if (status.data2 & Status::HeldByPendant)
        causes << Words::tr("PENDANT");
    if (status.data2 & Status::HeldExternally)
        causes << Words::tr("EXTERNAL");
    if (status.data2 & Status::HeldByCommand)
        causes << Words::tr("COMMAND");
    return causes;
}

QString number(double value, int decimals)
{
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator); // 1277.751: one mark is enough
    return locale.toString(value, 'f', decimals);
}

} // namespace

Word modeWord(const Status &status)
{
    QStringList modes;
    if (status.isTeach())
        modes << Words::tr("TEACH");
    if (status.isPlay())
        modes << Words::tr("PLAY");
    const QString mode = modes.isEmpty() ? Words::tr("NO MODE") : joined(modes);
    return {status.isRemote() ? Words::tr("REMOTE %1").arg(mode) : mode,
        status.hasContradictoryMode() ? Lamp::Warning : Lamp::None};
}

Word cycleWord(const Status &status)
{
    QStringList cycles;
    if (status.data1 & Status::Step)
        cycles << Words::tr("STEP");
    if (status.data1 & Status::OneCycle)
        cycles << Words::tr("1 CYCLE");
    if (status.data1 & Status::Continuous)
        cycles << Words::tr("CONTINUOUS");
    return {cycles.isEmpty() ? Words::tr("NO CYCLE") : joined(cycles),
        status.hasContradictoryCycle() ? Lamp::Warning : Lamp::None};
}

Word runWord(const Status &status) { return onOff(status.isRunning(), Words::tr("RUNNING"), Words::tr("stopped")); }

Word servoWord(const Status &status) { return onOff(status.isServoOn(), Words::tr("ON"), Words::tr("OFF")); }

Word holdWord(const Status &status)
{
    return status.isHeld() ? Word {joined(holdCauses(status)), Lamp::Warning} : Word {Words::tr("none"), Lamp::Hollow};
}

Word heldByPendantWord(const Status &status) { return held(status.data2 & Status::HeldByPendant); }

Word heldExternallyWord(const Status &status) { return held(status.data2 & Status::HeldExternally); }

Word heldByCommandWord(const Status &status) { return held(status.data2 & Status::HeldByCommand); }

Word speedLimitWord(const Status &status) { return onOff(status.isSpeedLimited(), Words::tr("ON"), Words::tr("off")); }

Word alarmWord(const Status &status)
{
    return status.hasAlarm() ? Word {Words::tr("ALARM"), Lamp::Alarm} : Word {Words::tr("none"), Lamp::Hollow};
}

Word errorWord(const Status &status)
{
    return status.hasError() ? Word {Words::tr("ERROR"), Lamp::Warning} : Word {Words::tr("none"), Lamp::Hollow};
}

Word summaryWord(const Status &status)
{
    const auto summary = [&](const QString &what, Lamp lamp) {
        return Word {Words::tr("%1 · %2").arg(modeWord(status).text, what), lamp};
    };
    if (status.hasAlarm())
        return summary(Words::tr("alarm"), Lamp::Diamond);
    if (status.hasError())
        return summary(Words::tr("error"), Lamp::Warning);
    if (status.isHeld())
        return summary(Words::tr("held"), Lamp::Warning);
    if (status.hasContradictoryMode())
        return summary(Words::tr("contradictory"), Lamp::Warning);
    return status.isRunning() ? summary(Words::tr("running"), Lamp::Filled) : summary(Words::tr("idle"), Lamp::Hollow);
}

QString controllerText(QByteArrayView bytes, protocol::Encoding encoding)
{
    QString text;
    for (const QChar character : protocol::TextCodec {encoding}.decode(bytes)) {
        if (character.category() == QChar::Other_Control)
            text += QStringLiteral("⟨%1⟩").arg(character.unicode(), 2, 16, QLatin1Char('0')).toUpper();
        else
            text += character;
    }
    return text;
}

QString jobName(const values::ExecutingJob &job, protocol::Encoding encoding)
{
    return job.name.isEmpty() ? widgets::dash() : controllerText(job.name.bytes(), encoding);
}

QString overrideText(const values::ExecutingJob &job)
{
    const double value = job.speedOverride / 100.0;
    return Words::tr("%1 %").arg(QLocale().toString(value, 'g', QLocale::FloatingPointShortest));
}

QString jobPlace(const values::ExecutingJob &job)
{
    if (job.name.isEmpty())
        return {};
    return Words::tr("line %1 · step %2 · %3")
        .arg(QLocale().toString(job.line), QLocale().toString(job.step), overrideText(job));
}

QString millimetres(qint32 micrometres) { return number(micrometres / 1000.0, 3); }

QString degrees(qint32 tenThousandths) { return number(tenThousandths / 10000.0, 4); }

QString pulses(qint32 pulses) { return QLocale().toString(pulses); }

QString axisText(values::PositionType type, int axis, qint32 word)
{
    switch (values::axisUnit(type, axis)) {
    case values::AxisUnit::Micrometre: return millimetres(word);
    case values::AxisUnit::TenThousandthDegree: return degrees(word);
    case values::AxisUnit::Pulse: break;
    }
    return pulses(word);
}

QString axisUnit(values::PositionType type, int axis)
{
    switch (values::axisUnit(type, axis)) {
    case values::AxisUnit::Micrometre: return Words::tr("mm");
    case values::AxisUnit::TenThousandthDegree: return Words::tr("°");
    case values::AxisUnit::Pulse: break;
    }
    return Words::tr("pulses");
}

QString quantityText(const trend::Quantity &quantity)
{
    const auto fixed = [&](int decimals) { return QLocale().toString(quantity.value, 'f', decimals); };
    switch (quantity.unit) {
    case trend::Unit::Bit:
    case trend::Unit::Pulse:
    case trend::Unit::Celsius: return fixed(0);
    case trend::Unit::Percent:
    case trend::Unit::Hour: return fixed(2);
    case trend::Unit::Millimetre: return fixed(3);
    case trend::Unit::Degree: return fixed(4);
    case trend::Unit::Plain: break;
    }
    return QLocale().toString(quantity.value, 'g', 8);
}

namespace {

QString bitWords(quint32 form, std::span<const values::FormBit> table)
{
    QStringList words;
    for (std::size_t bit = 0; bit < table.size(); ++bit)
        words << QCoreApplication::translate("values", form >> bit & 1 ? table[bit].on : table[bit].off);
    return words.join(QStringLiteral(" · "));
}

constexpr std::size_t plainFormBits = 6; ///< Front/back to S; then the redundant one.

} // namespace

QString formText(quint32 form, bool isRedundant)
{
    return bitWords(form, values::formBits().first(plainFormBits + (isRedundant ? 1 : 0)));
}

QString extendedFormText(quint32 form) { return bitWords(form, values::extendedFormBits()); }

QString roundTripText(std::optional<std::chrono::microseconds> trip)
{
    return trip ? Words::tr("%1 ms").arg(number(double(trip->count()) / 1000, 1)) : widgets::dash();
}

QString percent(double share) { return Words::tr("%1 %").arg(number(share * 100, 1)); }

QString ageText(std::optional<std::chrono::milliseconds> age)
{
    if (!age)
        return widgets::dash();
    const double seconds = double(age->count()) / 1000;
    return seconds < 100 ? Words::tr("%1 s").arg(number(seconds, 1)) : Words::tr("%1 min").arg(number(seconds / 60, 0));
}

QString holdCaption(const robot::HoldState &hold)
{
    using robot::HoldWord;
    switch (hold.word) {
    case HoldWord::Asked: return Words::tr("HOLD asked for, %1 s…").arg(hold.seconds);
    case HoldWord::HeldByCommand: return Words::tr("held by command");
    case HoldWord::HeldByPendant: return Words::tr("held by the pendant");
    case HoldWord::HeldExternally: return Words::tr("held externally");
    case HoldWord::Refused: return Words::tr("HOLD refused");
    case HoldWord::Unconfirmed: return Words::tr("HOLD not confirmed");
    case HoldWord::Released: return Words::tr("released");
    case HoldWord::None: break;
    }
    return Words::tr("software hold · Pause key");
}

} // namespace ui
