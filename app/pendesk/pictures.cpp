// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "pictures.h"

#include "options.h"
#include "protocol/codes.h"
#include "ui/controllerview.h"
#include "ui/language.h"
#include "ui/mainwindow.h"
#include "ui/pagecatalog.h"
#include "ui/pages/page.h"
#include "ui/words.h"
#include <QApplication>
#include <QDir>
#include <cstdio>

namespace pendesk {

using namespace std::chrono_literals;

namespace {

constexpr QSize size {1440, 900}; ///< Of every picture, whatever the screen or what stands for it.

void say(const QString &sentence) { std::fprintf(stderr, "%s\n", qUtf8Printable(sentence)); }

QString word(ui::Scheme scheme)
{
    return scheme == ui::Scheme::Light ? QStringLiteral("light") : QStringLiteral("dark");
}

} // namespace

Pictures::Pictures(ui::MainWindow &window, QObject *parent) : QObject(parent), m_window {window}
{
    m_look.setInterval(100ms);
    m_deadline.setSingleShot(true);
    m_deadline.setInterval(5s);
    connect(&m_look, &QTimer::timeout, this, &Pictures::look);
    connect(&m_deadline, &QTimer::timeout, this, &Pictures::giveUp);
}

void Pictures::writeFiles(const QString &folder)
{
    m_path = folder;
    m_window.resize(size);
    if (!QDir().mkpath(folder))
        return fail(tr("the folder %1 cannot be made").arg(folder), LocalFile);
    if (!saveAll(QStringLiteral("notconnected")))
        return end(LocalFile);
    m_walks = {{QString(), m_scheme}, {QString(), ui::Scheme::Dark}};
    start();
}

void Pictures::writeSheet(const QString &path, const QStringList &languages)
{
    m_path = path;
    m_window.resize(size);
    QStringList headings;
    for (const QString &language : languages) {
        for (const ui::Scheme scheme : {ui::Scheme::Light, ui::Scheme::Dark}) {
            m_walks << Walk {language, scheme};
            headings << QStringLiteral("%1, %2").arg(language, word(scheme));
        }
    }
    m_sheet.emplace(int(ui::pageCatalog().size()), headings);
    start();
}

void Pictures::start()
{
    m_window.controller().open();
    begin(0);
    m_look.start();
}

/// Dressing takes longer than everything else, so that it is done once for all pages.
void Pictures::dress(ui::Scheme scheme)
{
    m_scheme = scheme;
    if (ui::schemeOf(QApplication::palette()) != scheme)
        ui::apply(*qApp, scheme);
}

void Pictures::begin(int walk)
{
    m_walk = walk;
    dress(m_walks[walk].scheme);
    if (!m_walks[walk].language.isEmpty()) {
        ui::speak(*qApp, m_walks[walk].language);
        QCoreApplication::sendPostedEvents(&m_window, QEvent::LanguageChange); // the pages are made anew
    }
    turnTo(0);
}

void Pictures::turnTo(int row)
{
    m_row = row;
    m_window.view().openPage(row);
    m_deadline.start();
}

void Pictures::look()
{
    if (!isLive())
        return;
    if (!take())
        return end(LocalFile);
    if (m_row + 1 < int(ui::pageCatalog().size()))
        return turnTo(m_row + 1);
    if (m_walk + 1 < int(m_walks.size()))
        return begin(m_walk + 1);
    finish();
}

void Pictures::giveUp()
{
    const auto &trouble = m_window.controller().trouble();
    const QString why = trouble ? protocol::explain(*trouble) : tr("not everything was read");
    const bool isKept = m_sheet || saveAll(QStringLiteral("checking"));
    fail(tr("no live controller within 5 s: %1").arg(why), isKept ? NoAnswer : LocalFile);
}

/// Everything on the page was read or refused, and two seconds of the link are there to be drawn.
bool Pictures::isLive() const
{
    robot::Controller &controller = m_window.controller();
    if (controller.linkState() != robot::LinkState::Monitoring || controller.statistics().seconds.size() < 2)
        return false;
    const auto isRead = [&](const robot::TopicRange &range) {
        for (int number = range.first; number <= range.last; ++number) {
            const auto freshness = controller.state().freshness({range.kind, quint16(number)});
            if (freshness != robot::Freshness::Live && freshness != robot::Freshness::Refused)
                return false;
        }
        return true;
    };
    return std::ranges::all_of(m_window.view().page(m_row)->topics(), isRead);
}

bool Pictures::take()
{
    if (!m_sheet)
        return save(m_row, QStringLiteral("live"));
    QCoreApplication::sendPostedEvents(); // layouts
    m_sheet->add(m_row, m_walk, m_window.grab().toImage());
    return true;
}

/// The page in view.
bool Pictures::save(int row, const QString &state) const
{
    QCoreApplication::sendPostedEvents(); // layouts
    const QString id = QLatin1String(ui::pageCatalog()[std::size_t(row)].id);
    const QString path = QDir(m_path).filePath(QStringLiteral("%1-%2-%3.png").arg(id, state, word(m_scheme)));
    const bool isSaved = m_window.grab().save(path);
    if (!isSaved)
        say(tr("pendesk: %1 cannot be written.").arg(path));
    return isSaved;
}

bool Pictures::saveAll(const QString &state)
{
    for (const ui::Scheme scheme : {ui::Scheme::Dark, ui::Scheme::Light}) {
        dress(scheme);
        for (int row = 0; row < int(ui::pageCatalog().size()); ++row) {
            m_window.view().openPage(row);
            if (!save(row, state))
                return false;
        }
    }
    return true;
}

void Pictures::finish()
{
    if (!m_walks.first().language.isEmpty())
        ui::speak(*qApp, m_walks.first().language); // for what is said from here on
    if (m_sheet && !m_sheet->save(m_path))
        return fail(tr("%1 cannot be written").arg(m_path), LocalFile);
    if (!m_sheet)
        printStatus();
    std::printf("%s\n", qUtf8Printable(tr("Pictures are in %1").arg(QFileInfo(m_path).absoluteFilePath())));
    end(Done);
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
}

void Pictures::fail(const QString &sentence, int exitCode)
{
    say(tr("pendesk: %1.").arg(sentence));
    end(exitCode);
}

void Pictures::end(int exitCode)
{
    m_look.stop();
    m_deadline.stop();
    QTimer::singleShot(0, qApp, [exitCode] { QApplication::exit(exitCode); });
}

} // namespace pendesk
