#include "rig/sweep/flight.h"

#include <fmt/format.h>

#include "rig/failure.h"
#include "rig/session/no_renderer.h"
#include "rig/session/session.h"
#include "rig/text/digest.h"

namespace foverig::sweep {
namespace {

constexpr double kShareOfVsync = 0.75;  // any cost below 1 makes every VSync

/// Plain numbers without gaps between them.
template <class T>
void add(Digest& digest, const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    digest.add({reinterpret_cast<const char*>(&value), sizeof(T)});
}

template <class T>
void add(Digest& digest, const std::vector<T>& values) {
    static_assert(std::is_trivially_copyable_v<T>);
    add(digest, values.size());
    digest.add({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)});
}

std::vector<vec3> known_gaze(const FrameRecord& frame, std::size_t eyes) {
    std::vector<vec3> gaze;
    for (std::size_t eye = 0; eye < eyes; ++eye)
        if (frame.best_known_gaze[eye]) gaze.push_back(*frame.best_known_gaze[eye]);
    return gaze.size() == eyes ? gaze : std::vector<vec3>{};
}

}  // namespace

std::vector<FlownFrame> fly(const Scenario& scenario, const Scene& scene) {
    Scenario paced = scenario;
    paced.clock = "lockstep";
    paced.cost = fmt::format("fixed:{}", kShareOfVsync * 1000.0 / scenario.display.rate_hz);
    paced.display.pacing = "vsync";
    NoRenderer renderer;
    std::vector<FlownFrame> flight;
    SessionHooks hooks;
    hooks.frame_done = [&](const FrameRecord& frame, const FrameInput& input, double) {
        flight.push_back({input, known_gaze(frame, input.eyes.size())});
        return false;
    };
    Session(paced, scene, renderer, nullptr).run(hooks);
    if (static_cast<std::int64_t>(flight.size()) < scenario.frames)
        throw UsageError(
            fmt::format("scenario.frames = {}: the flight ends after {}; expected no more than "
                        "what a recording "
                        "(or replay.loop = true) and scenario.seconds have",
                        scenario.frames, flight.size()));
    return flight;
}

std::vector<FlownFrame> stretches_of(std::vector<FlownFrame> flight, const Stretches& stretches) {
    if (stretches.frames == 0) return flight;
    std::vector<FlownFrame> shown;
    for (std::size_t i = 0; i < stretches.count; ++i) {
        const std::size_t first = i * flight.size() / stretches.count;
        for (std::size_t k = 0; k < stretches.frames; ++k) shown.push_back(flight.at(first + k));
    }
    return shown;
}

std::string digest_of(const std::vector<FlownFrame>& flight) {
    Digest digest;
    for (const auto& [input, true_gaze] : flight) {
        add(digest, input.frame);
        add(digest, input.time_s);
        for (const EyeInput& eye : input.eyes) add(digest, eye.view);
    }
    return digest.hex();
}

std::string digest_of(const Scene& scene) {
    Digest digest;
    add(digest, scene.origin_m);
    add(digest, scene.positions_m);
    add(digest, scene.normals);
    add(digest, scene.texcoords);
    add(digest, scene.triangles);
    add(digest, scene.triangle_materials);
    add(digest, scene.materials);
    for (const Texture& texture : scene.textures) {  // field by field: it ends in a gap
        add(digest, texture.width);
        add(digest, texture.height);
        add(digest, texture.level_count);
        add(digest, texture.first_texel);
        add(digest, texture.repeat_u);
        add(digest, texture.repeat_v);
    }
    add(digest, scene.texels);
    for (const Part& part : scene.parts) {
        add(digest, part.first_triangle);
        add(digest, part.triangle_count);
        add(digest, part.alpha_masked);
        add(digest, part.motion);
    }
    add(digest, scene.motions);
    add(digest, scene.point_lights);
    add(digest, scene.area_lights);
    add(digest, scene.ambient);
    add(digest, scene.background);
    return digest.hex();
}

}  // namespace foverig::sweep
