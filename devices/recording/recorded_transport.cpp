#include "devices/recording/recorded_transport.h"

namespace foverig {
namespace {

void refuse(ControlExchange& exchange, const Error& error) {
    exchange.error = error.code;
    exchange.data = to_vector(std::as_bytes(std::span(error.text)));
}

mcap::Texts metadata_of(const RecordedDevice& about) {
    mcap::Texts texts{{"device_time", about.device_time},
                      {"log_time", "arrival on the host's clock"}};
    if (!about.origin.empty()) texts.emplace(kDeviceOrigin, about.origin);
    return texts;
}

}  // namespace

RecordedTransport::RecordedTransport(Transport& device, Recorder& recorder, const Clock& clock,
                                     const RecordedDevice& about)
    : device_(device),
      recorder_(recorder),
      clock_(clock),
      raw_(recorder.add_topic({.topic = raw_topic(about.name),
                               .message_encoding = about.packet_encoding,
                               .metadata = metadata_of(about)})),
      control_(recorder.add_topic(
          {.topic = control_topic(about.name), .message_encoding = "x-foverig-control"})) {}

NextPacket RecordedTransport::next(HostTime deadline) {
    NextPacket got = device_.next(deadline);
    if (const auto* packet = std::get_if<Packet>(&got)) {
        recorder_.record(raw_, packet->arrival, packet->arrival, packet->bytes);
        faulty_ = false;
    } else if (const auto* fault = std::get_if<Fault>(&got); fault != nullptr && !faulty_) {
        ControlExchange exchange{.kind = ControlExchange::Kind::fault};
        refuse(exchange, fault->error);
        record(exchange);
        faulty_ = true;
    }
    return got;
}

Status RecordedTransport::control_set(std::uint8_t id, std::uint16_t value,
                                      std::span<const std::byte> data) {
    Status status = device_.control_set(id, value, data);
    ControlExchange exchange{
        .kind = ControlExchange::Kind::set, .id = id, .value = value, .data = to_vector(data)};
    if (!status) refuse(exchange, status.error());
    record(exchange);
    return status;
}

Result<std::vector<std::byte>> RecordedTransport::control_get(std::uint8_t id, std::uint16_t value,
                                                              std::size_t size) {
    auto answer = device_.control_get(id, value, size);
    ControlExchange exchange{.kind = ControlExchange::Kind::get,
                             .id = id,
                             .value = value,
                             .asked_size = static_cast<std::uint32_t>(size)};
    if (answer) {
        exchange.data = *answer;
    } else {
        refuse(exchange, answer.error());
    }
    record(exchange);
    return answer;
}

void RecordedTransport::record(const ControlExchange& exchange) {
    const HostTime now = clock_.now();
    recorder_.record(control_, now, now, exchange.encode());
}

}  // namespace foverig
