#include "rig/governor/governed_renderer.h"

namespace foverig::governor {
namespace {

std::vector<double> costs_of(const Ladder& ladder) {
    std::vector<double> ms;
    for (const Rung& rung : ladder.rungs) ms.push_back(rung.ms);
    return ms;
}

}  // namespace

Limits limits_of(const Scenario& scenario) {
    return {.limit_ms = (1.0 - scenario.governor.headroom) * 1000.0 / scenario.display.rate_hz,
            .patience_frames = scenario.governor.patience_frames};
}

GovernedRenderer::GovernedRenderer(Ladder ladder, const Limits& limits, const Open& open)
    : ladder_(std::move(ladder)), limits_(limits), governor_(costs_of(ladder_), limits) {
    for (const Rung& rung : ladder_.rungs) renderers_.push_back(open(rung.render));
    shown_ = governor_.setting();
}

FrameStats GovernedRenderer::render(const FrameInput& input) {
    shown_ = governor_.setting();
    chosen_.push_back(static_cast<std::uint32_t>(shown_));
    return renderers_[shown_]->render(input);
}

double GovernedRenderer::fixed_ms(double dearest_ms) const {
    return dearest_ms * ladder_.rungs[governor_.setting()].ms / ladder_.rungs.back().ms;
}

std::uint64_t GovernedRenderer::backend_bytes() const {
    std::uint64_t bytes = 0;
    for (const auto& renderer : renderers_) bytes += renderer->backend_bytes();
    return bytes;
}

GovernorRecord GovernedRenderer::record() const {
    GovernorRecord record;
    record.error_name = ladder_.error_name;
    record.limit_ms = limits_.limit_ms;
    for (const Rung& rung : ladder_.rungs)
        record.settings.push_back({rung.text, rung.ms, rung.error});
    return record;
}

}  // namespace foverig::governor
