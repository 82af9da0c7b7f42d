#include "renderer/pipelines/tile_scratch.h"

namespace foverig {

TileScratch::TileScratch(EffectMemory& memory, const EffectPlan& plan)
    : pixels(memory.base(), kStride),
      hits(memory.base(), kStride),
      slots(memory.base(), kStride),
      patterns(memory.of(Effect::area_light), plan.on(Effect::area_light) ? kStride : 0),
      rows(memory.base(), std::size_t{kStride} * kRowsWithoutLight, memory.of(Effect::light_buffer),
           plan.on(Effect::light_buffer) ? std::size_t{kStride} * (kRows - kRowsWithoutLight) : 0),
      occlusion(memory, plan) {}

}  // namespace foverig
