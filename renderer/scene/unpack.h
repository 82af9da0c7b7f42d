#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace foverig::scene_import {

bool is_zstd(std::string_view bytes);

/// What the zstd frames of `file` hold (RFC 8878). Throws SceneError where they are damaged, cut
/// off, or unpacked more than `max_bytes` or kMostTimesLarger times as large.
std::string unpack_zstd(std::string_view packed, const std::filesystem::path& file,
                        std::uint64_t max_bytes);

/// No mesh is so regular; what is would be a bomb.
inline constexpr std::size_t kMostTimesLarger = 64;

}  // namespace foverig::scene_import
