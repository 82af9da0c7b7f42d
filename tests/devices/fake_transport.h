#pragma once
// A transport fed by hand: packets with arrival times, scripted answers, a log of what was set.
#include <deque>
#include <functional>
#include <map>

#include "devices/transport.h"

namespace foverig::test {

class FakeTransport final : public Transport {
  public:
    struct SetCall {
        std::uint8_t id;
        std::uint16_t value;
        std::vector<std::byte> data;
    };

    std::deque<Packet> packets;
    std::map<std::uint8_t, std::vector<std::byte>> answers;
    std::function<Result<std::vector<std::byte>>(std::uint8_t, std::uint16_t)>
        answer_by;  ///< tried first
    std::vector<SetCall> sets;
    struct KeepAwake {
        std::uint8_t id;
        std::vector<std::byte> data;
        Nanoseconds period;
    };
    std::vector<KeepAwake> keep_awakes;
    std::vector<HostTime> deadlines;
    std::optional<Error> fault_at_end;
    bool end_at_end = false;
    bool refuse_sets = false;
    ErrorCode refusal = ErrorCode::io;

    template <class Container>
    void push(HostTime arrival, const Container& bytes) {
        packets.push_back({arrival, std::vector<std::byte>(bytes.begin(), bytes.end())});
    }

    NextPacket next(HostTime deadline) override {
        deadlines.push_back(deadline);
        if (packets.empty()) {
            if (fault_at_end) return Fault{*fault_at_end};
            if (end_at_end) return EndOfStream{};
            return Timeout{};
        }
        if (packets.front().arrival > deadline) return Timeout{};
        Packet packet = std::move(packets.front());
        packets.pop_front();
        return packet;
    }

    Status control_set(std::uint8_t id, std::uint16_t value,
                       std::span<const std::byte> data) override {
        sets.push_back({id, value, {data.begin(), data.end()}});
        if (refuse_sets) return Error{refusal, "refused by the test"};
        return Done{};
    }

    Result<std::vector<std::byte>> control_get(std::uint8_t id, std::uint16_t value,
                                               std::size_t size) override {
        if (answer_by) return answer_by(id, value);
        const auto found = answers.find(id);
        if (found == answers.end()) return Error{ErrorCode::unsupported, "no answer scripted"};
        if (found->second.size() != size) return Error{ErrorCode::io, "asked with the wrong size"};
        return found->second;
    }

    void keep_awake(std::uint8_t id, std::span<const std::byte> data, Nanoseconds period) override {
        keep_awakes.push_back({id, {data.begin(), data.end()}, period});
    }

    int sets_of(std::uint8_t id) const {
        int n = 0;
        for (const SetCall& call : sets) n += call.id == id;
        return n;
    }
};

}  // namespace foverig::test
