#pragma once
// A run folder is written whole or not at all: beside its place first, then renamed into it.
#include <filesystem>
#include <optional>
#include <string_view>

namespace foverig {

class RunFolder {
  public:
    /// `out`, or the next free runs/NNN. Throws UsageError where `out` holds anything but an older
    /// run, which `publish` replaces.
    explicit RunFolder(const std::optional<std::filesystem::path>& out);
    /// Removes what was not published.
    ~RunFolder();
    RunFolder(const RunFolder&) = delete;
    RunFolder& operator=(const RunFolder&) = delete;

    /// Where to write until `publish`.
    const std::filesystem::path& draft() const { return draft_; }
    const std::filesystem::path& place() const { return place_; }

    void write(const std::filesystem::path& name, std::string_view text) const;
    /// Takes a file out of the draft, to stay beside the place whatever becomes of the run; where
    /// it lies then, or nullopt where there is none or it cannot be moved.
    std::optional<std::filesystem::path> rescue(const std::filesystem::path& name) const noexcept;
    void publish();

  private:
    std::filesystem::path place_;
    std::filesystem::path draft_;
};

/// Throws std::system_error with the path where the text cannot be written in full.
void write_text(const std::filesystem::path& file, std::string_view text);

/// The same, whole or not at all: beside it first, then renamed. A link stays and what it leads to
/// is replaced; a pipe or a device is written to as it is.
void replace_text(const std::filesystem::path& file, std::string_view text);

}  // namespace foverig
