#include "renderer/scene/gltf_json.h"

#include <algorithm>

#include "renderer/scene/import_error.h"

namespace foverig::scene_import {
namespace {

/// tinygltf copies `extras` by recursion.
inline constexpr int kMaxDepth = 64;

/// Of the brackets outside strings. nlohmann's own parser callback takes quadratic time on long
/// arrays.
int nesting_depth(std::string_view text) {
    int depth = 0;
    int deepest = 0;
    bool in_string = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (in_string) {
            if (c == '\\') ++i;
            in_string = c != '"';
            continue;
        }
        in_string = c == '"';
        if (c == '[' || c == '{') deepest = std::max(deepest, ++depth);
        if (c == ']' || c == '}') --depth;
    }
    return deepest;
}

std::uint32_t word_at(std::string_view bytes, std::size_t offset) {
    std::uint32_t word = 0;
    for (std::size_t i = 4; i-- > 0;)
        word = word << 8U | static_cast<unsigned char>(bytes[offset + i]);
    return word;
}

}  // namespace

std::string_view glb_json(std::string_view bytes, const ImportContext& context) {
    constexpr std::uint32_t kJsonChunk = 0x4E4F534A;
    if (bytes.size() < 20)
        fail(context.file, "holds {} bytes, less than the 20 of a GLB header", bytes.size());
    if (!bytes.starts_with("glTF"))
        fail(context.file, "does not begin with 'glTF'; it is no GLB file");
    if (word_at(bytes, 4) != 2)
        fail(context.file, "is GLB version {}; expected 2", word_at(bytes, 4));
    if (word_at(bytes, 8) > bytes.size())
        fail(context.file, "says it holds {} bytes, but has {}; it is cut short", word_at(bytes, 8),
             bytes.size());
    if (word_at(bytes, 16) != kJsonChunk) fail(context.file, "its first GLB chunk is not JSON");
    const std::uint64_t json_size = word_at(bytes, 12);
    if (json_size > bytes.size() - 20)
        fail(context.file, "its JSON chunk says {} bytes, but {} are left; it is cut short",
             json_size, bytes.size() - 20);
    return bytes.substr(20, static_cast<std::size_t>(json_size));
}

nlohmann::json parse_json(std::string_view text, const ImportContext& context) {
    if (const int depth = nesting_depth(text); depth > kMaxDepth)
        fail(context.file, "its JSON nests {} levels deep; expected at most {}", depth, kMaxDepth);
    try {
        return nlohmann::json::parse(text.begin(), text.end());
    } catch (const nlohmann::json::exception& error) {
        std::string what = error.what();
        // "[json.exception.parse_error.101] parse error at line 1, ...": the first part helps
        // nobody.
        if (const std::size_t bracket = what.find("] "); bracket != std::string::npos)
            what.erase(0, bracket + 2);
        fail(context.file, "is not valid JSON ({})", what.substr(0, 160));
    }
}

}  // namespace foverig::scene_import
