#pragma once
#include <string>
#include <utility>

#include "renderer/scene/builtin/canvas.h"
#include "renderer/scene/builtin/mesh.h"
#include "renderer/scene/scene.h"

namespace foverig::builtin {

/// Puts meshes, textures and lights together as a Scene whose arrays agree.
class SceneBuilder {
  public:
    explicit SceneBuilder(std::string name) { scene_.name = std::move(name); }

    std::uint16_t add_material(const Material& material);
    /// A material of that colour (linear) and nothing else.
    std::uint16_t add_matte(const vec3& colour);
    /// A white material with that texture; `shine` is a grey specular share with exponent 32.
    std::uint16_t add_textured(const Canvas& canvas, float shine = 0.0F);
    /// The same with holes where the texture's alpha is below one half.
    std::uint16_t add_cut_out(const Canvas& canvas);
    std::uint16_t add_glowing(const vec3& radiance);
    std::int32_t add_texture(const Canvas& canvas);

    /// Empty meshes add nothing. The part's vertices are its own.
    void add_part(Mesh&& mesh, bool alpha_masked = false);
    void add_moving_part(Mesh&& mesh, const Motion& motion);

    Scene& scene() { return scene_; }
    /// Bounds, and texcoords dropped where no material has a texture. Ends the building.
    Scene finish();

  private:
    Scene scene_;
};

}  // namespace foverig::builtin
