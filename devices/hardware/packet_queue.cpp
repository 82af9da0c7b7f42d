#include "devices/hardware/packet_queue.h"

#include <utility>

namespace foverig::hardware {

void PacketQueue::push(Bytes packet, Bytes rest) {
    const HostTime arrival = clock_.now();
    BytePool::Held bytes = pool_.copy_of(packet, rest);
    {
        const std::lock_guard lock(mutex_);
        add(Packet{arrival, std::move(bytes)});
    }
    // Whoever waits finds the lock free when woken.
    news_.notify_one();
}

void PacketQueue::lost(const Error& why) {
    {
        const std::lock_guard lock(mutex_);
        if (!gone_) add(Fault{why});
        gone_ = why;
    }
    news_.notify_one();
}

void PacketQueue::add(Item item) {
    items_.push_back(std::move(item));
    if (items_.size() <= capacity_) return;
    Item oldest = items_.pop_front();
    if (auto* fault = std::get_if<Fault>(&oldest)) untold_ = std::move(*fault);
}

void PacketQueue::found() {
    const std::lock_guard lock(mutex_);
    gone_.reset();
}

std::optional<NextPacket> PacketQueue::take(HostTime deadline) {
    if (untold_) return *std::exchange(untold_, std::nullopt);
    if (items_.empty()) {
        if (gone_) return Fault{*gone_};
        return std::nullopt;
    }
    if (const auto* packet = std::get_if<Packet>(&items_.front());
        packet != nullptr && packet->arrival > deadline) {
        return Timeout{};
    }
    auto item = items_.pop_front();
    if (auto* packet = std::get_if<Packet>(&item)) return std::move(*packet);
    return std::get<Fault>(std::move(item));
}

NextPacket PacketQueue::next(HostTime deadline) {
    std::unique_lock lock(mutex_);
    while (true) {
        if (auto taken = take(deadline)) return std::move(*taken);
        const HostTime now = clock_.now();
        if (now >= deadline) return Timeout{};
        news_.wait_for(lock, deadline - now);
    }
}

}  // namespace foverig::hardware
