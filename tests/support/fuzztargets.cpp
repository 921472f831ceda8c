// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "support/fuzztargets.h"

#include "cell/comparison.h"
#include "cellfiles/filetypes.h"
#include "files/bagtext.h"
#include "files/jobdiff.h"
#include "files/preflight.h"
#include "protocol/catalog.h"
#include "protocol/decoder.h"
#include "protocol/fileblocks.h"
#include "protocol/requests.h"
#include "virtualcontroller/filestore.h"

using namespace protocol;
using namespace values;

namespace fuzz {

namespace {

void require(bool holds, const char *what)
{
    if (!holds)
        qFatal("%s", what);
}

/// Takes bytes off the front; 0 when there are none left.
class Source
{
public:
    explicit Source(QByteArrayView data) : m_rest {data} { }

    quint8 byte()
    {
        const auto taken = take(1);
        return taken.isEmpty() ? quint8(0) : quint8(taken.front());
    }
    QByteArrayView take(qsizetype size)
    {
        const auto taken = m_rest.first(std::min(size, m_rest.size()));
        m_rest = m_rest.sliced(taken.size());
        return taken;
    }
    /// One of several things.
    const auto &choose(const auto &things) { return things[byte() % things.size()]; }
    [[nodiscard]] QByteArrayView rest() const { return m_rest; }

private:
    QByteArrayView m_rest;
};

/// What was read encodes to the bytes that it was read from, as far as both go: some payloads may be short or long.
template <typename Value> void survivesRoundTrip(QByteArrayView payload, int element)
{
    const auto value = decode<Value>(payload, element);
    if (!value)
        return;
    const QByteArray encoded = encode(*value, element);
    const qsizetype common = std::min(encoded.size(), payload.size());
    require(payload.first(common) == QByteArrayView {encoded}.first(common), "a value encodes to other bytes");
}

template <typename Item> void survivesPluralRoundTrip(QByteArrayView payload, int count)
{
    if (const auto items = decodePlural<Item>(payload, quint32(count)))
        require(encodePlural(quint32(count), *items) == payload, "items encode to other bytes");
}

/// The second parameter is the element of a single-element service, or the count of a plural one.
using RoundTrip = void (*)(QByteArrayView payload, int);

template <typename... Values>
constexpr std::array<RoundTrip, sizeof...(Values)> roundTrips {survivesRoundTrip<Values>...};
template <typename... Items>
constexpr std::array<RoundTrip, sizeof...(Items)> pluralRoundTrips {survivesPluralRoundTrip<Items>...};

constexpr auto valueRoundTrips =
    roundTrips<Alarm, AlarmWithTexts, Status, ExecutingJob, AxisNames, Position, FollowingError, Torque, ManagementTime,
        SystemInformation, EncoderTemperatures, ConverterTemperature, IoGroup, Register, ByteVariable, IntegerVariable,
        DoubleVariable, RealVariable, StringVariable16, StringVariable32, PositionVariable, BasePosition,
        ExternalPosition, ControlWord, CycleSelection, PendantText, JobSelection, CartesianTarget, PulseTarget>;
constexpr auto itemRoundTrips = pluralRoundTrips<IoGroup, Register, ByteVariable, IntegerVariable, DoubleVariable,
    RealVariable, StringVariable16, StringVariable32, PositionVariable, BasePosition, ExternalPosition>;

/// What can be said of a request by its address and its size.
void judges(const Request &request, const Dialect &dialect)
{
    const Command *command = findCommand(request.command);
    const quint16 fault = addressFault(request, dialect);
    require(fault || command->hasInstance(request.instance, dialect), "an instance that is not there was let through");
    require(requestPayload(request.service) != PayloadKind::Empty || effectOf(request) == Effect::Reads,
        "a request without a payload does not just read");
}

/// Blocks as a controller might send them: two bytes choose the number and the mark, one the size.
void collectsBlocks(Source &source)
{
    BlockCollector collector;
    QByteArray taken;
    while (!source.rest().isEmpty()) {
        const quint32 last = source.byte() & 1 ? lastBlock : 0;
        const quint32 number = source.byte() % 8;
        const auto content = source.take(source.byte());
        const auto step = collector.take(
            {{Division::File, true, 1, number | last}, replyService(Service::ListFiles), 0, 0, 0, content});
        if (step && *step != BlockCollector::Step::Repeated)
            taken += content;
        require(!step || *step == BlockCollector::Step::Repeated || collector.isComplete() == (last != 0),
            "the last block is not the last one");
    }
    require(collector.content() == taken, "blocks were lost");
}

/// A file cut into blocks of a size that one byte chooses.
void loadsBlocks(Source &source)
{
    const qsizetype size = 16 + source.byte();
    const auto content = source.rest();
    const quint32 count = blockCount(content, size);
    QByteArray joined;
    for (quint32 index = 1; index <= count; ++index) {
        const QByteArray datagram = encodeLoadBlock(content, index, 1, size);
        const auto block = parseClientPacket(datagram);
        require(block && block->framing.block == blockNumber(index, count), "a block is no packet");
        joined += block->payload;
    }
    require(joined == content, "a load changed its content");
}

/// A name out of a list names one file in one folder, and can be asked for.
void isPlainName(const FileName &name)
{
    const auto again = FileName::create(name.bytes());
    require(again && *again == name && !name.bytes().contains('/'), "a listed name is none");
    const QByteArray datagram = encodeFileRequest(saveFile(name), 1);
    const auto request = parseClientPacket(datagram);
    require(request && request->payload == name.bytes(), "a name cannot be asked for");
}

/// Each line that is not empty is the next name or the next rejected one.
bool isMadeOf(QByteArrayView content, const FileList &list)
{
    qsizetype names = 0;
    qsizetype rejected = 0;
    while (!content.isEmpty()) {
        const qsizetype found = content.indexOf('\n');
        auto line = found < 0 ? content : content.first(found);
        content = found < 0 ? QByteArrayView {} : content.sliced(found + 1);
        if (line.endsWith('\r'))
            line.chop(1);
        if (line.isEmpty())
            continue;
        if (names < list.names.size() && list.names[names].bytes() == line)
            ++names;
        else if (rejected < list.rejected.size() && list.rejected[rejected] == line)
            ++rejected;
        else
            return false;
    }
    return names == list.names.size() && rejected == list.rejected.size();
}

/// A text with the mark of a byte: on its way out that byte may join with what follows it.
bool hasMarks(const QString &text) { return text.contains(u'\u27E8'); }

/// Bytes become a text, and that becomes bytes that mean the same.
void comesBack(const TextCodec &codec, QByteArrayView bytes)
{
    const QString decoded = codec.decode(bytes);
    require(decoded.isEmpty() == bytes.isEmpty(), "a text was dropped");
    const auto encoded = codec.encode(decoded);
    require(encoded.has_value(), "a text that came cannot be sent");
    require(hasMarks(decoded) || codec.decode(*encoded) == decoded, "a text changed on the way back");
}

void isFitted(const TextCodec &codec, QByteArrayView bytes, qsizetype size)
{
    const auto fitted = codec.fit(bytes, size);
    require(fitted.size() <= size && bytes.startsWith(fitted), "fit() is no start of the text");
    require(codec.decode(bytes).startsWith(codec.decode(fitted)), "fit() cut a character");
}

/// A typed text becomes bytes that mean the same, or none.
void goesOut(const TextCodec &codec, const QString &typed)
{
    if (const auto encoded = codec.encode(typed))
        require(hasMarks(typed) || codec.decode(*encoded) == typed, "a text changed on the way out");
}

/// What is read as a job is one: a name, NOP first, END last, and labels on lines of it.
void isRead(const QByteArray &job)
{
    using namespace virtualcontroller;
    const auto program = parseProgram(job);
    if (!program) {
        require(program.error() != 0, "a refusal without a reason");
        return;
    }
    const auto &lines = program->lines;
    const int count = int(lines.size());
    require(isJobName(program->name), "a job without a name");
    require(count >= 2 && lines.front().word() == "NOP" && lines.back().word() == "END", "a job without NOP and END");
    require(std::ranges::all_of(program->labels, [&](const auto &label) { return lines[label.second].isLabel(); }),
        "a label is elsewhere");
    require(program->stepAt(count) == program->stepAt(count - 1) && program->stepAt(count) <= count, "too many steps");
}

/// Any bytes taken for a job come back as they were, and a comparison with itself finds nothing.
void isKept(const QByteArray &content)
{
    const files::Job job = files::parseJob(content);
    require(print(job) == content, "a job lost bytes");
    require(diffJobs(job, job, {}).isEmpty(), "a job differs from itself");
    require(std::ranges::all_of(job.instructions, [&](int line) { return line < job.lines.size(); }),
        "an instruction is nowhere");
    (void)job.labels();
    (void)job.calls();
    (void)files::preflight(*FileName::create("A.JBI"), content);
}

/// What a manifest says is what was written, to the byte.
void isManifest(const QByteArray &text)
{
    if (const auto manifest = files::manifestFrom(text))
        require(files::toText(*manifest) == text, "a manifest is not as it was written");
    (void)files::bagInfoFrom(text);
}

/// A running controller refuses a file or has it afterwards, and nothing else has changed.
void isLoaded(QByteArrayView file)
{
    using namespace virtualcontroller;
    static const Memory original = Memory::demo();
    static Memory memory = original;
    const qsizetype end = std::max<qsizetype>(file.indexOf('\n'), 0);
    const QByteArray name = file.first(end).toByteArray();
    const QByteArray contents = file.sliced(std::min(end + 1, file.size())).toByteArray();
    if (filestore::loadRefusal(memory, name) || filestore::load(memory, name, contents))
        return require(memory.files.size() == original.files.size(), "a refused file was kept");
    const auto kept = std::ranges::count_if(memory.files, [&](const auto &entry) { return entry.second == contents; });
    require(kept >= 1 && memory.files.size() <= original.files.size() + 1, "a file was lost");
    memory.files = original.files;
}

} // namespace

void packet(QByteArrayView data)
{
    const auto client = parseClientPacket(data);
    const auto reply = parseReply(data);
    require(client.has_value() == (checkFrame(data) == FrameFault::None), "a faulty frame was parsed");
    if (client) {
        const QByteArray encoded = encode(client->request(), client->framing);
        const auto again = parseClientPacket(encoded);
        require(again && again->request() == client->request() && again->framing == client->framing,
            "a request changed on the way");
    }
    if (reply) {
        const QByteArray encoded = encode(*reply);
        const auto again = parseReply(encoded);
        require(again && again->framing == reply->framing && again->addedStatus == reply->addedStatus
                && again->payload == reply->payload,
            "a reply changed on the way");
    }
    Decoder decoder;
    const DecodedPacket decoded = decoder.decode(data);
    require(client.has_value() || decoded.isMalformed(), "a faulty frame was decoded");
}

void payload(QByteArrayView data)
{
    static const TextCodec codec {Encoding::ShiftJis};
    Source source {data};
    const quint8 chosen = source.byte();
    const quint8 service = source.byte();
    const quint8 attribute = source.byte();
    const auto instance = quint16(source.byte() | source.byte() << 8);
    const quint8 trial = source.byte();
    const auto bytes = source.rest();
    const Command &command = commands()[chosen % commands().size()];
    const Request request {
        command.number, instance, attribute, command.services[service % command.services.size()], bytes.toByteArray()};
    switch (trial % 5) {
    case 0: (void)requestFields(request, codec); break;
    case 1: (void)replyFields(request, bytes, codec); break;
    case 2: judges(request, dialect(allModels[service % allModels.size()])); break;
    case 3: valueRoundTrips[chosen % valueRoundTrips.size()](bytes, attribute % 16); break;
    default: itemRoundTrips[chosen % itemRoundTrips.size()](bytes, attribute);
    }
}

void fileBlocks(QByteArrayView data)
{
    Source source {data};
    if (source.byte() % 2)
        collectsBlocks(source);
    else
        loadsBlocks(source);
}

void fileList(QByteArrayView data)
{
    const FileList list = parseFileList(data.toByteArray());
    for (const auto &name : list.names)
        isPlainName(name);
    require(isMadeOf(data, list), "lines of a list were lost or made up");
}

void text(QByteArrayView data)
{
    Source source {data};
    const TextCodec codec {source.choose(encodings()).encoding};
    const quint8 direction = source.byte();
    const qsizetype size = source.byte();
    switch (direction % 3) {
    case 0: comesBack(codec, source.rest()); break;
    case 1: isFitted(codec, source.rest(), size); break;
    default: goesOut(codec, QString::fromUtf8(source.rest()));
    }
}

void inform(QByteArrayView data)
{
    Source source {data};
    switch (source.byte() % 4) {
    case 0: return isRead(source.rest().toByteArray());
    case 1: return isLoaded(source.rest());
    case 2: return isKept(source.rest().toByteArray());
    default: return isManifest(source.rest().toByteArray());
    }
}

void cellFile(QByteArrayView data)
{
    Source source {data};
    const cellfiles::FileType &type = source.choose(cellfiles::fileTypes());
    const TextCodec codec {source.choose(encodings()).encoding};
    const bool isCompared = source.byte() % 2 != 0;
    const QByteArray name = QByteArray {type.pattern}.replace('*', "X");
    const QByteArray file = source.rest().toByteArray();
    if (isCompared) {
        const auto found = cell::statementsOf(name, {file.first(file.size() / 2), file}, {}, codec);
        return require(found.size() <= cell::mostStatements, "a comparison without a bound");
    }
    const qsizetype lines = file.count('\n') + 1;
    for (const cellfiles::Table &table : cellfiles::viewOf(name, file, codec).tables) {
        for (const cellfiles::Row &row : table.rows) {
            require(row.line >= 0 && row.line <= lines, "a row from a line that is not there");
            require(row.cells.size() <= table.columns.size(), "more cells than columns");
        }
    }
}

} // namespace fuzz
