#pragma once
#include <optional>

#include "devices/camera/frame.h"
#include "devices/source.h"

namespace foverig::camera {

/// Counts a camera's frames by the driver's sequence numbers.
class FrameCount {
  public:
    /// A frame came, or nothing where the header was refused. False: it is of no use.
    bool add(const Result<FrameHeader>& header) {
        if (!header || header->damaged) {
            ++counts_.rejected;
            return false;
        }
        if (last_sequence_) {
            const std::uint32_t gap = header->sequence - *last_sequence_ - 1;
            if (gap < kLongestGap) counts_.lost += gap;
        }
        last_sequence_ = header->sequence;
        ++counts_.samples;
        return true;
    }
    /// The camera was unplugged, and is back.
    void came_back() {
        ++counts_.reconnects;
        last_sequence_.reset();
    }
    const SourceCounts& counts() const { return counts_; }

  private:
    static constexpr std::uint32_t kLongestGap = 1000;  // frames: beyond it the count began anew

    std::optional<std::uint32_t> last_sequence_;
    SourceCounts counts_;
};

}  // namespace foverig::camera
