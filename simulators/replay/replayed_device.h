#pragma once
// A device of a recording: its packets at the times they came, its answers to what was asked of it.
// Speed is the clock's: a ManualClock replays as fast as possible, a WallClock of speed 1 as it
// was.
#include <deque>

#include "devices/recording/control_exchange.h"
#include "devices/recording/message_stream.h"
#include "devices/transport.h"
#include "simulators/replay/recording.h"

namespace foverig {

class ReplayedDevice final : public Transport {
  public:
    struct Settings {
        bool loop = false;  ///< begin again after the last packet; decoders see a device restart
        /// A request whose answer holds only at the instant of asking, as GET_TIME: an answer that
        /// was recorded at another instant is none. Absent: the device has none.
        std::optional<std::uint8_t> momentary_request{};
        /// Requests whose answers differ from one to the next, as of a table that the device walks
        /// through: they are given in their order.
        std::vector<std::uint8_t> successive_requests{};
    };

    /// `device` is one that the recording has; the clock outlives this.
    ReplayedDevice(const Recording& recording, const std::string& device, Clock& clock,
                   const Settings& settings);

    /// EndOfStream after the last packet, Fault while the device was unplugged, and a Fault for
    /// good where the file turns out to be damaged.
    NextPacket next(HostTime deadline) override;
    /// Accepted without effect: what the device did about it is in the recording.
    Status control_set(std::uint8_t id, std::uint16_t value,
                       std::span<const std::byte> data) override;
    /// The newest recorded answer to this very request, or the next of successive ones.
    Result<std::vector<std::byte>> control_get(std::uint8_t id, std::uint16_t value,
                                               std::size_t size) override;

    /// Nothing is left to come.
    bool at_end() const { return at_end_; }
    /// The file turned out to be damaged.
    const std::optional<Error>& damage() const { return damage_; }

  private:
    struct Item {
        HostTime time;
        std::variant<Packet, Fault> what;
    };
    struct Exchange {
        HostTime time;
        ControlExchange what;
        bool given = false;
    };

    struct Unplugged {
        HostTime since;
        Error error;
    };

    /// A new round begins with the device plugged in, however the one before ended.
    bool is_out(HostTime now) const;
    void read_ahead();
    void take_message(const mcap::Message& message);

    std::shared_ptr<const mcap::RecordFile> file_;
    Clock& clock_;
    Settings settings_;
    std::uint16_t raw_channel_;
    mcap::MessageStream messages_;
    Nanoseconds period_;  // of a loop
    HostTime round_begin_;
    Nanoseconds shift_{};  // of the present round
    bool packets_in_round_ = false;
    std::optional<Item> ahead_;
    std::deque<Exchange> exchanges_;  // the newest that were passed
    std::optional<Unplugged> unplugged_;
    std::optional<Error> damage_;
    bool at_end_ = false;
};

}  // namespace foverig
