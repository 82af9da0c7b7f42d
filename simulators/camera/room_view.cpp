#include "simulators/camera/room_view.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "devices/bytes.h"

namespace foverig {
namespace {

using vec3f = glm::vec3;

constexpr vec3f kHalf_m{3.0F, 1.5F, 3.0F};
constexpr float kTilesPer_m = 2.0F;
constexpr std::size_t kWalls = 6;
constexpr int kStretch_px = 16;

/// One pair of pixels of each wall's two tiles, as YUYV.
using Paints = std::array<std::array<std::byte, 4>, 2 * kWalls>;

std::array<std::byte, 4> yuyv_of(const dvec3& rgb) {  // 0..1; ITU-R BT.601-7, 2.5
    const double y = 0.299 * rgb.r + 0.587 * rgb.g + 0.114 * rgb.b;
    const auto level = [](double value) { return static_cast<std::byte>(std::lround(value)); };
    const std::byte luma = level(16.0 + 219.0 * y);
    return {luma, level(128.0 + 224.0 * (rgb.b - y) / 1.772), luma,
            level(128.0 + 224.0 * (rgb.r - y) / 1.402)};
}

Paints paints() {
    // Left, right, floor, ceiling, ahead, behind.
    constexpr std::array<dvec3, kWalls> kColours{dvec3(0.85, 0.35, 0.30), dvec3(0.30, 0.60, 0.85),
                                                 dvec3(0.55, 0.42, 0.30), dvec3(0.90, 0.90, 0.88),
                                                 dvec3(0.45, 0.75, 0.40), dvec3(0.80, 0.70, 0.30)};
    constexpr double kDark = 0.55;
    Paints all{};
    for (std::size_t i = 0; i < kWalls; ++i) {
        all[2 * i] = yuyv_of(kColours[i]);
        all[2 * i + 1] = yuyv_of(kDark * kColours[i]);
    }
    return all;
}

const Paints& palette() {
    static const Paints all = paints();
    return all;
}

/// Which of the paints a ray from inside the room meets.
std::size_t met(const vec3f& from_m, const vec3f& along) {
    int axis = 0;
    float way = INFINITY;
    for (int i = 0; i < 3; ++i) {
        const float to_wall = std::copysign(kHalf_m[i], along[i]) - from_m[i];
        const float t = to_wall / along[i];  // a ray along the wall: infinite, or far behind others
        if (t < way) {
            way = t;
            axis = i;
        }
    }
    const vec3f at = (from_m + way * along) * kTilesPer_m;
    const int u = static_cast<int>(std::floor(at[(axis + 1) % 3]));
    const int v = static_cast<int>(std::floor(at[(axis + 2) % 3]));
    const std::size_t wall =
        2 * static_cast<std::size_t>(axis) + static_cast<std::size_t>(along[axis] > 0.0F);
    return 2 * wall + static_cast<std::size_t>((u ^ v) & 1);
}

bool bends(const camera::Lens& lens) {
    return lens.k1 != 0 || lens.k2 != 0 || lens.k3 != 0 || lens.p1 != 0 || lens.p2 != 0;
}

}  // namespace

RoomView::RoomView(int width_px, int height_px, const camera::AnyLens& lens)
    : width_px_(width_px), height_px_(height_px) {
    const auto* brown = std::get_if<camera::Lens>(&lens);
    if (brown != nullptr && !bends(*brown)) {
        straight_ = *brown;
        return;
    }
    for (int y = 0; y < height_px_; ++y) {
        for (int x = 0; x < width_px_; x += 2) {
            const auto ray = std::visit(
                [&](const auto& l) {
                    return l.ray_at({x + 0.5, y});
                },
                lens);
            rays_.push_back(ray ? vec3f(dvec3(ray->x, -ray->y, -ray->z)) : vec3f(0.0F));
        }
    }
}

void RoomView::render_bent(const RigidPose& world_from_camera, std::span<std::byte> yuyv) const {
    const Paints& all = palette();
    const std::array<std::byte, 4> black = yuyv_of(dvec3(0.0));
    const vec3f from_m(world_from_camera.translation_m);
    const glm::mat3 axes(glm::mat3_cast(world_from_camera.rotation));
    std::byte* out = yuyv.data();
    for (const vec3f& ray : rays_) {
        const bool sees = ray != vec3f(0.0F);
        std::memcpy(out, sees ? all[met(from_m, axes * ray)].data() : black.data(), 4);
        out += 4;
    }
}

void RoomView::render(const RigidPose& world_from_camera, std::span<std::byte> yuyv) const {
    if (!rays_.empty()) {
        render_bent(world_from_camera, yuyv);
        return;
    }
    const Paints& all = palette();
    const vec3f from_m(world_from_camera.translation_m);
    const dmat3 axes = glm::mat3_cast(world_from_camera.rotation);
    const vec3f right(axes[0] / straight_.fx_px), up(axes[1] / straight_.fy_px), ahead(-axes[2]);
    const float middle_x = static_cast<float>(straight_.cx_px),
                middle_y = static_cast<float>(straight_.cy_px);
    std::byte* out = yuyv.data();
    for (int y = 0; y < height_px_; ++y) {
        const vec3f row = ahead + (middle_y - static_cast<float>(y)) * up;
        const auto at = [&](int x) {  // of the pair that begins there: it shares light and colour
            return met(from_m, row + (static_cast<float>(x) + 0.5F - middle_x) * right);
        };
        // No tile is as narrow as a stretch, but for very wide lenses.
        for (int x = 0; x < width_px_; x += kStretch_px) {
            const int end = std::min(x + kStretch_px, width_px_);
            const std::size_t first = at(x);
            const bool one = first == at(end - 2);
            for (int i = x; i < end; i += 2, out += 4) {
                std::memcpy(out, all[one ? first : at(i)].data(), 4);
            }
        }
    }
}

}  // namespace foverig
