#include "renderer/scene/gltf_file.h"

#include <limits>

#include "renderer/scene/gltf_check.h"
#include "renderer/scene/gltf_json.h"
#include "renderer/scene/import_error.h"
#include "renderer/scene/scene_folder.h"

namespace foverig::scene_import {
namespace {

const SceneFolder& folder(void* user) {
    return *static_cast<const SceneFolder*>(user);
}

/// tinygltf also tries the working directory, and joins paths itself: what counts is where they
/// end.
std::optional<std::filesystem::path> inside(const std::string& path, void* user) {
    const std::filesystem::path relative =
        std::filesystem::path(path).lexically_relative(folder(user).path());
    if (relative.empty()) return std::nullopt;
    return folder(user).find(relative.string());
}

tinygltf::FsCallbacks folder_only(SceneFolder& folder_of_scene) {
    tinygltf::FsCallbacks callbacks{};
    callbacks.user_data = &folder_of_scene;
    callbacks.FileExists = [](const std::string& path, void* user) {
        return inside(path, user).has_value();
    };
    callbacks.ExpandFilePath = [](const std::string& path, void* /*user*/) { return path; };
    callbacks.ReadWholeFile = [](std::vector<unsigned char>* out, std::string* error,
                                 const std::string& path, void* user) {
        const auto file = inside(path, user);
        if (!file) {
            *error = "it is not in the scene's folder";
            return false;
        }
        const std::string bytes = read_file(*file);
        out->assign(bytes.begin(), bytes.end());
        return true;
    };
    return callbacks;
}

/// Keeps a data URI's bytes for later; an image in a buffer view is found there again.
bool keep_encoded(tinygltf::Image* image, int /*index*/, std::string* /*error*/,
                  std::string* /*warning*/, int /*width*/, int /*height*/,
                  const unsigned char* bytes, int size, void* /*user*/) {
    if (image->bufferView < 0) image->image.assign(bytes, bytes + size);
    return true;
}

/// tinygltf's messages are lines, and quote whole data URIs.
std::string one_line(std::string text) {
    for (char& c : text)
        if (c == '\n' || c == '\r' || c == '\t') c = ' ';
    while (!text.empty() && (text.back() == ' ' || text.back() == '.')) text.pop_back();
    return text.size() > 160 ? text.substr(0, 160) + "..." : text;
}

}  // namespace

tinygltf::Model read_gltf(const ImportContext& context) {
    const std::string bytes = read_file(context.file, std::numeric_limits<std::uint32_t>::max());
    const bool binary = bytes.starts_with("glTF") || context.file.extension() == ".glb";
    if (bytes.empty()) fail(context.file, "is empty; expected glTF 2.0");
    check_gltf_json(binary ? glb_json(bytes, context) : std::string_view(bytes), context);

    SceneFolder scene_folder(context.file);
    tinygltf::TinyGLTF parser;
    parser.SetFsCallbacks(folder_only(scene_folder));
    parser.SetImageLoader(keep_encoded, nullptr);
    tinygltf::Model model;
    std::string error;
    std::string warning;
    const auto size = static_cast<unsigned>(bytes.size());
    const std::string base = scene_folder.path().string();
    const bool good =
        binary ? parser.LoadBinaryFromMemory(&model, &error, &warning,
                                             reinterpret_cast<const unsigned char*>(bytes.data()),
                                             size, base)
               : parser.LoadASCIIFromString(&model, &error, &warning, bytes.data(), size, base);
    if (!good) fail(context.file, "is not glTF that can be read ({})", one_line(error));
    return model;
}

}  // namespace foverig::scene_import
