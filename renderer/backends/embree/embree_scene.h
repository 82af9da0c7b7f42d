#pragma once
#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

#include "renderer/backends/embree/handles.h"
#include "renderer/scene/posed_scene.h"

namespace foverig::embree {

struct EmbreeSettings {
    bool alpha_test = true;  ///< effect alpha_mask; without it masked parts trace as opaque
    bool robust = true;      ///< watertight edges: no ray slips between two triangles
    int threads = 0;         ///< of the builder; 0: one a core
    bool textures = true;    ///< effect textures; without it no table of texels is made
    bool motion = true;      ///< effect moving_geometry; without it nothing can move
};

/// What the alpha filter of a geometry reads.
struct MaskedPart {
    const SceneView* scene = nullptr;
    std::uint32_t first_triangle = 0;
};

/// A Scene in Embree: one geometry a part, alpha filters only where a part needs them. Borrows
/// `scene`, which must outlive it and stay unchanged.
class EmbreeScene {
  public:
    EmbreeScene(const Scene& scene, const EmbreeSettings& settings);
    EmbreeScene(const EmbreeScene&) = delete;
    EmbreeScene& operator=(const EmbreeScene&) = delete;
    ~EmbreeScene() = default;

    RTCScene handle() const { return scene_.get(); }
    const SceneView& view() const { return posed_.view(); }
    View<const std::uint32_t> first_triangles() const { return view_of(first_triangles_); }

    /// Moves the parts that have a motion and refits; nothing to do in a static scene.
    void set_time(double time_s);

    SceneBytes bytes() const;

  private:
    struct PartGeometry {
        MaskedPart masked;
        Geometry geometry;
    };

    void attach_parts(const EmbreeSettings& settings);

    PosedScene posed_;
    std::vector<std::uint32_t> first_triangles_;  ///< by geometry id
    std::vector<std::unique_ptr<PartGeometry>> parts_;
    std::atomic<std::int64_t> embree_bytes_{0};
    Device device_;
    SceneHandle scene_;
};

}  // namespace foverig::embree
