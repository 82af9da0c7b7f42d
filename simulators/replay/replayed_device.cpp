#include "simulators/replay/replayed_device.h"

#include <algorithm>

#include "devices/recording/device_topics.h"

namespace foverig {
namespace {

constexpr std::size_t kKeptExchanges = 256;

std::set<std::uint16_t> channels_of(const Recording& recording, const std::string& device) {
    std::set<std::uint16_t> ids;
    for (const mcap::Channel& channel : recording.summary().channels) {
        if (channel.topic == raw_topic(device) || channel.topic == control_topic(device)) {
            ids.insert(channel.id);
        }
    }
    return ids;
}

}  // namespace

ReplayedDevice::ReplayedDevice(const Recording& recording, const std::string& device, Clock& clock,
                               const Settings& settings)
    : file_(recording.file()),
      clock_(clock),
      settings_(settings),
      raw_channel_(recording.summary().channel(raw_topic(device))->id),
      messages_(*file_, recording.summary().chunks, channels_of(recording, device)),
      period_(recording.round()),
      round_begin_(recording.first()) {}

bool ReplayedDevice::is_out(HostTime now) const {
    return unplugged_ && (unplugged_->since >= round_begin_ || now < round_begin_);
}

/// Until something is ahead that `next` can give, or nothing ever will be.
void ReplayedDevice::read_ahead() {
    while (!ahead_ && !at_end_) {
        const auto message = messages_.next();
        if (!message) {
            damage_ = message.error();
            at_end_ = true;
        } else if (message->has_value()) {
            take_message(**message);
        } else if (settings_.loop && packets_in_round_) {
            messages_.rewind();
            shift_ += period_;
            round_begin_ += period_;
            packets_in_round_ = false;
        } else {
            at_end_ = true;
        }
    }
}

void ReplayedDevice::take_message(const mcap::Message& message) {
    const HostTime time = recorded_time(message.log_time_ns) + shift_;
    if (message.channel == raw_channel_) {
        ahead_ = Item{time, Packet{time, to_vector(message.data)}};
        packets_in_round_ = true;
        return;
    }
    auto exchange = ControlExchange::decode(message.data);
    if (!exchange) {
        damage_ = Error{ErrorCode::invalid_data, file_->name() + ": " + exchange.error().text};
        at_end_ = true;
    } else if (exchange->kind == ControlExchange::Kind::fault) {
        const Error error{exchange->error.value_or(ErrorCode::closed), exchange->text()};
        ahead_ = Item{time, Fault{error}};
    } else if (exchange->kind == ControlExchange::Kind::get) {
        exchanges_.push_back({.time = time, .what = std::move(exchange).value()});
        if (exchanges_.size() > kKeptExchanges) exchanges_.pop_front();
    }
}

NextPacket ReplayedDevice::next(HostTime deadline) {
    while (true) {
        read_ahead();
        const HostTime now = std::min(clock_.now(), deadline);
        if (ahead_ && ahead_->time <= now) {
            const HostTime time = ahead_->time;
            auto what = std::move(ahead_->what);
            ahead_.reset();
            if (auto* packet = std::get_if<Packet>(&what)) {
                unplugged_.reset();
                return std::move(*packet);
            }
            unplugged_ = {time, std::get<Fault>(what).error};
            return Fault{unplugged_->error};
        }
        if (damage_ && at_end_ && !ahead_) return Fault{*damage_};
        if (is_out(now)) return Fault{unplugged_->error};
        if (at_end_ && !ahead_) return EndOfStream{};
        if (now >= deadline) return Timeout{};
        clock_.sleep_until(std::min(deadline, ahead_->time));
    }
}

Status ReplayedDevice::control_set(std::uint8_t, std::uint16_t, std::span<const std::byte>) {
    if (is_out(clock_.now())) return unplugged_->error;
    return Done{};
}

Result<std::vector<std::byte>> ReplayedDevice::control_get(std::uint8_t id, std::uint16_t value,
                                                           std::size_t size) {
    read_ahead();
    const bool momentary = settings_.momentary_request == id;
    const auto answers = [&](const Exchange& e) {
        return e.what.id == id && e.what.value == value && e.what.asked_size == size &&
               (!momentary || e.time == clock_.now());
    };
    auto found = std::find_if(exchanges_.rbegin(), exchanges_.rend(), answers);
    const auto& successive = settings_.successive_requests;
    if (std::find(successive.begin(), successive.end(), id) != successive.end()) {
        const auto next = std::find_if(exchanges_.begin(), exchanges_.end(),
                                       [&](const Exchange& e) { return !e.given && answers(e); });
        if (next != exchanges_.end()) {
            next->given = true;
            found = std::make_reverse_iterator(next + 1);
        }
    }
    if (found == exchanges_.rend()) {
        return Error{ErrorCode::unsupported, "the recording has no answer to this request"};
    }
    if (found->what.error) return Error{*found->what.error, found->what.text()};
    return found->what.data;
}

}  // namespace foverig
