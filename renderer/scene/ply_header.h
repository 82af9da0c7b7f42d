#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/scene/imported.h"

namespace foverig::scene_import {

enum class PlyFormat { kAscii, kLittleEndian, kBigEndian };
enum class PlyType { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat32, kFloat64 };

std::size_t size_of(PlyType type);

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::kFloat32;
    bool is_list = false;
    PlyType count_type = PlyType::kUint8;
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;
};

struct PlyHeader {
    PlyFormat format = PlyFormat::kAscii;
    std::vector<PlyElement> elements;
    std::size_t body_offset = 0;  ///< bytes from the file's begin
};

/// Parses "ply" to "end_header". Throws SceneError, also where the counts cannot fit into the file.
PlyHeader parse_ply_header(std::string_view bytes, const ImportContext& context);

}  // namespace foverig::scene_import
