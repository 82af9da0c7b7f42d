#include "renderer/kernels/sampling.h"

#include "tests/house/device/launch.h"

namespace foverig::device {

__global__ void draw(PatternTable table, vec3* directions, float* numbers, int n) {
    if (index() >= n) return;
    const vec2 point = scrambled_point(static_cast<std::uint32_t>(index()), hash32(1U, 2U));
    directions[index()] = frame_about({0.0F, 0.0F, 1.0F}).world(cosine_direction(point));
    numbers[index()] = table.get(0, pattern_of(1U, 2U), 0);
}

}  // namespace foverig::device
