#include "rig/session/watched_transport.h"

#include <fmt/format.h>

namespace foverig {
namespace {

double seconds_of(HostTime time) {
    return to_seconds(time.time_since_epoch());
}

}  // namespace

NextPacket WatchedTransport::next(HostTime deadline) {
    NextPacket got = device_.next(deadline);
    const bool gone = !outages_.empty() && !outages_.back().back;
    if (const auto* packet = std::get_if<Packet>(&got); packet != nullptr && gone) {
        back(packet->arrival);
    } else if (const auto* fault = std::get_if<Fault>(&got); fault != nullptr && !gone) {
        lost(fault->error);
    }
    return got;
}

void WatchedTransport::lost(const Error& why) {
    const HostTime now = clock_.now();
    outages_.push_back({.lost = now, .back = {}, .why = why.text});
    if (!notice_) return;
    notice_(fmt::format("{} is lost at {:.2f} s ({}); {} until it is back", name_, seconds_of(now),
                        why.text, meanwhile_));
}

void WatchedTransport::back(HostTime arrival) {
    Outage& outage = outages_.back();
    outage.back = arrival;
    if (!notice_) return;
    notice_(fmt::format("{} is back at {:.2f} s, after {:.2f} s", name_, seconds_of(arrival),
                        to_seconds(arrival - outage.lost)));
}

}  // namespace foverig
