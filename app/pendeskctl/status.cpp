// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "status.h"

#include "options.h"
#include "protocol/codes.h"
#include "robot/controller.h"
#include "robot/snapshot.h"
#include <QCoreApplication>
#include <QJsonObject>

using namespace robot;

namespace pendeskctl {

namespace {

bool isComplete(const RobotState &state)
{
    for (const Topic topic : topics::overview) {
        if (state.freshness(topic) == Freshness::Unknown)
            return false;
    }
    return true;
}

QString addressed(const settings::Profile &profile, const values::Error &error)
{
    return QStringLiteral("%1:%2: %3").arg(profile.host).arg(profile.port).arg(protocol::explain(error));
}

void printState(const RobotState &state, const protocol::TextCodec &codec, bool asJson)
{
    if (asJson)
        print(QJsonValue {toJson(state, codec)}, QJsonDocument::Indented);
    else
        print(toLines(state, codec));
}

} // namespace

int runStatus(const QStringList &arguments)
{
    Call call;
    QCommandLineParser parser;
    const VerbHelp help {tr("Reads status, executing job, position and system information once."), {}};
    if (const auto end = read(call, parser, help, arguments))
        return *end;

    Controller controller {call.profile};
    const auto interest = controller.poller().want({topics::overview.begin(), topics::overview.end()});
    QObject::connect(&controller.state(), &RobotState::changed, &controller, [&] {
        if (controller.linkState() == LinkState::Monitoring && isComplete(controller.state()))
            QCoreApplication::exit(Done);
    });
    QObject::connect(&controller, &Controller::troubleChanged, &controller, [&] {
        if (!controller.trouble())
            return;
        complain(addressed(call.profile, *controller.trouble()));
        QCoreApplication::exit(exitCodeOf(*controller.trouble()));
    });
    QObject::connect(&controller, &Controller::linkStateChanged, &controller, [&] {
        if (controller.linkState() != LinkState::Lost)
            return;
        complain(addressed(call.profile, {values::ErrorKind::NoAnswer, 0, 0, {}}));
        QCoreApplication::exit(NoAnswer);
    });
    controller.open();
    const int end = QCoreApplication::exec();
    if (end == Done)
        printState(controller.state(), protocol::TextCodec {call.profile.encoding}, call.isJson);
    return end;
}

} // namespace pendeskctl
