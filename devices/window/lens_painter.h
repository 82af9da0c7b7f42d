#pragma once
// Draws the eyes' pictures through the lenses into the framebuffer that is bound: late warp, lens
// distortion, chromatic correction, sRGB, in one pass.
#include <array>
#include <optional>

#include "devices/display/lens_mesh.h"
#include "devices/display/panel_view.h"
#include "devices/window/behind_texture.h"
#include "devices/window/eye_texture.h"
#include "devices/window/shader_program.h"

namespace foverig::window {

class LensPainter {
  public:
    /// Needs a current OpenGL 3.3 context for life. `sees_through`: a camera's picture can be shown
    /// behind the eyes'; else there is nothing of it.
    static Result<LensPainter> make(const EyeMap& map, bool sees_through = false);

    void fill(Eye eye, const EyePicture& picture);
    void fill(const BehindPicture& picture);

    /// Both eyes (or the left one), black elsewhere. `rendered_from_newest`: directions in the
    /// eye's axes now to those of the head that the picture was rendered for; the identity is no
    /// warp. `camera_from_newest`: the same to the axes of a camera that sees through; absent: its
    /// picture is not shown.
    void paint(const PanelView& view, std::size_t eyes,
               const std::array<dmat3, 2>& rendered_from_newest,
               const std::optional<std::array<dmat3, 2>>& camera_from_newest = {}) const;

  private:
    struct EyeMesh {
        GlVertexArray array;
        GlBuffer vertices, indices;
        GLsizei index_count = 0;
    };
    /// A program and where its inputs lie.
    struct Shader {
        explicit Shader(GlProgram linked);
        GlProgram program;
        GLint turn, frustum, warp, behind, behind_focal, behind_centre, behind_bend,
            behind_tangential, behind_farthest, behind_fisheye, camera;
    };
    LensPainter(GlProgram program, const EyeMap& map);
    static EyeMesh uploaded(const LensMesh& mesh);

    Shader plain_;
    std::optional<Shader> seen_through_;
    std::optional<BehindTexture> behind_;
    EyeMap map_;
    std::array<EyeMesh, 2> meshes_;
    std::array<EyeTexture, 2> textures_;
};

}  // namespace foverig::window
