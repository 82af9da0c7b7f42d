#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace foverig::scene_import {

bool is_zstd(std::string_view bytes);

/// What the zstd frames of `file` hold (RFC 8878). Throws SceneError where they are damaged, cut
/// off, or more than kMostTimesLarger times as large unpacked.
std::string unpack_zstd(std::string_view packed, const std::filesystem::path& file);

/// No mesh is so regular; what is would be a bomb.
inline constexpr std::size_t kMostTimesLarger = 64;

}  // namespace foverig::scene_import
