#include "renderer/scene/builtin/noise.h"

#include "renderer/scene/builtin/exact.h"
#include "renderer/scene/builtin/hash.h"

namespace foverig::builtin {
namespace {

float fade(float t) {
    return t * t * t * (t * (t * 6.0F - 15.0F) + 10.0F);
}

std::uint32_t wrap(int i, int period) {
    const int rest = i % period;
    return static_cast<std::uint32_t>(rest < 0 ? rest + period : rest);
}

float slope(std::uint32_t bits, float dx, float dy) {
    const float gx = unit_of(bits) * 2.0F - 1.0F;
    const float gy = unit_of(bits * 0x9e3779b1U) * 2.0F - 1.0F;
    return gx * dx + gy * dy;
}

float slope(std::uint32_t bits, const vec3& d) {
    // The twelve edge directions of a cube: no lattice direction is favoured.
    const float a = (bits & 1U) != 0U ? 1.0F : -1.0F;
    const float b = (bits & 2U) != 0U ? 1.0F : -1.0F;
    switch ((bits >> 2U) % 3U) {
        case 0:
            return a * d.x + b * d.y;
        case 1:
            return a * d.y + b * d.z;
        default:
            return a * d.z + b * d.x;
    }
}

}  // namespace

float noise(vec2 p, int period, std::uint32_t seed) {
    const float fx = std::floor(p.x);
    const float fy = std::floor(p.y);
    const int ix = static_cast<int>(fx);
    const int iy = static_cast<int>(fy);
    const float x = p.x - fx;
    const float y = p.y - fy;
    const auto corner = [&](int dx, int dy) {
        const std::uint32_t bits = hash(wrap(ix + dx, period), wrap(iy + dy, period), seed);
        return slope(bits, x - static_cast<float>(dx), y - static_cast<float>(dy));
    };
    const float u = fade(x);
    const float low = mix(corner(0, 0), corner(1, 0), u);
    const float high = mix(corner(0, 1), corner(1, 1), u);
    return 1.6F * mix(low, high, fade(y));
}

float noise(const vec3& p, std::uint32_t seed) {
    const vec3 base{std::floor(p.x), std::floor(p.y), std::floor(p.z)};
    const vec3 f = p - base;
    const auto corner = [&](int dx, int dy, int dz) {
        const std::uint32_t bits =
            hash(static_cast<std::uint32_t>(static_cast<int>(base.x) + dx),
                 static_cast<std::uint32_t>(static_cast<int>(base.y) + dy),
                 static_cast<std::uint32_t>(static_cast<int>(base.z) + dz), seed);
        return slope(
            bits, f - vec3{static_cast<float>(dx), static_cast<float>(dy), static_cast<float>(dz)});
    };
    const float u = fade(f.x);
    const float v = fade(f.y);
    const auto layer = [&](int dz) {
        return mix(mix(corner(0, 0, dz), corner(1, 0, dz), u),
                   mix(corner(0, 1, dz), corner(1, 1, dz), u), v);
    };
    return mix(layer(0), layer(1), fade(f.z));
}

float fractal_noise(vec2 uv, int cells, int octaves, std::uint32_t seed) {
    float sum = 0.0F;
    float weight = 0.5F;
    for (int i = 0; i < octaves; ++i) {
        sum += weight *
               noise(uv * static_cast<float>(cells), cells, seed + static_cast<std::uint32_t>(i));
        weight *= 0.5F;
        cells *= 2;
    }
    return sum;
}

float fractal_noise(const vec3& p, int octaves, std::uint32_t seed) {
    float sum = 0.0F;
    float weight = 0.5F;
    vec3 q = p;
    for (int i = 0; i < octaves; ++i) {
        sum += weight * noise(q, seed + static_cast<std::uint32_t>(i));
        weight *= 0.5F;
        q *= 2.0F;
    }
    return sum;
}

Cells cell_noise(vec2 uv, int cells, std::uint32_t seed) {
    const float x = fract(uv.x) * static_cast<float>(cells);
    const float y = fract(uv.y) * static_cast<float>(cells);
    const int ix = static_cast<int>(x);
    const int iy = static_cast<int>(y);
    Cells best{9.0F, 9.0F, 0};
    for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
            const std::uint32_t id = hash(wrap(ix + dx, cells), wrap(iy + dy, cells), seed);
            const vec2 point{static_cast<float>(ix + dx) + unit_of(hash(id)) - x,
                             static_cast<float>(iy + dy) + unit_of(hash(id + 1U)) - y};
            const float distance = length(point);
            if (distance < best.nearest) {
                best = {distance, best.nearest, id};
            } else if (distance < best.second) {
                best.second = distance;
            }
        }
    }
    return best;
}

}  // namespace foverig::builtin
