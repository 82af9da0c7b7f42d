#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace foverig::scene_import {

/// Bytes of a whole regular file, unpacked where they are zstd. Throws SceneError, also where the
/// file holds more than `max_bytes`, packed or not.
std::string read_file(const std::filesystem::path& file,
                      std::uint64_t max_bytes = std::uint64_t{1} << 33U);

/// The one folder that an import may read: the scene file's own, and what lies below it.
class SceneFolder {
  public:
    explicit SceneFolder(const std::filesystem::path& scene_file);

    /// The file that a relative reference (as glTF and MTL write it) means. Nothing for a URL, for
    /// a path or a symbolic link that leaves the folder, and for what is not a regular file.
    std::optional<std::filesystem::path> find(std::string_view reference) const;

    const std::filesystem::path& path() const { return folder_; }

  private:
    std::filesystem::path folder_;  ///< canonical
};

/// %20 and the like replaced.
std::string percent_decoded(std::string_view uri);

}  // namespace foverig::scene_import
