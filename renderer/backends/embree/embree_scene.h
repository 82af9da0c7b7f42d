#pragma once
#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

#include "renderer/backends/embree/handles.h"
#include "renderer/scene/scene_view.h"

namespace foverig::embree {

struct EmbreeSettings {
    bool alpha_test = true;  ///< effect alpha_mask; without it masked parts trace as opaque
    bool textures = true;    ///< effect textures; without it no table of texels is made
    bool motion = true;      ///< effect moving_geometry; without it nothing can move
    bool robust = true;      ///< watertight edges: no ray slips between two triangles
    int threads = 0;         ///< of the builder; 0: one a core
};

/// Memory of an EmbreeScene by what it is there for.
struct SceneBytes {
    std::uint64_t base = 0;  ///< vertices and acceleration structure
    std::uint64_t textures = 0;
    std::uint64_t motion = 0;

    std::uint64_t total() const { return base + textures + motion; }
};

/// What the alpha filter of a geometry reads.
struct MaskedPart {
    const SceneView* scene = nullptr;
    std::uint32_t first_triangle = 0;
};

/// A Scene in Embree: one geometry a part, alpha filters only where a part needs them, and the
/// per-triangle numbers that shading reads. Borrows `scene`, which must outlive it and stay
/// unchanged.
class EmbreeScene {
  public:
    EmbreeScene(const Scene& scene, const EmbreeSettings& settings);
    EmbreeScene(const EmbreeScene&) = delete;
    EmbreeScene& operator=(const EmbreeScene&) = delete;

    RTCScene handle() const { return scene_.get(); }
    const SceneView& view() const { return view_; }
    View<const std::uint32_t> first_triangles() const { return view_of(first_triangles_); }

    /// Moves the parts that have a motion and refits; nothing to do in a static scene.
    void set_time(double time_s);

    SceneBytes bytes() const;

  private:
    struct PartGeometry {
        MaskedPart masked;
        Geometry geometry;
    };

    void build_texel_density();
    void build_textures();
    void attach_parts(const EmbreeSettings& settings);

    const Scene& source_;
    SceneView view_;
    std::vector<vec3> positions_m_;  ///< at the current time, padded for 16-byte reads
    std::vector<vec3> normals_;      ///< at the current time; empty while nothing can move
    std::vector<float> texel_density_log2_;
    std::vector<Half4> linear_texels_;
    std::vector<MipLevel> mips_;
    std::vector<std::uint32_t> first_triangles_;  ///< by geometry id
    std::vector<std::unique_ptr<PartGeometry>> parts_;
    std::atomic<std::int64_t> embree_bytes_{0};
    Device device_;
    SceneHandle scene_;
};

}  // namespace foverig::embree
