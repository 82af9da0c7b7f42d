#include "simulators/usb/usb_server.h"

#include <sys/socket.h>

#include <algorithm>
#include <cerrno>

namespace foverig::usb {

UsbServer::UsbServer(FileHandle socket, UsbFunction& function, const Clock& clock)
    : socket_(std::move(socket)), clock_(clock), control_(function), thread_([this] { serve(); }) {}

UsbServer::~UsbServer() {
    ::shutdown(socket_.get(), SHUT_RDWR);
    thread_.join();
}

bool UsbServer::read_exactly(std::span<std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t got = ::recv(socket_.get(), bytes.data(), bytes.size(), 0);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return false;
        bytes = bytes.subspan(static_cast<std::size_t>(got));
    }
    return true;
}

void UsbServer::serve() {
    std::array<std::byte, kHeaderSize> header;
    std::vector<std::byte> data;
    while (read_exactly(header)) {
        const auto command = decode_command(header);
        if (!command) break;
        data.resize(data_size(*command));
        if (!read_exactly(data)) break;
        if (const auto* submit = std::get_if<Submit>(&*command)) {
            handle(*submit, data);
        } else {
            handle(std::get<Unlink>(*command));
        }
    }
    connected_ = false;
    ::shutdown(socket_.get(), SHUT_RDWR);
}

void UsbServer::handle(const Submit& submit, Bytes data) {
    if (submit.endpoint == 0) return control(submit, data);
    const std::lock_guard lock(mutex_);
    // None of our devices has an OUT endpoint beside endpoint 0.
    if (!submit.to_host) return write(encode_submitted(submit, kStalled, 0, {}));
    if (const auto ended = queues_[submit.endpoint].submit(submit, clock_.now())) finish(*ended);
}

void UsbServer::control(const Submit& submit, Bytes data) {
    const Setup& setup = submit.setup;
    if (setup.to_host()) {
        auto answer = control_.answer(setup);
        if (answer && answer->size() > submit.length) answer->resize(submit.length);
        const std::lock_guard lock(mutex_);
        if (!answer) return write(encode_submitted(submit, kStalled, 0, {}));
        return write(encode_submitted(submit, kGood, answer->size(), *answer));
    }
    const bool taken = control_.take(setup, data);
    const std::lock_guard lock(mutex_);
    write(encode_submitted(submit, taken ? kGood : kStalled, taken ? data.size() : 0, {}));
}

void UsbServer::handle(const Unlink& unlink) {
    const std::lock_guard lock(mutex_);
    const bool waited = std::any_of(queues_.begin(), queues_.end(), [&](auto& queue) {
        return queue.second.unlink(unlink.victim);
    });
    write(encode_unlinked(unlink.sequence, waited ? kUnlinked : kGood));
}

void UsbServer::send(std::uint8_t endpoint, std::vector<std::byte> packet) {
    const std::lock_guard lock(mutex_);
    if (const auto ended = queues_[endpoint].push(std::move(packet), clock_.now())) finish(*ended);
}

std::uint64_t UsbServer::unheard() const {
    const std::lock_guard lock(mutex_);
    std::uint64_t sum = 0;
    for (const auto& [endpoint, queue] : queues_) sum += queue.unheard();
    return sum;
}

void UsbServer::finish(const InQueue::Ended& ended) {
    write(encode_submitted(ended.submit, ended.status, ended.data.size(), ended.data));
}

/// A host that has hung up is noticed by the thread that reads.
void UsbServer::write(Bytes message) {
    while (!message.empty()) {
        const ssize_t sent = ::send(socket_.get(), message.data(), message.size(), MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR) continue;
        if (sent <= 0) return;
        message = message.subspan(static_cast<std::size_t>(sent));
    }
}

}  // namespace foverig::usb
