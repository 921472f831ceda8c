// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QtGlobal>
#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <netinet/in.h>
#include <poll.h>
#include <queue>
#include <sys/socket.h>
#include <thread>
#include <unistd.h>
#include <vector>

/// The other end of every benchmark: a bare POSIX loop in a thread of its own that answers each request after a fixed
/// delay with a payload of the right size. It knows only as much of HSES as that takes. Also the bare client to compare
/// with.
namespace bare {

using Clock = std::chrono::steady_clock;
using Packet = std::array<unsigned char, 512>;

constexpr int headerSize = 32;

inline unsigned load16(const unsigned char *at) { return at[0] | unsigned(at[1]) << 8; }
inline unsigned load32(const unsigned char *at) { return load16(at) | load16(at + 2) << 16; }
inline void store16(unsigned char *at, unsigned value)
{
    at[0] = static_cast<unsigned char>(value);
    at[1] = static_cast<unsigned char>(value >> 8);
}
inline void store32(unsigned char *at, unsigned value)
{
    store16(at, value & 0xFFFF);
    store16(at + 2, value >> 16);
}

inline sockaddr_in loopback(unsigned port)
{
    sockaddr_in address {};
    address.sin_family = AF_INET;
    address.sin_port = htons(quint16(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    return address;
}

/// A UDP socket on a free loopback port.
inline int openSocket(unsigned *port = nullptr)
{
    const int fd = ::socket(AF_INET, SOCK_DGRAM, 0);
    sockaddr_in address = loopback(0);
    if (::bind(fd, reinterpret_cast<sockaddr *>(&address), sizeof address) != 0)
        std::abort();
    if (port) {
        socklen_t size = sizeof address;
        ::getsockname(fd, reinterpret_cast<sockaddr *>(&address), &size);
        *port = ntohs(address.sin_port);
    }
    return fd;
}

/// A header as a client sends it (reference §1.1).
inline int writeHeader(unsigned char *packet, int division, int ack, int id, unsigned block, int payload)
{
    std::copy_n("YERC", 4, packet);
    store16(packet + 4, headerSize);
    store16(packet + 6, unsigned(payload));
    packet[8] = 3;
    packet[9] = static_cast<unsigned char>(division);
    packet[10] = static_cast<unsigned char>(ack);
    packet[11] = static_cast<unsigned char>(id);
    store32(packet + 12, block);
    std::memset(packet + 16, '9', 8);
    std::memset(packet + 24, 0, 8);
    return headerSize + payload;
}

class Server
{
public:
    /// Answers on `count` ports of its own. `loss` of a thousand answers are dropped, evenly spread.
    Server(int count, std::chrono::microseconds delay, int lossPerMille = 0)
        : m_delay {delay}, m_loss {lossPerMille}, m_ports(std::size_t(count))
    {
        for (unsigned &port : m_ports)
            m_polls.push_back({openSocket(&port), POLLIN, 0});
        m_thread = std::thread {[this] { run(); }};
    }
    ~Server()
    {
        m_stop = true;
        m_thread.join();
        for (const pollfd &poll : m_polls)
            ::close(poll.fd);
    }
    Server(const Server &) = delete;
    Server &operator=(const Server &) = delete;

    [[nodiscard]] unsigned port(int index = 0) const { return m_ports[std::size_t(index)]; }
    [[nodiscard]] long requests() const { return m_requests; }
    /// What a download of any name returns, and a list of jobs; set before the first request.
    std::vector<unsigned char> file;
    std::vector<unsigned char> list;

private:
    struct Due {
        Clock::time_point at;
        int fd;
        sockaddr_in peer;
        int size;
        Packet packet;
        bool operator<(const Due &other) const { return at > other.at; }
    };

    void run()
    {
        while (!m_stop) {
            sendDue();
            timespec wait {0, 20'000'000};
            if (!m_due.empty()) {
                const auto left = std::max(m_due.top().at - Clock::now(), Clock::duration::zero());
                wait.tv_nsec = std::min<long>(20'000'000, std::chrono::nanoseconds {left}.count());
            }
            if (::ppoll(m_polls.data(), m_polls.size(), &wait, nullptr) <= 0)
                continue;
            for (const pollfd &poll : m_polls) {
                if (poll.revents & POLLIN)
                    receive(poll.fd);
            }
        }
    }

    void receive(int fd)
    {
        Due due {};
        socklen_t size = sizeof due.peer;
        const auto got = ::recvfrom(
            fd, due.packet.data(), due.packet.size(), MSG_DONTWAIT, reinterpret_cast<sockaddr *>(&due.peer), &size);
        if (got < headerSize)
            return;
        ++m_requests;
        due.fd = fd;
        due.at = Clock::now() + m_delay;
        due.size = answer(due.packet);
        if (due.size == 0 || (m_loss > 0 && (m_requests * m_loss) % 1000 < m_loss))
            return;
        if (m_delay.count() == 0)
            send(due);
        else
            m_due.push(due);
    }

    void sendDue()
    {
        while (!m_due.empty() && m_due.top().at <= Clock::now()) {
            send(m_due.top());
            m_due.pop();
        }
    }
    static void send(const Due &due)
    {
        ::sendto(due.fd, due.packet.data(), size_t(due.size), 0, reinterpret_cast<const sockaddr *>(&due.peer),
            sizeof due.peer);
    }

    /// Turns a request into its answer, in place; returns the size, 0 for none.
    int answer(Packet &packet)
    {
        const bool isFile = packet[9] == 2;
        const unsigned command = load16(&packet[24]);
        const unsigned service = packet[29];
        const unsigned block = load32(&packet[12]);
        const unsigned count = load32(&packet[32]);
        const bool isAck = packet[10] == 1;
        int payload = 0;
        unsigned replyBlock = 0x80000000U;
        if (!isFile) {
            payload = payloadSize(command, count);
            std::memset(&packet[32], 0, packet.size() - 32);
            if (command >= 0x300)
                store32(&packet[32], count);
        } else if (service == 0x15) {
            replyBlock = isAck ? block : 0;
        } else {
            if (isAck && (block & 0x80000000U))
                return 0;
            const unsigned next = isAck ? block + 1 : 1;
            const std::size_t from = std::size_t(next - 1) * 479;
            const std::vector<unsigned char> &content = contentFor(service, !isAck && packet[34] != 'J');
            payload = int(std::min<std::size_t>(479, content.size() - from));
            std::memcpy(&packet[32], content.data() + from, size_t(payload));
            replyBlock = next | (from + 479 >= content.size() ? 0x80000000U : 0);
        }
        store16(&packet[6], unsigned(payload));
        packet[10] = 1;
        store32(&packet[12], replyBlock);
        std::memset(&packet[24], 0, 8);
        packet[24] = static_cast<unsigned char>(service + 0x80);
        return headerSize + payload;
    }

    const std::vector<unsigned char> &contentFor(unsigned service, bool isOfAnotherType) const
    {
        static const std::vector<unsigned char> nothing;
        if (service != 0x32)
            return file;
        return isOfAnotherType ? nothing : list;
    }

    static int payloadSize(unsigned command, unsigned count)
    {
        switch (command) {
        case 0x70: return 60;
        case 0x72: return 8;
        case 0x73:
        case 0x75: return 44;
        case 0x77: return 24;
        case 0x7A: return 1;
        case 0x7B: return 2;
        case 0x7C:
        case 0x7D: return 4;
        case 0x8C: return 32;
        case 0x7F: return 52;
        case 0x300:
        case 0x302: return int(4 + count);
        case 0x303: return int(4 + 2 * count);
        case 0x304:
        case 0x305: return int(4 + 4 * count);
        case 0x30C: return int(4 + 32 * count);
        case 0x307: return int(4 + 52 * count);
        default: return 0;
        }
    }

    std::chrono::microseconds m_delay;
    long m_loss;
    std::vector<unsigned> m_ports;
    std::vector<pollfd> m_polls;
    std::priority_queue<Due> m_due;
    std::atomic<bool> m_stop = false;
    std::atomic<long> m_requests = 0;
    std::thread m_thread;
};

/// The bare client: one blocking round trip.
class Client
{
public:
    explicit Client(unsigned port) : m_fd {openSocket()}
    {
        const sockaddr_in peer = loopback(port);
        if (::connect(m_fd, reinterpret_cast<const sockaddr *>(&peer), sizeof peer) != 0)
            std::abort();
    }
    ~Client() { ::close(m_fd); }
    Client(const Client &) = delete;
    Client &operator=(const Client &) = delete;

    /// Asks for a robot command and waits for the answer.
    void ask(unsigned command, unsigned instance, unsigned service, unsigned count = 0)
    {
        Packet packet;
        const int size = writeHeader(packet.data(), 1, 0, m_id++, 0, count > 0 ? 4 : 0);
        store16(&packet[24], command);
        store16(&packet[26], instance);
        packet[29] = static_cast<unsigned char>(service);
        store32(&packet[32], count);
        ::send(m_fd, packet.data(), size_t(size), 0);
        ::recv(m_fd, packet.data(), packet.size(), 0);
    }

    /// Downloads a file: request, then a block for each acknowledgement.
    std::vector<unsigned char> get()
    {
        std::vector<unsigned char> content;
        Packet packet;
        int size = writeHeader(packet.data(), 2, 0, m_id, 0, 5);
        packet[29] = 0x16;
        std::memcpy(&packet[32], "A.JBI", 5);
        while (true) {
            ::send(m_fd, packet.data(), size_t(size), 0);
            const auto got = ::recv(m_fd, packet.data(), packet.size(), 0);
            content.insert(content.end(), packet.begin() + 32, packet.begin() + got);
            const unsigned block = load32(&packet[12]);
            size = writeHeader(packet.data(), 2, 1, m_id, block, 0);
            packet[29] = 0x16;
            if (block & 0x80000000U)
                break;
        }
        ::send(m_fd, packet.data(), size_t(size), 0);
        ++m_id;
        return content;
    }

    /// Uploads a file in blocks of 479 bytes.
    void put(const std::vector<unsigned char> &content)
    {
        Packet packet;
        int size = writeHeader(packet.data(), 2, 0, m_id, 0, 5);
        packet[29] = 0x15;
        std::memcpy(&packet[32], "A.JBI", 5);
        ::send(m_fd, packet.data(), size_t(size), 0);
        ::recv(m_fd, packet.data(), packet.size(), 0);
        unsigned block = 1;
        for (std::size_t from = 0; from < content.size(); from += 479, ++block) {
            const int payload = int(std::min<std::size_t>(479, content.size() - from));
            const bool isLast = from + 479 >= content.size();
            size = writeHeader(packet.data(), 2, 1, m_id, block | (isLast ? 0x80000000U : 0), payload);
            packet[29] = 0x15;
            std::memcpy(&packet[32], content.data() + from, size_t(payload));
            ::send(m_fd, packet.data(), size_t(size), 0);
            ::recv(m_fd, packet.data(), packet.size(), 0);
        }
        ++m_id;
    }

private:
    int m_fd;
    int m_id = 0;
};

} // namespace bare
