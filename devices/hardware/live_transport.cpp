#include "devices/hardware/live_transport.h"

#include <pthread.h>

namespace foverig::hardware {
namespace {

/// Not allowed is not an error: `foverig doctor` says what to do about it.
void ask_for_realtime() {
    sched_param priority{};
    priority.sched_priority = kReaderPriority;
    (void)pthread_setschedparam(pthread_self(), SCHED_FIFO, &priority);
}

/// Nothing that a search meets while the kernel takes a device away ends the program.
Result<std::unique_ptr<Link>> try_to_open(const LiveTransport::Open& open_link) {
    try {
        return open_link();
    } catch (const std::exception& problem) {
        return Error{ErrorCode::io,
                     std::string("the device could not be looked for: ") + problem.what()};
    }
}

Error unplugged() {
    return {ErrorCode::closed, "the device is unplugged"};
}

}  // namespace

Result<std::unique_ptr<LiveTransport>> LiveTransport::open(const Clock& clock, Open open_link,
                                                           const Settings& settings) {
    auto link = open_link();
    if (!link) return link.error();
    return std::unique_ptr<LiveTransport>(
        new LiveTransport(clock, std::move(open_link), std::move(link).value(), settings));
}

LiveTransport::LiveTransport(const Clock& clock, Open open_link, std::shared_ptr<Link> link,
                             const Settings& settings)
    : clock_(clock),
      open_link_(std::move(open_link)),
      settings_(settings),
      packets_(clock, settings.queue_capacity),
      link_(std::move(link)),
      reader_([this](const std::stop_token& stop) { read_until_stopped(stop); }) {}

LiveTransport::~LiveTransport() = default;

std::shared_ptr<Link> LiveTransport::link() const {
    const std::lock_guard lock(mutex_);
    return link_;
}

void LiveTransport::set_link(std::shared_ptr<Link> link) {
    const std::lock_guard lock(mutex_);
    link_.swap(link);
    patience_ = {};
    if (link_ && keep_awake_) keep_awake_(*link_);
}

void LiveTransport::read_until_stopped(const std::stop_token& stop) {
    if (settings_.realtime) ask_for_realtime();
    while (!stop.stop_requested()) {
        const auto device = link();
        const Status status = device ? device->read(packets_) : reopen();
        if (status) continue;
        set_link(nullptr);
        packets_.lost(status.error());
        // Also where it can be opened at once: a device that is not well fails again as soon.
        std::unique_lock lock(mutex_);
        stopping_.wait_for(lock, stop, settings_.retry_period, [] { return false; });
    }
}

Status LiveTransport::reopen() {
    auto device = try_to_open(open_link_);
    if (!device) return device.error();
    set_link(std::move(device).value());
    packets_.found();
    return Done{};
}

template <class Request>
auto LiveTransport::ask(Request request) -> decltype(request(std::declval<Link&>())) {
    const HostTime asked = clock_.now();
    const auto device = link();
    if (!device) return unplugged();
    {
        const std::lock_guard lock(mutex_);
        if (const auto spent = patience_.spent(asked)) return *spent;
    }
    auto answer = request(*device);
    const std::lock_guard lock(mutex_);
    if (device != link_) return answer;
    if (answer) {
        patience_.answered();
    } else {
        patience_.failed(asked, clock_.now());
    }
    return answer;
}

Status LiveTransport::control_set(std::uint8_t id, std::uint16_t value,
                                  std::span<const std::byte> data) {
    return ask([&](Link& device) { return device.control_set(id, value, data); });
}

Result<std::vector<std::byte>> LiveTransport::control_get(std::uint8_t id, std::uint16_t value,
                                                          std::size_t size) {
    return ask([&](Link& device) { return device.control_get(id, value, size); });
}

void LiveTransport::keep_awake(std::uint8_t id, std::span<const std::byte> data,
                               Nanoseconds period) {
    const std::lock_guard lock(mutex_);
    keep_awake_ = [id, data = to_vector(data), period](Link& device) {
        device.keep_awake(id, data, period);
    };
    if (link_) keep_awake_(*link_);
}

}  // namespace foverig::hardware
