#pragma once
#include <string_view>

#include "renderer/scene/ply_header.h"

namespace foverig::scene_import {

/// Reads the numbers after a PLY header, one after the other, in any of the three formats.
class PlyBody {
  public:
    PlyBody(std::string_view bytes, const PlyHeader& header, const ImportContext& context)
        : bytes_(bytes), at_(header.body_offset), format_(header.format), context_(context) {}

    /// Throws SceneError where the file ends or, in ascii, where there is no number.
    double next(PlyType type);

    /// The length of a list. Throws SceneError where the rest of the file cannot hold it.
    std::uint64_t next_count(const PlyProperty& list);

    /// Steps over one value, or over a whole list.
    void skip(const PlyProperty& property);

  private:
    double next_ascii();

    std::string_view bytes_;
    std::size_t at_;
    PlyFormat format_;
    const ImportContext& context_;
};

}  // namespace foverig::scene_import
