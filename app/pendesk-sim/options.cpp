// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "options.h"

#include "settings/commandline.h"
#include "virtualcontroller/state.h"
#include <QCommandLineParser>
#include <QCoreApplication>
#include <QDir>
#include <QFile>

using values::ErrorKind;
using values::Result;
using virtualcontroller::Faults;
using virtualcontroller::Memory;
using virtualcontroller::Script;
using virtualcontroller::Settings;

namespace {

constexpr int maxCount = 64;
constexpr qint64 maxFileSize = 16 << 20;

void addOptions(QCommandLineParser &parser)
{
    const auto option = [](const char *name, const QString &text, const char *value = "", const char *fallback = "") {
        return QCommandLineOption {
            QLatin1StringView {name}, text, QLatin1StringView {value}, QLatin1StringView {fallback}};
    };
    const auto tr = [](const char *text) { return QCoreApplication::translate("pendesk-sim", text); };
    parser.setApplicationDescription(tr("Virtual robot controllers for demonstrations, training and tests."));
    parser.addOption(option("help", tr("Print this and end.")));
    parser.addOption(option("version", tr("Print the version and end.")));
    parser.addOption(option("host", tr("Listen on this IP address."), "address", "127.0.0.1"));
    parser.addOption(option("port", tr("Robot control port; 0 takes a free one."), "port", "10040"));
    parser.addOption(option("file-port", tr("File port; 0 takes a free one."), "port", "10041"));
    parser.addOption(option("model", tr("dx100, dx200, fs100, yrc1000 or yrc1000micro."), "model", "yrc1000"));
    parser.addOption(option("numbering", tr("Instance of the first variable, 0 or 1 (RS022)."), "number", "0"));
    parser.addOption(option("files", tr("Serve the files of this folder, read once; it is never written."), "folder"));
    parser.addOption(option("state", tr("Start with this state (JSON)."), "file"));
    parser.addOption(option("script", tr("Let the events of this timeline happen (JSON)."), "file"));
    parser.addOption(option("count", tr("Serve so many controllers; the ports count upwards."), "number", "1"));
    parser.addOption(option("faults", tr("Faults on the wire, as \"seed=7; any reply lose p=0.1\"."), "table"));
    settings::addLogOption(parser);
    parser.addOption(option("demo", tr("Start with servo power on and a job running.")));
}

/// The whole number of an option, in first..last.
Result<int> numberOf(const QCommandLineParser &parser, const char *name, int first, int last)
{
    const QString text = parser.value(QLatin1StringView {name});
    bool ok = false;
    const int number = text.toInt(&ok);
    if (ok && number >= first && number <= last)
        return number;
    return values::badInput(QStringLiteral("--%1 takes a number from %2 to %3, not \"%4\".")
                                .arg(QLatin1StringView {name})
                                .arg(first)
                                .arg(last)
                                .arg(text));
}

Result<QByteArray> contentsOf(const QString &path)
{
    QFile file {path};
    if (!file.open(QIODevice::ReadOnly))
        return values::failure(
            ErrorKind::LocalFile, QStringLiteral("%1 cannot be read: %2.").arg(path, file.errorString()));
    return file.readAll();
}

/// The files of a folder take the place of those that the controller is made with. Links are not followed, subfolders
/// not entered.
Result<void> readFiles(const QString &path, Memory &memory)
{
    const QDir folder {path};
    if (!folder.exists())
        return values::failure(ErrorKind::LocalFile, QStringLiteral("%1 is not a folder.").arg(path));
    memory.files.clear();
    for (const QFileInfo &entry : folder.entryInfoList(QDir::Files | QDir::Readable | QDir::NoSymLinks)) {
        const auto contents = entry.size() <= maxFileSize ? contentsOf(entry.filePath()) : Result<QByteArray> {};
        if (!contents)
            return tl::unexpected(contents.error());
        if (!contents->isEmpty())
            memory.files[entry.fileName().toLatin1()] = *contents;
    }
    return {};
}

/// "state.json: what is wrong".
template <typename Value> Result<Value> inFile(const QString &path, Result<Value> result)
{
    return std::move(result).map_error([&path](values::Error error) {
        if (error.kind == ErrorKind::BadInput)
            error = {ErrorKind::LocalFile, 0, 0, path + QStringLiteral(": ") + error.detail};
        return error;
    });
}

Result<Settings> settingsOf(const QCommandLineParser &parser)
{
    const QString name = parser.value(QStringLiteral("model"));
    const auto *dialect = protocol::findDialect(name);
    if (!dialect)
        return values::badInput(QStringLiteral("--model does not know \"%1\".").arg(name));
    const auto numbering = numberOf(parser, "numbering", 0, 1);
    if (!numbering)
        return tl::unexpected(numbering.error());
    Settings settings;
    settings.model = dialect->model;
    settings.numbering = protocol::Numbering(*numbering);
    return settings;
}

Result<void> takeNumbers(const QCommandLineParser &parser, SimOptions &options)
{
    const auto port = numberOf(parser, "port", 0, 65535);
    const auto filePort = port ? numberOf(parser, "file-port", 0, 65535) : port;
    const auto count = filePort ? numberOf(parser, "count", 1, maxCount) : filePort;
    if (!count)
        return tl::unexpected(count.error());
    options.server.port = quint16(*port);
    options.server.filePort = quint16(*filePort);
    options.count = *count;
    const int last = std::max(*port, *filePort) + 2 * (*count - 1);
    return last <= 65535 ? Result<void> {} : values::badInput(QStringLiteral("--count leads beyond port 65535."));
}

Result<void> takeFiles(const QCommandLineParser &parser, SimOptions &options)
{
    const QString files = parser.value(QStringLiteral("files"));
    const QString state = parser.value(QStringLiteral("state"));
    const QString script = parser.value(QStringLiteral("script"));
    Result<void> result;
    if (parser.isSet(QStringLiteral("files")))
        result = readFiles(files, options.memory);
    if (result && parser.isSet(QStringLiteral("state")))
        result = contentsOf(state).and_then(
            [&](const QByteArray &json) { return inFile(state, virtualcontroller::applyState(json, options.memory)); });
    if (result && parser.isSet(QStringLiteral("script")))
        result = contentsOf(script)
                     .and_then([&](const QByteArray &json) { return inFile(script, Script::parse(json)); })
                     .map([&](Script parsed) { options.server.script = std::move(parsed); });
    return result;
}

Result<void> takeFaults(const QCommandLineParser &parser, SimOptions &options)
{
    auto faults = Faults::parse(parser.value(QStringLiteral("faults")));
    if (!faults)
        return values::badInput(QStringLiteral("--faults: ") + faults.error().detail);
    options.server.faults = std::move(*faults);
    return {};
}

} // namespace

Result<SimOptions> parseOptions(const QStringList &arguments)
{
    QCommandLineParser parser;
    addOptions(parser);
    if (!parser.parse(arguments))
        return values::badInput(parser.errorText());
    if (!parser.positionalArguments().isEmpty())
        return values::badInput(QStringLiteral("\"%1\" is not an option.").arg(parser.positionalArguments().first()));
    settings::applyLogOption(parser);
    const auto settings = settingsOf(parser);
    if (!settings)
        return tl::unexpected(settings.error());
    const bool isDemo = parser.isSet(QStringLiteral("demo"));
    SimOptions options {{}, isDemo ? Memory::demo(*settings) : Memory {*settings}, 1, {}};
    options.server.settings = *settings;
    options.server.address = parser.value(QStringLiteral("host"));
    if (parser.isSet(QStringLiteral("help")))
        options.ended = usage();
    else if (parser.isSet(QStringLiteral("version")))
        options.ended = QStringLiteral("pendesk-sim " PENDESK_VERSION "\n");
    return takeNumbers(parser, options)
        .and_then([&] { return takeFaults(parser, options); })
        .and_then([&] { return takeFiles(parser, options); })
        .map([&] { return std::move(options); });
}

QString usage()
{
    QCommandLineParser parser;
    addOptions(parser);
    return parser.helpText();
}
