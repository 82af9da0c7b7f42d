#include "renderer/scene/scene_folder.h"

#include <algorithm>
#include <charconv>
#include <fstream>

#include "renderer/scene/import_error.h"
#include "renderer/scene/unpack.h"

namespace foverig::scene_import {

namespace fs = std::filesystem;

std::string read_file(const fs::path& file, std::uint64_t max_bytes) {
    std::error_code error;
    // A device or a pipe could block or never end.
    if (!fs::is_regular_file(file, error))
        fail(file, "there is no such file; name an .obj, .gltf, .glb or .ply file");
    const std::uint64_t size = fs::file_size(file, error);
    if (error) fail(file, "its size cannot be read ({})", error.message());
    if (size > max_bytes)
        fail(file, "holds {} bytes, more than the {} that this format can have here", size,
             max_bytes);
    std::string bytes(static_cast<std::size_t>(size), '\0');
    std::ifstream stream(file, std::ios::binary);
    if (!stream.read(bytes.data(), static_cast<std::streamsize>(size)))
        fail(file, "cannot be read; check its permissions");
    return is_zstd(bytes) ? unpack_zstd(bytes, file, max_bytes) : bytes;
}

SceneFolder::SceneFolder(const fs::path& scene_file) {
    std::error_code error;
    folder_ = fs::canonical(scene_file, error).parent_path();
    if (error) folder_ = fs::absolute(scene_file).parent_path();
}

std::optional<fs::path> SceneFolder::find(std::string_view reference) const {
    if (reference.empty() || reference.find(':') != std::string_view::npos) return std::nullopt;
    std::string text(reference);
    // OBJ files from Windows.
    std::replace(text.begin(), text.end(), '\\', '/');
    const fs::path relative(text);
    if (relative.is_absolute()) return std::nullopt;
    std::error_code error;
    const fs::path whole = fs::weakly_canonical(folder_ / relative, error);
    if (error) return std::nullopt;
    const auto [end, _] = std::mismatch(folder_.begin(), folder_.end(), whole.begin(), whole.end());
    if (end != folder_.end() || !fs::is_regular_file(whole, error)) return std::nullopt;
    return whole;
}

std::string percent_decoded(std::string_view uri) {
    std::string text;
    text.reserve(uri.size());
    for (std::size_t i = 0; i < uri.size(); ++i) {
        unsigned char code = 0;
        if (uri[i] == '%' && i + 2 < uri.size()) {
            const auto [end, error] = std::from_chars(&uri[i + 1], &uri[i + 1] + 2, code, 16);
            if (error == std::errc() && end == &uri[i + 1] + 2) {
                text += static_cast<char>(code);
                i += 2;
                continue;
            }
        }
        text += uri[i];
    }
    return text;
}

}  // namespace foverig::scene_import
