// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "pictures.h"

#include "options.h"
#include "protocol/codes.h"
#include "ui/controllerview.h"
#include "ui/mainwindow.h"
#include "ui/pagecatalog.h"
#include "ui/words.h"
#include <QApplication>
#include <QDir>
#include <cstdio>

namespace pendesk {

using namespace std::chrono_literals;

Pictures::Pictures(ui::MainWindow &window, const QString &folder, QObject *parent)
    : QObject(parent), m_window {window}, m_folder {folder}
{
    m_look.setInterval(100ms);
    m_deadline.setSingleShot(true);
    m_deadline.setInterval(20s);
    connect(&m_look, &QTimer::timeout, this, &Pictures::look);
    connect(&m_deadline, &QTimer::timeout, this, [this] {
        const auto &trouble = m_window.controller().trouble();
        const QString why = trouble ? protocol::explain(*trouble) : tr("not everything was read");
        std::fprintf(stderr, "%s\n", qUtf8Printable(tr("pendesk: no live controller within 20 s: %1.").arg(why)));
        end(take(QStringLiteral("checking")) ? NoAnswer : LocalFile);
    });
}

void Pictures::start()
{
    if (!take(QStringLiteral("notconnected")))
        return end(LocalFile);
    m_window.controller().open();
    m_look.start();
    m_deadline.start();
}

/// Everything on the pages was read, and two seconds of the link are there to be drawn.
bool Pictures::isLive() const
{
    const robot::Controller &controller = m_window.controller();
    if (controller.linkState() != robot::LinkState::Monitoring || controller.statistics().seconds.size() < 2)
        return false;
    for (const robot::Topic topic : robot::topics::overview) {
        const auto freshness = controller.state().freshness(topic);
        if (freshness != robot::Freshness::Live && freshness != robot::Freshness::Refused)
            return false;
    }
    return true;
}

void Pictures::look()
{
    if (!isLive())
        return;
    if (!take(QStringLiteral("live")))
        return end(LocalFile);
    printStatus();
    end(Done);
}

bool Pictures::take(const QString &state)
{
    if (!QDir().mkpath(m_folder))
        std::fprintf(stderr, "%s\n", qUtf8Printable(tr("pendesk: the folder %1 cannot be made.").arg(m_folder)));
    const auto save = [&](const char *page, const char *scheme) {
        const QString path = QDir(m_folder).filePath(
            QStringLiteral("%1-%2-%3.png").arg(QLatin1String(page), state, QLatin1String(scheme)));
        if (m_window.grab().save(path))
            return true;
        std::fprintf(stderr, "%s\n", qUtf8Printable(tr("pendesk: %1 cannot be written.").arg(path)));
        return false;
    };
    const ui::Scheme before = ui::schemeOf(m_window.palette());
    bool isSaved = true;
    for (const ui::Scheme scheme : {ui::Scheme::Light, ui::Scheme::Dark}) {
        ui::apply(*qApp, scheme);
        for (std::size_t row = 0; isSaved && row < ui::pageCatalog().size(); ++row) {
            m_window.view().openPage(int(row));
            QCoreApplication::sendPostedEvents(); // layouts
            isSaved = save(ui::pageCatalog()[row].id, scheme == ui::Scheme::Light ? "light" : "dark");
        }
    }
    ui::apply(*qApp, before);
    return isSaved;
}

void Pictures::printStatus() const
{
    const robot::RobotState &state = m_window.controller().state();
    const auto print = [](const QString &name, const QString &words) {
        std::printf("%s\n", qUtf8Printable(QStringLiteral("%1: %2").arg(name, words)));
    };
    if (const auto &system = state.systemInformation().value) {
        print(tr("Model"), ui::controllerText(system->model.bytes()));
        print(tr("Software"), ui::controllerText(system->software.bytes()));
    }
    if (const auto &status = state.status().value) {
        print(tr("Mode"), ui::modeWord(*status).text);
        print(tr("Cycle"), ui::cycleWord(*status).text);
        print(tr("Servo"), ui::servoWord(*status).text);
        print(tr("Run"), ui::runWord(*status).text);
        print(tr("Hold"), ui::holdWord(*status).text);
        print(tr("Alarm"), ui::alarmWord(*status).text);
        print(tr("Error"), ui::errorWord(*status).text);
    }
    if (const auto &job = state.job().value)
        print(tr("Executing"),
            ui::jobName(*job, m_window.controller().profile().encoding) + QStringLiteral(", ") + ui::jobPlace(*job));
    std::printf("%s\n", qUtf8Printable(tr("Pictures are in %1").arg(QDir(m_folder).absolutePath())));
}

void Pictures::end(int exitCode)
{
    m_look.stop();
    m_deadline.stop();
    QTimer::singleShot(0, qApp, [exitCode] { QApplication::exit(exitCode); });
}

} // namespace pendesk
