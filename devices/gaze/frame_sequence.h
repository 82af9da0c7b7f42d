#pragma once
// Follows the running number of SGZ1 frames within and across sessions (DEVICES.md 4.5.2).
#include <cstdint>

#include "devices/gaze/frames.h"

namespace foverig::gaze {

class FrameSequence {
  public:
    struct Step {
        bool accepted = true;
        bool new_session = false;  ///< not the first session that was seen
        std::uint32_t lost = 0;    ///< frames of any type missing before this one
    };

    Step advance(const FrameHeader& header);

  private:
    static constexpr int kResyncAfter = 16;

    bool started_ = false;
    std::uint32_t session_ = 0, last_ = 0;
    int refused_in_a_row_ = 0;
};

inline FrameSequence::Step FrameSequence::advance(const FrameHeader& header) {
    Step step;
    step.new_session = started_ && header.session != session_;
    if (started_ && !step.new_session) {
        const std::uint32_t ahead = header.sequence - last_;
        const bool stale = ahead == 0 || ahead >= 1u << 31;
        // A lone wrong number must not shut the stream out for good.
        if (stale && ++refused_in_a_row_ < kResyncAfter) return {.accepted = false};
        step.lost = stale ? 0 : ahead - 1;
    }
    started_ = true;
    refused_in_a_row_ = 0;
    session_ = header.session;
    last_ = header.sequence;
    return step;
}

}  // namespace foverig::gaze
