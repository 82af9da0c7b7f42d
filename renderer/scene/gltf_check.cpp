#include "renderer/scene/gltf_check.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "renderer/scene/gltf_json.h"
#include "renderer/scene/import_error.h"
#include "renderer/scene/scene_folder.h"

namespace foverig::scene_import {
namespace {

using nlohmann::json;

inline constexpr std::array<std::string_view, 11> kArrays{
    "accessors", "buffers",  "bufferViews", "images", "materials", "meshes",
    "nodes",     "samplers", "scenes",      "skins",  "textures"};

/// Required ones that change nothing that is drawn here, or that are read.
inline constexpr std::array<std::string_view, 9> kExtensions{"KHR_materials_transmission",
                                                             "KHR_materials_emissive_strength",
                                                             "KHR_texture_transform",
                                                             "KHR_mesh_quantization",
                                                             "KHR_materials_pbrSpecularGlossiness",
                                                             "KHR_materials_unlit",
                                                             "KHR_materials_ior",
                                                             "KHR_materials_volume",
                                                             "KHR_materials_clearcoat"};

class Checker {
  public:
    Checker(const json& root, const ImportContext& context)
        : root_(root), context_(context), folder_(context.file) {}

    void check() const {
        if (!root_.is_object()) fail(context_.file, "its JSON is no object; it is no glTF file");
        check_version();
        check_extensions();
        for (const std::string_view name : kArrays) check_array(name);
        if (root_.contains("scene")) check_index(root_["scene"], "scenes", "scene");
        each("scenes", [&](const json& scene, const std::string& at) {
            check_indices(scene, "nodes", "nodes", at);
        });
        each("nodes", [&](const json& node, const std::string& at) {
            check_reference(node, "mesh", "meshes", at);
            check_reference(node, "skin", "skins", at);
            check_indices(node, "children", "nodes", at);
            check_numbers(node, "matrix", 16, at);
            check_numbers(node, "rotation", 4, at);
            check_numbers(node, "scale", 3, at);
            check_numbers(node, "translation", 3, at);
        });
        each("meshes",
             [&](const json& mesh, const std::string& at) { check_primitives(mesh, at); });
        each("accessors",
             [&](const json& accessor, const std::string& at) { check_accessor(accessor, at); });
        each("bufferViews", [&](const json& view, const std::string& at) {
            check_reference(view, "buffer", "buffers", at);
            for (const char* key : {"byteOffset", "byteLength", "byteStride"})
                check_whole(view, key, at);
        });
        each("buffers",
             [&](const json& buffer, const std::string& at) { check_buffer(buffer, at); });
        each("images", [&](const json& image, const std::string& at) {
            check_reference(image, "bufferView", "bufferViews", at);
            check_string(image, "uri", at);
        });
        each("textures", [&](const json& texture, const std::string& at) {
            check_reference(texture, "source", "images", at);
            check_reference(texture, "sampler", "samplers", at);
        });
        each("materials", [&](const json& material, const std::string& at) {
            check_texture_infos(material, at);
            if (material.contains("pbrMetallicRoughness"))
                check_texture_infos(material["pbrMetallicRoughness"], at + ".pbrMetallicRoughness");
        });
        each("skins", [&](const json& skin, const std::string& at) {
            check_indices(skin, "joints", "nodes", at);
            check_reference(skin, "inverseBindMatrices", "accessors", at);
        });
    }

  private:
    void check_version() const {
        const json asset = root_.value("asset", json());
        if (!asset.is_object() || !asset.contains("version") || !asset["version"].is_string())
            fail(context_.file, "has no asset.version; expected glTF 2.0");
        const auto version = asset["version"].get<std::string>();
        const json least = asset.value("minVersion", json("2.0"));
        if (!version.starts_with("2.") || least != "2.0")
            fail(context_.file, "is glTF version '{}'; expected 2.0", version.substr(0, 20));
    }

    void check_extensions() const {
        const json required = root_.value("extensionsRequired", json::array());
        for (const json& name : required) {
            const std::string text = name.is_string() ? name.get<std::string>() : name.dump();
            if (std::find(kExtensions.begin(), kExtensions.end(), text) == kExtensions.end())
                fail(context_.file,
                     "requires the glTF extension {}, which is not supported; export it without",
                     text.substr(0, 60));
        }
    }

    void check_array(std::string_view name) const {
        const auto found = root_.find(name);
        if (found == root_.end()) return;
        if (!found->is_array()) fail(context_.file, "its '{}' is no array", name);
        for (std::size_t i = 0; i < found->size(); ++i)
            if (!(*found)[i].is_object()) fail(context_.file, "its {}[{}] is no object", name, i);
    }

    template <class Check>
    void each(const char* array, const Check& check) const {
        const auto found = root_.find(array);
        if (found == root_.end()) return;
        for (std::size_t i = 0; i < found->size(); ++i)
            check((*found)[i], fmt::format("{}[{}]", array, i));
    }

    void check_index(const json& value, const char* array, const std::string& at) const {
        const auto found = root_.find(array);
        const std::size_t count = found == root_.end() ? 0 : found->size();
        if (!value.is_number_unsigned() || value.get<std::uint64_t>() >= count)
            fail(context_.file, "{} is {}; expected an index into its {} {}", at,
                 value.dump().substr(0, 40), count, array);
    }

    void check_reference(const json& object, const char* key, const char* array,
                         const std::string& at) const {
        if (object.contains(key)) check_index(object[key], array, fmt::format("{}.{}", at, key));
    }

    void check_indices(const json& object, const char* key, const char* array,
                       const std::string& at) const {
        if (!object.contains(key)) return;
        if (!object[key].is_array()) fail(context_.file, "{}.{} is no array", at, key);
        for (const json& value : object[key])
            check_index(value, array, fmt::format("{}.{}", at, key));
    }

    void check_numbers(const json& object, const char* key, std::size_t count,
                       const std::string& at) const {
        if (!object.contains(key)) return;
        const json& list = object[key];
        const bool right =
            list.is_array() && list.size() == count &&
            std::all_of(list.begin(), list.end(), [](const json& v) { return v.is_number(); });
        if (!right) fail(context_.file, "{}.{} is not a list of {} numbers", at, key, count);
    }

    void check_whole(const json& object, const char* key, const std::string& at) const {
        if (object.contains(key) && !object[key].is_number_unsigned())
            fail(context_.file, "{}.{} is {}; expected a whole number from 0", at, key,
                 object[key].dump().substr(0, 40));
    }

    void check_buffer(const json& buffer, const std::string& at) const {
        check_whole(buffer, "byteLength", at);
        check_string(buffer, "uri", at);
        const auto uri = buffer.value("uri", std::string());
        if (uri.empty() || uri.starts_with("data:") || folder_.find(percent_decoded(uri))) return;
        fail(context_.file,
             "{} names '{}', which is no file in the scene's own folder; nothing else is read or "
             "fetched",
             at, uri.substr(0, 80));
    }

    void check_string(const json& object, const char* key, const std::string& at) const {
        if (object.contains(key) && !object[key].is_string())
            fail(context_.file, "{}.{} is no string", at, key);
    }

    void check_primitives(const json& mesh, const std::string& at) const {
        if (!mesh.contains("primitives") || !mesh["primitives"].is_array())
            fail(context_.file, "{} has no primitives", at);
        for (std::size_t i = 0; i < mesh["primitives"].size(); ++i) {
            const json& primitive = mesh["primitives"][i];
            const std::string where = fmt::format("{}.primitives[{}]", at, i);
            if (!primitive.is_object() || !primitive.contains("attributes") ||
                !primitive["attributes"].is_object())
                fail(context_.file, "{} has no attributes", where);
            check_reference(primitive, "indices", "accessors", where);
            check_reference(primitive, "material", "materials", where);
            for (const auto& [name, index] : primitive["attributes"].items())
                check_index(index, "accessors", fmt::format("{}.{}", where, name));
        }
    }

    void check_accessor(const json& accessor, const std::string& at) const {
        check_reference(accessor, "bufferView", "bufferViews", at);
        for (const char* key : {"byteOffset", "componentType", "count"})
            check_whole(accessor, key, at);
        if (!accessor.contains("sparse")) return;
        const json& sparse = accessor["sparse"];
        const std::string where = at + ".sparse";
        if (!sparse.is_object() || !sparse.value("indices", json()).is_object() ||
            !sparse.value("values", json()).is_object())
            fail(context_.file, "{} lacks indices or values", where);
        check_whole(sparse, "count", where);
        for (const char* key : {"indices", "values"}) {
            check_reference(sparse[key], "bufferView", "bufferViews", where + "." + key);
            check_whole(sparse[key], "byteOffset", where + "." + key);
        }
    }

    void check_texture_infos(const json& object, const std::string& at) const {
        if (!object.is_object()) fail(context_.file, "{} is no object", at);
        for (const auto& [key, value] : object.items())
            if (key.ends_with("Texture")) {
                if (!value.is_object() || !value.contains("index"))
                    fail(context_.file, "{}.{} has no index", at, key);
                check_reference(value, "index", "textures", fmt::format("{}.{}", at, key));
            }
    }

    const json& root_;
    const ImportContext& context_;
    SceneFolder folder_;
};

}  // namespace

void check_gltf_json(std::string_view text, const ImportContext& context) {
    const json root = parse_json(text, context);
    Checker(root, context).check();
}

}  // namespace foverig::scene_import
