#pragma once
// Perfetto's track events, as far as a run needs them (google/perfetto protos/perfetto/trace).
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "rig/exports/protobuf.h"

namespace foverig::exports {

/// Tracks are numbered from 1; 1 is the parent of all.
using Track = std::uint64_t;

/// What is told of an event beside its name.
struct Annotation {
    std::string name;
    double value = 0.0;
};

struct Slice {
    Track track = 0;
    std::string_view name;
    std::int64_t begin_ns = 0, end_ns = 0;
    std::uint64_t frame = 0;                    ///< Perfetto's correlation id
    std::vector<std::uint64_t> flows{};         ///< arrows to other events of the same numbers
    std::vector<std::uint64_t> ending_flows{};  ///< ... that end here
    std::vector<Annotation> annotations{};
};

/// A trace in work; slices of one track must not overlap and come in order.
class TrackEvents {
  public:
    /// All tracks hang below one of that name.
    explicit TrackEvents(const std::string& name);

    Track add_track(const std::string& name);
    Track add_counter(const std::string& name, const std::string& unit);
    /// An instant where it ends when it begins.
    void add(const Slice& slice);
    void count(Track counter, std::int64_t at_ns, double value);

    const std::string& bytes() const { return trace_.bytes(); }

  private:
    Track describe(ProtobufMessage descriptor, const std::string& name);
    void packet(std::int64_t at_ns, const ProtobufMessage& event);

    ProtobufMessage trace_;
    Track tracks_ = 0;
};

}  // namespace foverig::exports
