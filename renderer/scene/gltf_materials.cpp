#include "renderer/scene/gltf_materials.h"

#include <algorithm>
#include <cmath>

#include "renderer/scene/gltf_accessor.h"
#include "renderer/scene/image_decode.h"
#include "renderer/scene/import_error.h"
#include "renderer/scene/textures.h"

namespace foverig::scene_import {
namespace {

float clamped(double value, double least, double most) {
    return std::isfinite(value) ? static_cast<float>(std::clamp(value, least, most))
                                : static_cast<float>(least);
}

vec3 colour(const std::vector<double>& c, double most) {
    return c.size() < 3
               ? vec3(1.0F)
               : vec3(clamped(c[0], 0.0, most), clamped(c[1], 0.0, most), clamped(c[2], 0.0, most));
}

/// A number inside an extension's object, or `fallback`.
double extension_number(const tinygltf::ExtensionMap& extensions, const char* extension,
                        const char* key, double fallback) {
    const auto found = extensions.find(extension);
    if (found == extensions.end() || !found->second.IsObject() || !found->second.Has(key))
        return fallback;
    const tinygltf::Value& value = found->second.Get(key);
    return value.IsNumber() ? value.GetNumberAsDouble() : fallback;
}

dvec2 extension_pair(const tinygltf::Value& object, const char* key, const dvec2& fallback) {
    if (!object.IsObject() || !object.Has(key)) return fallback;
    const tinygltf::Value& list = object.Get(key);
    if (!list.IsArray() || list.ArrayLen() < 2 || !list.Get(0).IsNumber() ||
        !list.Get(1).IsNumber())
        return fallback;
    return {list.Get(0).GetNumberAsDouble(), list.Get(1).GetNumberAsDouble()};
}

/// The texture whose coordinates the primitive's vertices will carry.
const tinygltf::TextureInfo& leading_texture(const tinygltf::Material& material) {
    return material.pbrMetallicRoughness.baseColorTexture.index >= 0
               ? material.pbrMetallicRoughness.baseColorTexture
               : material.emissiveTexture;
}

/// Phong's exponent for a GGX roughness: both lobes fall to half at about the same angle.
float phong_exponent(float roughness) {
    const float alpha2 = std::pow(std::max(roughness, 0.05F), 4.0F);
    return std::clamp(2.0F / alpha2 - 2.0F, 1.0F, 10000.0F);
}

}  // namespace

std::uint16_t GltfMaterials::material(int index) {
    if (const auto found = used_.find(index); found != used_.end()) return found->second;
    const Material made =
        index < 0 ? Material{} : converted(model_.materials.at(static_cast<std::size_t>(index)));
    return used_[index] = add_material(imported_, made, context_);
}

TexcoordUse GltfMaterials::texcoord_use(int index) const {
    TexcoordUse use;
    if (index < 0) return use;
    const tinygltf::TextureInfo& info =
        leading_texture(model_.materials.at(static_cast<std::size_t>(index)));
    use.set = info.texCoord;
    const auto found = info.extensions.find("KHR_texture_transform");
    if (found == info.extensions.end() || !found->second.IsObject()) return use;
    const tinygltf::Value& transform = found->second;
    use.set = static_cast<int>(
        extension_number(info.extensions, "KHR_texture_transform", "texCoord", use.set));
    use.offset = vec2(extension_pair(transform, "offset", dvec2(0.0)));
    const vec2 scale(extension_pair(transform, "scale", dvec2(1.0)));
    const auto angle_rad = static_cast<float>(
        extension_number(info.extensions, "KHR_texture_transform", "rotation", 0.0));
    const float c = std::cos(angle_rad);
    const float s = std::sin(angle_rad);
    use.turn = glm::mat2(vec2(c, -s) * scale.x, vec2(s, c) * scale.y);
    return use;
}

Material GltfMaterials::converted(const tinygltf::Material& gltf) {
    const tinygltf::PbrMetallicRoughness& pbr = gltf.pbrMetallicRoughness;
    const vec3 base = colour(pbr.baseColorFactor, 1.0);
    const float opacity =
        pbr.baseColorFactor.size() == 4 ? clamped(pbr.baseColorFactor[3], 0.0, 1.0) : 1.0F;
    const bool opaque = gltf.alphaMode == "OPAQUE";

    Material material;
    material.diffuse_texture = texture(pbr.baseColorTexture, !opaque);
    // A texture in the place of metalness and roughness scales the factors; its average is not
    // known here, and a surface that is metal only in places is better shown as none.
    const bool varied = pbr.metallicRoughnessTexture.index >= 0;
    const float metal = varied ? 0.0F : clamped(pbr.metallicFactor, 0.0, 1.0);
    const float roughness = varied ? std::max(0.6F, clamped(pbr.roughnessFactor, 0.0, 1.0))
                                   : clamped(pbr.roughnessFactor, 0.0, 1.0);
    const float polish = (1.0F - roughness) * (1.0F - roughness);
    material.specular = (vec3(0.04F) * (1.0F - metal) + base * metal) * polish;
    material.diffuse = base * (1.0F - 0.5F * metal);
    material.shininess = phong_exponent(roughness);
    material.reflectance = metal * polish * std::max({base.x, base.y, base.z});
    material.transmission = clamped(
        extension_number(gltf.extensions, "KHR_materials_transmission", "transmissionFactor", 0.0),
        0.0, 1.0);
    material.ior =
        clamped(extension_number(gltf.extensions, "KHR_materials_ior", "ior", 1.5), 1.0, 4.0);

    const double strength = extension_number(gltf.extensions, "KHR_materials_emissive_strength",
                                             "emissiveStrength", 1.0);
    if (gltf.emissiveFactor.size() == 3)
        material.emission = colour(gltf.emissiveFactor, 1.0e6) * clamped(strength, 0.0, 1.0e6);
    if (material.emission != vec3(0.0F))
        material.emission_texture = texture(gltf.emissiveTexture, false);

    const bool holes =
        material.diffuse_texture >= 0 &&
        imported_.scene.textures[static_cast<std::size_t>(material.diffuse_texture)].has_alpha;
    if (gltf.alphaMode == "MASK" && holes && opacity > 0.0F)
        material.alpha_cutoff = clamped(gltf.alphaCutoff / static_cast<double>(opacity), 0.0, 1.0);
    if (gltf.alphaMode == "BLEND") {
        material.transmission = std::max(material.transmission, 1.0F - opacity);
        if (holes) material.alpha_cutoff = 0.5F;
    }
    return material;
}

std::int32_t GltfMaterials::texture(const tinygltf::TextureInfo& info, bool alpha) {
    if (info.index < 0) return kNone;
    const auto [found, fresh] = textures_.try_emplace({info.index, alpha}, kNone);
    if (fresh) found->second = texture(info.index, alpha);
    return found->second;
}

std::int32_t GltfMaterials::texture(int index, bool alpha) {
    const tinygltf::Texture& gltf = model_.textures.at(static_cast<std::size_t>(index));
    if (gltf.source < 0) {
        imported_.scene.notes.push_back(
            fmt::format("textures[{}] has no source that can be read: left out", index));
        return kNone;
    }
    const std::string bytes = encoded_image(gltf.source);
    if (bytes.empty()) {
        imported_.scene.notes.push_back(
            fmt::format("image '{}' is not in the scene's folder: left out",
                        model_.images[static_cast<std::size_t>(gltf.source)].uri.substr(0, 80)));
        return kNone;
    }
    TextureUse use{true, true, alpha};
    if (gltf.sampler >= 0) {
        const tinygltf::Sampler& sampler =
            model_.samplers.at(static_cast<std::size_t>(gltf.sampler));
        use.repeat_u = sampler.wrapS != TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE;
        use.repeat_v = sampler.wrapT != TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE;
    }
    try {
        return append_texture(imported_, decode_image(bytes, context_.settings.max_texture_px), use,
                              context_);
    } catch (const ImageError& error) {
        fail(context_.file, "its images[{}] {}", gltf.source, error.what());
    }
}

std::string GltfMaterials::encoded_image(int index) const {
    const tinygltf::Image& image = model_.images.at(static_cast<std::size_t>(index));
    if (image.bufferView >= 0) {
        const auto bytes = view_bytes(model_, image.bufferView, context_);
        return {bytes.begin(), bytes.end()};
    }
    if (!image.image.empty()) return {image.image.begin(), image.image.end()};
    const auto file = folder_.find(percent_decoded(image.uri));
    return file ? read_file(*file, std::uint64_t{1} << 30U) : std::string();
}

}  // namespace foverig::scene_import
