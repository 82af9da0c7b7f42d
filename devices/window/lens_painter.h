#pragma once
// Draws the eyes' pictures through the lenses into the framebuffer that is bound: late warp, lens
// distortion, chromatic correction, sRGB, in one pass.
#include <array>
#include <optional>

#include "devices/display/lens_mesh.h"
#include "devices/display/panel_view.h"
#include "devices/window/eye_texture.h"
#include "devices/window/shader_program.h"

namespace foverig::window {

class LensPainter {
  public:
    /// Needs a current OpenGL 3.3 context for life.
    static Result<LensPainter> make(const EyeMap& map);

    void fill(Eye eye, const EyePicture& picture);

    /// Both eyes (or the left one), black elsewhere. `rendered_from_newest`: directions in the
    /// eye's axes now to those of the head that the picture was rendered for; the identity is no
    /// warp.
    void paint(const PanelView& view, std::size_t eyes,
               const std::array<dmat3, 2>& rendered_from_newest) const;

  private:
    struct EyeMesh {
        GlVertexArray array;
        GlBuffer vertices, indices;
        GLsizei index_count = 0;
    };
    LensPainter(GlProgram program, const EyeMap& map);
    static EyeMesh uploaded(const LensMesh& mesh);

    GlProgram program_;
    EyeMap map_;
    std::array<EyeMesh, 2> meshes_;
    std::array<EyeTexture, 2> textures_;
    GLint turn_, frustum_, warp_;
};

}  // namespace foverig::window
