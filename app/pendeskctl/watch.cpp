// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "named.h"
#include "verbs.h"
#include <QDateTime>
#include <QRegularExpression>
#include <QTimer>
#include <memory>

using values::Result;

namespace pendeskctl {

namespace {

/// A time without answers: it is said when it begins, with how long it was when it ends, and the watching goes on.
class Gap
{
public:
    void begin(Desk &desk, const values::Error &error)
    {
        if (m_since.isValid())
            return;
        m_since = QDateTime::currentDateTimeUtc();
        desk.complainOf(error);
    }
    void end()
    {
        if (m_since.isValid())
            complain(tr("Answers again after %1 s.")
                         .arg(double(m_since.msecsTo(QDateTime::currentDateTimeUtc())) / 1000, 0, 'f', 1));
        m_since = {};
    }

private:
    QDateTime m_since;
};

} // namespace

int runWatch(const QStringList &arguments)
{
    Call call;
    QCommandLineParser parser;
    const QCommandLineOption every {QStringLiteral("every"), tr("Time between two readings: 1s, 200ms."),
        QStringLiteral("TIME"), QStringLiteral("1s")};
    const QCommandLineOption count {
        QStringLiteral("count"), tr("End after so many readings."), QStringLiteral("N"), QStringLiteral("0")};
    const VerbHelp help {tr("Reads variables, registers (M005) and I/O again and again, one line of JSON with --json."),
        QStringLiteral("NAME…"), {every, count}, true, 1, anyNumber};
    if (const auto end = read(call, parser, help, arguments))
        return *end;
    static const QRegularExpression form {QStringLiteral("^(\\d{1,6})(ms|s)$")};
    const auto match = form.match(parser.value(every));
    if (!match.hasMatch())
        return mistake(tr("--every takes a time such as 200ms or 1s."));
    const auto wantedReadings = numberOf(parser, count);
    if (!wantedReadings)
        return Usage;
    const int readings = *wantedReadings;
    const std::chrono::milliseconds period {match.captured(1).toInt() * (match.captured(2) == u"s" ? 1000 : 1)};
    return run(call, [=](Desk &desk) {
        const auto wanted = selectionsFromText(desk.call(), desk.call().words);
        if (!wanted)
            return desk.finish(Usage);
        auto *timer = new QTimer {&desk};
        auto left = std::make_shared<int>(readings);
        auto isReading = std::make_shared<bool>(false);
        auto gap = std::make_shared<Gap>();
        const auto take = [&desk, left, isReading, gap](const Result<QList<NamedValue>> &values) {
            *isReading = false;
            if (!values && values.error().kind != values::ErrorKind::NoAnswer)
                return desk.fail(values.error());
            if (!values)
                return gap->begin(desk, values.error());
            gap->end();
            if (!desk.call().isJson)
                print(QDateTime::currentDateTimeUtc().toString(Qt::ISODateWithMs));
            print(desk.call(), *values);
            if (*left > 0 && --*left == 0)
                desk.finish(Done);
        };
        QObject::connect(timer, &QTimer::timeout, &desk, [&desk, wanted, take, isReading] {
            if (!std::exchange(*isReading, true))
                readAll(desk, *wanted, take);
        });
        timer->start(period);
        *isReading = true;
        readAll(desk, *wanted, take);
    });
}

} // namespace pendeskctl
