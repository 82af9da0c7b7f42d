#include "renderer/pipelines/tile_scratch.h"

namespace foverig {

TileScratch::TileScratch(MemoryCount& memory, const EffectPlan& plan)
    : pixels(memory, kStride),
      hits(memory, kStride),
      slots(memory, kStride),
      patterns(memory, plan.on(Effect::light_buffer) ? kStride : 0),
      rows(memory, static_cast<std::size_t>(kStride) * (plan.on(Effect::light_buffer) ? kRows : kRowsWithoutLight)) {}

}  // namespace foverig
