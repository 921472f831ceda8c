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

int runWatch(const QStringList &arguments)
{
    Call call;
    QCommandLineParser parser;
    const QCommandLineOption every {QStringLiteral("every"), tr("Time between two readings: 1s, 200ms."),
        QStringLiteral("TIME"), QStringLiteral("1s")};
    const QCommandLineOption count {
        QStringLiteral("count"), tr("End after so many readings."), QStringLiteral("N"), QStringLiteral("0")};
    const VerbHelp help {tr("Reads variables, registers (M005) and I/O again and again, one line of JSON with --json."),
        QStringLiteral("NAME…"), {every, count}};
    if (const auto end = read(call, parser, help, arguments))
        return *end;
    static const QRegularExpression form {QStringLiteral("^(\\d{1,6})(ms|s)$")};
    const auto match = form.match(parser.value(every));
    bool isNumber = false;
    const int readings = parser.value(count).toInt(&isNumber);
    if (!match.hasMatch() || !isNumber || readings < 0)
        return mistake(tr("--every takes a time such as 200ms or 1s, --count a whole number."));
    const std::chrono::milliseconds period {match.captured(1).toInt() * (match.captured(2) == u"s" ? 1000 : 1)};
    const auto wanted = selectionsFromText(call, call.words);
    if (!wanted)
        return Usage;
    return run(call, [=](Desk &desk) {
        auto *timer = new QTimer {&desk};
        auto left = std::make_shared<int>(readings);
        auto isReading = std::make_shared<bool>(false);
        const auto take = [&desk, left, isReading](const Result<QList<NamedValue>> &values) {
            *isReading = false;
            if (!values)
                return desk.fail(values.error());
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
