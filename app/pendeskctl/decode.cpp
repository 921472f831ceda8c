// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "decode.h"

#include "options.h"
#include "protocol/decoder.h"
#include "protocol/hextext.h"
#include "values/foreigntext.h"
#include <QCoreApplication>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTextStream>

using protocol::DecodedPacket;
using protocol::Decoder;
using protocol::Field;
using protocol::Fields;

namespace pendeskctl {

namespace {

constexpr int malformed = 1; ///< Exit code: a packet is none, or does not hold what it should.

void insertText(QJsonObject &object, const char *name, const QString &text)
{
    if (!text.isEmpty())
        object.insert(QString::fromLatin1(name), text);
}

/// A NaN is null, with the text beside.
void insertField(QJsonObject &object, const Field &field)
{
    object.insert(field.name, field.value);
    if (field.value.isNull())
        object.insert(field.name + QStringLiteral("_text"), field.words);
}

QJsonObject asJson(const DecodedPacket &packet)
{
    QJsonObject object;
    if (packet.direction)
        object.insert(QStringLiteral("direction"), toString(*packet.direction));
    insertText(object, "name", packet.name);
    for (const Field &field : packet.header + packet.payload)
        insertField(object, field);
    insertText(object, "error", packet.error);
    insertText(object, "problem", packet.problem);
    insertText(object, "meaning", packet.meaning);
    return object;
}

QString valueText(const QJsonValue &value)
{
    if (value.isArray())
        return QString::fromUtf8(QJsonDocument {value.toArray()}.toJson(QJsonDocument::Compact));
    return value.toVariant().toString();
}

/// Hex for codes, words for meanings.
QString asText(const Field &field)
{
    if (field.words.isEmpty())
        return valueText(field.value);
    const bool isPlain =
        field.value.isNull() || field.value.isArray() || field.words.startsWith(u"0x") || field.value.isString();
    return isPlain ? field.words : QStringLiteral("%1 (%2)").arg(valueText(field.value), field.words);
}

void appendLine(QString &text, const QString &name, const QString &value)
{
    if (!value.isEmpty())
        text += QStringLiteral("  %1: %2\n").arg(name, values::oneLine(value));
}

QString asText(const DecodedPacket &packet)
{
    QString text = packet.direction ? toString(*packet.direction) : QStringLiteral("not a packet");
    text += packet.name.isEmpty() ? QStringLiteral("\n") : QStringLiteral(" %1\n").arg(packet.name);
    for (const Field &field : packet.header + packet.payload)
        appendLine(text, field.name, asText(field));
    appendLine(text, QStringLiteral("error"), packet.error);
    appendLine(text, QStringLiteral("problem"), packet.problem);
    appendLine(text, QStringLiteral("meaning"), packet.meaning);
    return text;
}

/// What the command line says.
struct Options {
    bool asText = false;
    protocol::Encoding encoding = protocol::Encoding::Latin1;
    protocol::Model model = protocol::Model::YRC1000;
    std::optional<protocol::Division> division;
    std::optional<QByteArray> request;
    QStringList packets;
};

QCommandLineOption option(const char *name, const QString &description, const char *value = "")
{
    return {QString::fromLatin1(name), description, QString::fromLatin1(value)};
}

std::optional<protocol::Division> divisionOf(const QString &port)
{
    if (port == QString::number(protocol::robotPort))
        return protocol::Division::Robot;
    if (port == QString::number(protocol::filePort))
        return protocol::Division::File;
    return std::nullopt;
}

QString modelList()
{
    QStringList keys;
    for (const protocol::Model model : protocol::allModels)
        keys << QLatin1String(protocol::dialect(model).key);
    return keys.join(QStringLiteral(", "));
}

void addOptions(QCommandLineParser &parser)
{
    const auto text = [](const char *source) { return QCoreApplication::translate("pendeskctl", source); };
    parser.addOption(option("text", text(QT_TRANSLATE_NOOP("pendeskctl", "Print for people instead of JSON."))));
    parser.addOption(
        option("reply-to", text(QT_TRANSLATE_NOOP("pendeskctl", "The request that a reply answers.")), "HEX"));
    parser.addOption(
        option("port", text(QT_TRANSLATE_NOOP("pendeskctl", "The port of the packets: 10040 or 10041.")), "PORT"));
    parser.addOption(option(
        "encoding", text(QT_TRANSLATE_NOOP("pendeskctl", "The encoding of texts: %1.")).arg(encodingList()), "NAME"));
    parser.addOption(
        option("model", text(QT_TRANSLATE_NOOP("pendeskctl", "The controller model: %1.")).arg(modelList()), "NAME"));
    parser.addPositionalArgument(
        QStringLiteral("HEX"), text(QT_TRANSLATE_NOOP("pendeskctl", "A packet; without any, one a line on stdin.")));
}

/// An error carries a sentence for the person at the keyboard.
values::Result<Options> read(const QCommandLineParser &parser)
{
    const auto value = [&parser](const char *name) { return parser.value(QString::fromLatin1(name)); };
    const auto isSet = [&parser](const char *name) { return parser.isSet(QString::fromLatin1(name)); };
    Options options;
    options.asText = isSet("text");
    options.packets = wordsOf(parser);
    if (isSet("reply-to") && !(options.request = protocol::bytesFromHex(value("reply-to"))))
        return values::badInput(QStringLiteral("--reply-to takes a packet in hex"));
    if (isSet("port") && !(options.division = divisionOf(value("port"))))
        return values::badInput(QStringLiteral("--port takes 10040 or 10041"));
    if (isSet("encoding")) {
        const auto encoding = protocol::findEncoding(value("encoding"));
        if (!encoding)
            return values::badInput(QStringLiteral("--encoding takes one of %1").arg(encodingList()));
        options.encoding = *encoding;
    }
    if (isSet("model")) {
        const auto *dialect = protocol::findDialect(value("model"));
        if (!dialect)
            return values::badInput(QStringLiteral("--model takes one of %1").arg(modelList()));
        options.model = dialect->model;
    }
    return options;
}

/// The lines of standard input that are not empty.
QStringList linesOfInput()
{
    QTextStream input {stdin};
    QStringList lines;
    for (QString line; input.readLineInto(&line);) {
        if (!line.trimmed().isEmpty())
            lines += line;
    }
    return lines;
}

DecodedPacket decodeHex(Decoder &decoder, const QString &hex)
{
    if (const auto bytes = protocol::bytesFromHex(hex))
        return decoder.decode(*bytes);
    DecodedPacket packet;
    packet.error = QStringLiteral("not hexadecimal: %1").arg(hex);
    return packet;
}

/// The decoder that the options ask for; an error as read().
values::Result<Decoder> decoderFor(const Options &options)
{
    Decoder decoder {protocol::TextCodec {options.encoding}, options.model};
    if (options.division)
        decoder.setDivision(*options.division);
    if (options.request && !decoder.setRequest(*options.request))
        return values::badInput(QStringLiteral("--reply-to holds no request"));
    return decoder;
}

/// Prints all packets; the exit code.
int printPackets(Decoder decoder, const QStringList &packets, bool forPeople)
{
    int exitCode = Done;
    for (const QString &hex : packets) {
        const DecodedPacket packet = decodeHex(decoder, hex);
        if (forPeople)
            print(asText(packet).split(u'\n'));
        else
            print(QJsonValue {asJson(packet)});
        if (packet.isMalformed())
            exitCode = malformed;
    }
    return exitCode;
}

} // namespace

int runDecode(const QStringList &arguments)
{
    QCommandLineParser parser;
    addOptions(parser);
    if (const auto ended = parse(parser, arguments))
        return *ended;
    const auto options = read(parser);
    const auto decoder = options.and_then(decoderFor);
    if (!decoder) {
        complain(decoder.error().detail);
        return Usage;
    }
    const QStringList packets = options->packets.isEmpty() ? linesOfInput() : options->packets;
    if (packets.isEmpty()) {
        complain(QStringLiteral("no packets are given"));
        return Usage;
    }
    return printPackets(*decoder, packets, options->asText);
}

} // namespace pendeskctl
