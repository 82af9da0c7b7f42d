#include "devices/window/lens_painter.h"

#include <glm/gtc/type_ptr.hpp>

#include <cstddef>

#include "devices/window/lens_shaders.h"

namespace foverig::window {
namespace {

void attribute(GLuint index, std::size_t offset) {
    glEnableVertexAttribArray(index);
    glVertexAttribPointer(index, 2, GL_FLOAT, GL_FALSE, sizeof(LensVertex),
                          reinterpret_cast<const void*>(offset));
}

constexpr std::array<Eye, 2> kEyes{Eye::left, Eye::right};

}  // namespace

LensPainter::Shader::Shader(GlProgram linked)
    : program(std::move(linked)),
      turn(glGetUniformLocation(program.name(), "viewport_from_panel")),
      frustum(glGetUniformLocation(program.name(), "frustum")),
      warp(glGetUniformLocation(program.name(), "rendered_from_newest")),
      behind(glGetUniformLocation(program.name(), "behind")),
      behind_focal(glGetUniformLocation(program.name(), "behind_focal")),
      behind_centre(glGetUniformLocation(program.name(), "behind_centre")),
      behind_bend(glGetUniformLocation(program.name(), "behind_bend")),
      behind_tangential(glGetUniformLocation(program.name(), "behind_tangential")),
      behind_farthest(glGetUniformLocation(program.name(), "behind_farthest")),
      behind_fisheye(glGetUniformLocation(program.name(), "behind_fisheye")),
      camera(glGetUniformLocation(program.name(), "camera_from_newest")) {}

Result<LensPainter> LensPainter::make(const EyeMap& map, bool sees_through) {
    Result<GlProgram> plain = link_program(kLensVertexShader, lens_fragment_shader(false).c_str());
    if (!plain) return plain.error();
    LensPainter painter(std::move(plain).value(), map);
    if (!sees_through) return painter;
    auto seen_through = link_program(kLensVertexShader, lens_fragment_shader(true).c_str());
    if (!seen_through) return seen_through.error();
    painter.seen_through_.emplace(std::move(seen_through).value());
    painter.behind_.emplace();
    return painter;
}

LensPainter::LensPainter(GlProgram program, const EyeMap& map)
    : plain_(std::move(program)), map_(map) {
    for (std::size_t i = 0; i < kEyes.size(); ++i) meshes_[i] = uploaded(lens_mesh(kEyes[i], map_));
}

LensPainter::EyeMesh LensPainter::uploaded(const LensMesh& mesh) {
    EyeMesh made;
    glBindVertexArray(made.array.name());
    glBindBuffer(GL_ARRAY_BUFFER, made.vertices.name());
    glBufferData(GL_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(mesh.vertices.size() * sizeof(LensVertex)),
                 mesh.vertices.data(), GL_STATIC_DRAW);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, made.indices.name());
    glBufferData(GL_ELEMENT_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(mesh.indices.size() * sizeof(std::uint32_t)),
                 mesh.indices.data(), GL_STATIC_DRAW);
    attribute(0, offsetof(LensVertex, x));
    attribute(1, offsetof(LensVertex, red_x));
    attribute(2, offsetof(LensVertex, green_x));
    attribute(3, offsetof(LensVertex, blue_x));
    glBindVertexArray(0);
    made.index_count = static_cast<GLsizei>(mesh.indices.size());
    return made;
}

void LensPainter::fill(Eye eye, const EyePicture& picture) {
    textures_[static_cast<std::size_t>(eye)].fill(picture);
}

void LensPainter::fill(const BehindPicture& picture) {
    behind_->fill(picture);
}

void LensPainter::paint(const PanelView& view, std::size_t eyes,
                        const std::array<dmat3, 2>& rendered_from_newest,
                        const std::optional<std::array<dmat3, 2>>& camera_from_newest) const {
    const Shader& shader = camera_from_newest ? *seen_through_ : plain_;
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_BLEND);
    glClearColor(0.0F, 0.0F, 0.0F, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT);
    const PanelView::Rectangle& r = view.viewport();
    glViewport(r.x_px, r.y_px, r.width_px, r.height_px);
    glUseProgram(shader.program.name());
    const glm::mat2 turn(view.viewport_from_panel());
    glUniformMatrix2fv(shader.turn, 1, GL_FALSE, glm::value_ptr(turn));
    if (camera_from_newest) {
        glActiveTexture(GL_TEXTURE1);
        glBindTexture(GL_TEXTURE_2D, behind_->name());
        glUniform1i(shader.behind, 1);
        const BehindTexture::Lens& lens = behind_->lens();
        glUniform2fv(shader.behind_focal, 1, glm::value_ptr(lens.focal));
        glUniform2fv(shader.behind_centre, 1, glm::value_ptr(lens.centre));
        glUniform4fv(shader.behind_bend, 1, glm::value_ptr(lens.bend));
        glUniform2fv(shader.behind_tangential, 1, glm::value_ptr(lens.tangential));
        glUniform1f(shader.behind_farthest, lens.farthest);
        glUniform1i(shader.behind_fisheye, lens.fisheye ? 1 : 0);
    }
    glActiveTexture(GL_TEXTURE0);
    for (std::size_t i = 0; i < eyes; ++i) {
        const TangentFrustum f = map_.frustum(kEyes[i]);
        glUniform4f(shader.frustum, static_cast<float>(f.left), static_cast<float>(f.right),
                    static_cast<float>(f.up), static_cast<float>(f.down));
        const glm::mat3 warp(rendered_from_newest[i]);
        glUniformMatrix3fv(shader.warp, 1, GL_FALSE, glm::value_ptr(warp));
        if (camera_from_newest) {
            const glm::mat3 turned((*camera_from_newest)[i]);
            glUniformMatrix3fv(shader.camera, 1, GL_FALSE, glm::value_ptr(turned));
        }
        glBindTexture(GL_TEXTURE_2D, textures_[i].name());
        glBindVertexArray(meshes_[i].array.name());
        glDrawElements(GL_TRIANGLES, meshes_[i].index_count, GL_UNSIGNED_INT, nullptr);
    }
    glBindVertexArray(0);
}

}  // namespace foverig::window
