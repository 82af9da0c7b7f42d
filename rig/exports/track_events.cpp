#include "rig/exports/track_events.h"

namespace foverig::exports {
namespace {

namespace trace {
constexpr std::uint32_t kPacket = 1;
}
namespace packet_field {
constexpr std::uint32_t kTimestamp = 8, kSequence = 10, kEvent = 11, kSequenceFlags = 13,
                        kDescriptor = 60;
}
namespace descriptor_field {
constexpr std::uint32_t kUuid = 1, kName = 2, kParent = 5, kCounter = 8;
}
namespace counter_field {
constexpr std::uint32_t kUnitName = 6;
}
namespace event_field {
constexpr std::uint32_t kAnnotation = 4, kType = 9, kTrack = 11, kName = 23, kDoubleCounter = 44,
                        kFlow = 47, kEndingFlow = 48, kCorrelation = 52;
}
namespace annotation_field {
constexpr std::uint32_t kDouble = 5, kName = 10;
}

enum EventType : std::uint64_t { kBegin = 1, kEnd = 2, kInstant = 3, kCounterValue = 4 };

constexpr std::uint64_t kOurSequence = 1, kNothingFromBefore = 1;

ProtobufMessage event_of(EventType type, Track track) {
    ProtobufMessage event;
    event.varint(event_field::kType, type).varint(event_field::kTrack, track);
    return event;
}

}  // namespace

TrackEvents::TrackEvents(const std::string& name) {
    describe({}, name);
}

Track TrackEvents::describe(ProtobufMessage descriptor, const std::string& name) {
    const Track track = ++tracks_;
    descriptor.varint(descriptor_field::kUuid, track).text(descriptor_field::kName, name);
    if (track > 1) descriptor.varint(descriptor_field::kParent, 1);
    ProtobufMessage packet;
    packet.varint(packet_field::kSequence, kOurSequence);
    if (track == 1) packet.varint(packet_field::kSequenceFlags, kNothingFromBefore);
    packet.message(packet_field::kDescriptor, descriptor);
    trace_.message(trace::kPacket, packet);
    return track;
}

Track TrackEvents::add_track(const std::string& name) {
    return describe({}, name);
}

Track TrackEvents::add_counter(const std::string& name, const std::string& unit) {
    ProtobufMessage counter, descriptor;
    if (!unit.empty()) counter.text(counter_field::kUnitName, unit);
    descriptor.message(descriptor_field::kCounter, counter);
    return describe(std::move(descriptor), name);
}

void TrackEvents::packet(std::int64_t at_ns, const ProtobufMessage& event) {
    ProtobufMessage packet;
    packet.varint(packet_field::kTimestamp, static_cast<std::uint64_t>(at_ns))
        .varint(packet_field::kSequence, kOurSequence)
        .message(packet_field::kEvent, event);
    trace_.message(trace::kPacket, packet);
}

void TrackEvents::add(const Slice& slice) {
    const bool instant = slice.begin_ns == slice.end_ns;
    ProtobufMessage event = event_of(instant ? kInstant : kBegin, slice.track);
    event.text(event_field::kName, slice.name).varint(event_field::kCorrelation, slice.frame);
    for (const std::uint64_t flow : slice.flows) event.fixed64(event_field::kFlow, flow);
    for (const std::uint64_t flow : slice.ending_flows)
        event.fixed64(event_field::kEndingFlow, flow);
    for (const Annotation& annotation : slice.annotations) {
        ProtobufMessage told;
        told.text(annotation_field::kName, annotation.name)
            .number(annotation_field::kDouble, annotation.value);
        event.message(event_field::kAnnotation, told);
    }
    packet(slice.begin_ns, event);
    if (!instant) packet(slice.end_ns, event_of(kEnd, slice.track));
}

void TrackEvents::count(Track counter, std::int64_t at_ns, double value) {
    ProtobufMessage event = event_of(kCounterValue, counter);
    packet(at_ns, event.number(event_field::kDoubleCounter, value));
}

}  // namespace foverig::exports
