#pragma once
#include <span>
#include <utility>

#include "renderer/scene/imported.h"
#include "renderer/scene/tinygltf.h"

namespace foverig::scene_import {

/// Bytes of a buffer view. Throws SceneError where it leaves its buffer.
std::span<const unsigned char> view_bytes(const tinygltf::Model& model, int view,
                                          const ImportContext& context);

/// Read access to one accessor. Its constructor proves that every element lies inside its buffer
/// view and the view inside its buffer, so that reading needs no more checks.
class GltfAccessor {
  public:
    /// Throws SceneError; `components` is what is expected (1 to 4, or 16 for MAT4).
    GltfAccessor(const tinygltf::Model& model, int accessor, int components,
                 const ImportContext& context);

    std::size_t count() const { return count_; }

    /// Component `c` of element `i` < count(); normalised integers become -1..1 or 0..1.
    double value(std::size_t i, int c) const;
    dvec3 vec3_at(std::size_t i) const { return {value(i, 0), value(i, 1), value(i, 2)}; }
    vec2 vec2_at(std::size_t i) const { return {value(i, 0), value(i, 1)}; }
    /// Whether its components are unsigned integers; index_at() needs that.
    bool holds_indices() const;
    std::uint32_t index_at(std::size_t i) const;

  private:
    std::span<const unsigned char> checked_range(const tinygltf::Model& model, int view,
                                                 std::uint64_t offset, std::uint64_t count,
                                                 std::uint64_t stride, std::uint64_t size,
                                                 const ImportContext& context) const;
    void read_sparse(const tinygltf::Model& model, const ImportContext& context);
    const unsigned char* element(std::size_t i) const;

    int number_ = 0;  ///< for messages
    int type_ = 0;
    bool normalized_ = false;
    std::size_t count_ = 0;
    std::size_t stride_ = 0;
    std::span<const unsigned char> bytes_;  ///< from the first element on; empty: all zeros
    std::vector<std::pair<std::uint32_t, const unsigned char*>> sparse_;  ///< by element
};

}  // namespace foverig::scene_import
