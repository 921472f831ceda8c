// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "status.h"

#include "options.h"
#include "protocol/codes.h"
#include "robot/controller.h"
#include "robot/snapshot.h"
#include "settings/commandline.h"
#include <QCoreApplication>
#include <QJsonDocument>

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
        print(QString::fromUtf8(QJsonDocument {toJson(state, codec)}.toJson(QJsonDocument::Indented)).trimmed());
    else
        print(toLines(state, codec).join(u'\n'));
}

} // namespace

int runStatus(const QStringList &arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(QCoreApplication::translate(
        "pendeskctl", "Reads status, executing job, position and system information once."));
    settings::addConnectionOptions(parser);
    parser.addOption({QStringLiteral("json"), QCoreApplication::translate("pendeskctl", "Print JSON.")});
    if (const auto end = parse(parser, arguments))
        return *end;
    const auto profile = profileOf(parser);
    if (!profile) {
        complain(profile.error().detail);
        return Usage;
    }

    Controller controller {*profile};
    const auto interest = controller.poller().want({topics::overview.begin(), topics::overview.end()});
    QObject::connect(&controller.state(), &RobotState::changed, &controller, [&] {
        if (controller.linkState() == LinkState::Monitoring && isComplete(controller.state()))
            QCoreApplication::exit(Done);
    });
    QObject::connect(&controller, &Controller::troubleChanged, &controller, [&] {
        if (!controller.trouble())
            return;
        complain(addressed(*profile, *controller.trouble()));
        QCoreApplication::exit(exitCodeOf(*controller.trouble()));
    });
    QObject::connect(&controller, &Controller::linkStateChanged, &controller, [&] {
        if (controller.linkState() != LinkState::Lost)
            return;
        complain(addressed(*profile, {values::ErrorKind::NoAnswer, 0, 0, {}}));
        QCoreApplication::exit(NoAnswer);
    });
    controller.open();
    const int end = QCoreApplication::exec();
    if (end == Done)
        printState(controller.state(), protocol::TextCodec {profile->encoding}, parser.isSet(QStringLiteral("json")));
    return end;
}

} // namespace pendeskctl
