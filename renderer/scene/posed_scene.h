#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "renderer/scene/scene_view.h"

namespace foverig {

struct PoseSettings {
    bool textures = true;  ///< effect textures; without it no table of texels is made
    bool motion = true;    ///< effect moving_geometry; without it nothing can move
};

/// Memory of a scene that a tracer holds, by what it is there for.
struct SceneBytes {
    std::uint64_t base = 0;  ///< vertices and acceleration structure
    std::uint64_t textures = 0;
    std::uint64_t motion = 0;

    std::uint64_t total() const { return base + textures + motion; }
};

/// A Scene at a time: vertices where its motions have taken them, and the per-triangle and
/// per-texture tables that shading reads. What every tracer holds beside its own structure. Borrows
/// `scene`, which must outlive it and stay unchanged.
class PosedScene {
  public:
    explicit PosedScene(const Scene& scene, const PoseSettings& settings = {});
    PosedScene(const PosedScene&) = delete;
    PosedScene& operator=(const PosedScene&) = delete;
    ~PosedScene() = default;

    const Scene& source() const { return source_; }
    const SceneView& view() const { return view_; }
    /// Parts that can move, as indices into Scene::parts.
    std::span<const std::size_t> moving_parts() const { return moving_parts_; }

    /// Moves the vertices of the moving parts; the arrays of view() stay where they are.
    void set_time(double time_s);

    SceneBytes bytes() const;

  private:
    void build_texel_density();
    void build_textures();

    const Scene& source_;
    SceneView view_;
    std::vector<std::size_t> moving_parts_;
    std::vector<vec3> positions_m_;  ///< at the current time, padded for 16-byte reads
    std::vector<vec3> normals_;      ///< at the current time; empty while nothing can move
    std::vector<float> texel_density_log2_;
    std::vector<Half4> linear_texels_;
    std::vector<MipLevel> mips_;
};

}  // namespace foverig
