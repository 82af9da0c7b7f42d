#include "renderer/scene/obj_materials.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "renderer/scene/image_decode.h"
#include "renderer/scene/import_error.h"
#include "renderer/scene/textures.h"

namespace foverig::scene_import {
namespace {

/// Names are compared without the blanks and carriage returns that line ends leave behind.
std::string trimmed(const std::string& text) {
    const std::size_t end = text.find_last_not_of(" \t\r\n");
    const std::size_t begin = text.find_first_not_of(" \t");
    return end == std::string::npos ? std::string() : text.substr(begin, end + 1 - begin);
}

float finite_or(double value, float fallback) {
    return std::isfinite(value) ? static_cast<float>(value) : fallback;
}

vec3 colour(const tinyobj::real_t (&c)[3], float most) {
    vec3 result;
    for (int k = 0; k < 3; ++k) result[k] = std::clamp(finite_or(c[k], 0.0F), 0.0F, most);
    return result;
}

}  // namespace

bool ObjMaterials::operator()(const std::string& library,
                              std::vector<tinyobj::material_t>* materials,
                              std::map<std::string, int>* index_of, std::string* warning,
                              std::string* error) {
    const std::string name = trimmed(library);
    const auto file = folder_.find(name);
    if (!file) {
        imported_.scene.notes.push_back(fmt::format(
            "material library '{}' is not in the scene's folder: its materials are plain grey",
            name));
        return false;
    }
    std::istringstream stream(read_file(*file, std::uint64_t{64} << 20U));
    tinyobj::LoadMtl(index_of, materials, &stream, warning, error);
    for (const auto& [key, index] : *index_of)
        known_.emplace(trimmed(key), materials->at(static_cast<std::size_t>(index)));
    return !materials->empty();
}

std::uint16_t ObjMaterials::material(const std::string& raw_name) {
    const std::string name = trimmed(raw_name);
    if (const auto used = used_.find(name); used != used_.end()) return used->second;
    const auto mtl = known_.find(name);
    if (mtl == known_.end() && !name.empty())
        imported_.scene.notes.push_back(
            fmt::format("material '{}' is in no library: plain grey instead", name));
    const Material made = mtl == known_.end() ? Material{} : converted(mtl->second);
    return used_[name] = add_material(imported_, made, context_);
}

Material ObjMaterials::converted(const tinyobj::material_t& mtl) {
    Material material;
    material.diffuse = colour(mtl.diffuse, 1.0F);
    material.specular = colour(mtl.specular, 1.0F);
    material.shininess = std::clamp(finite_or(mtl.shininess, 1.0F), 1.0F, 10000.0F);
    material.emission = colour(mtl.emission, 1.0e6F);
    material.ior = std::clamp(finite_or(mtl.ior, 1.5F), 1.0F, 4.0F);
    // MTL: illum 0 and 1 have no highlight; 3, 5 and 8 mirror; 4, 6, 7 and 9 are glass.
    if (mtl.illum == 0 || mtl.illum == 1) material.specular = vec3(0.0F);
    if (mtl.illum == 3 || mtl.illum == 5 || mtl.illum == 8)
        material.reflectance =
            std::max({material.specular.x, material.specular.y, material.specular.z});
    const float dissolve = std::clamp(finite_or(mtl.dissolve, 1.0F), 0.0F, 1.0F);
    material.transmission = 1.0F - dissolve;
    const vec3 filter = colour(mtl.transmittance, 1.0F);
    if (dissolve == 1.0F && (mtl.illum == 4 || mtl.illum == 6 || mtl.illum == 7 || mtl.illum == 9))
        material.transmission = std::max({filter.x, filter.y, filter.z});

    material.diffuse_texture =
        texture(mtl.diffuse_texname, mtl.alpha_texname, mtl.diffuse_texopt.clamp);
    if (material.diffuse_texture >= 0 &&
        imported_.scene.textures[static_cast<std::size_t>(material.diffuse_texture)].has_alpha)
        material.alpha_cutoff = 0.5F;
    material.emission_texture = texture(mtl.emissive_texname, "", mtl.emissive_texopt.clamp);
    if (material.emission_texture >= 0 && material.emission == vec3(0.0F))
        material.emission = vec3(1.0F);
    return material;
}

std::int32_t ObjMaterials::texture(const std::string& colour_name, const std::string& mask_name,
                                   bool clamp) {
    if (colour_name.empty() && mask_name.empty()) return kNone;
    const std::string key = colour_name + '\n' + mask_name + (clamp ? "\nc" : "\nr");
    if (const auto found = textures_.find(key); found != textures_.end()) return found->second;
    const auto load = [&](const std::string& name) {
        const auto file = folder_.find(trimmed(name));
        if (!file) {
            imported_.scene.notes.push_back(
                fmt::format("texture '{}' is not in the scene's folder: left out", trimmed(name)));
            return RgbaImage{};
        }
        try {
            return decode_image(read_file(*file, std::uint64_t{1} << 30U),
                                context_.settings.max_texture_px);
        } catch (const ImageError& error) {
            fail(context_.file, "its texture '{}' {}", trimmed(name), error.what());
        }
    };
    RgbaImage image = colour_name.empty() ? RgbaImage{} : load(colour_name);
    const RgbaImage mask = mask_name.empty() ? RgbaImage{} : load(mask_name);
    if (!mask.pixels.empty()) {
        if (image.pixels.empty()) image = RgbaImage{1, 1, false, {0xFFFFFFFFU}};
        image = with_alpha_of(std::move(image), mask);
    }
    const bool has_alpha = image.has_alpha_channel;
    return textures_[key] =
               image.pixels.empty()
                   ? kNone
                   : append_texture(imported_, image, {!clamp, !clamp, has_alpha}, context_);
}

}  // namespace foverig::scene_import
