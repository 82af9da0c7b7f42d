#include "devices/window/lens_painter.h"

#include <glm/gtc/type_ptr.hpp>

#include <cstddef>

namespace foverig::window {
namespace {

constexpr const char* kVertexShader = R"(#version 330 core
layout(location = 0) in vec2 place;
layout(location = 1) in vec2 red_at;
layout(location = 2) in vec2 green_at;
layout(location = 3) in vec2 blue_at;
uniform mat2 viewport_from_panel;
out vec2 red_tangent;
out vec2 green_tangent;
out vec2 blue_tangent;
void main() {
    gl_Position = vec4(viewport_from_panel * place, 0.0, 1.0);
    red_tangent = red_at;
    green_tangent = green_at;
    blue_tangent = blue_at;
}
)";

// Outside the picture is black, as in the lens pass on the CPU.
constexpr const char* kFragmentShader = R"(#version 330 core
in vec2 red_tangent;
in vec2 green_tangent;
in vec2 blue_tangent;
uniform sampler2D picture;
uniform vec4 frustum;  // tangents: left, right, up, down
uniform mat3 rendered_from_newest;
out vec4 colour;

vec3 fetch(vec2 tangent) {
    vec3 ray = rendered_from_newest * vec3(tangent, -1.0);
    if (ray.z >= 0.0) return vec3(0.0);
    vec2 t = ray.xy / -ray.z;
    vec2 at = vec2((t.x + frustum.x) / (frustum.x + frustum.y),
                   (frustum.z - t.y) / (frustum.z + frustum.w));
    if (any(lessThan(at, vec2(0.0))) || any(greaterThan(at, vec2(1.0)))) return vec3(0.0);
    return textureLod(picture, at, 0.0).rgb;
}

vec3 srgb(vec3 linear) {
    vec3 c = clamp(linear, 0.0, 1.0);
    return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, greaterThan(c, vec3(0.0031308)));
}

void main() {
    colour = vec4(srgb(vec3(fetch(red_tangent).r, fetch(green_tangent).g, fetch(blue_tangent).b)),
                  1.0);
}
)";

void attribute(GLuint index, std::size_t offset) {
    glEnableVertexAttribArray(index);
    glVertexAttribPointer(index, 2, GL_FLOAT, GL_FALSE, sizeof(LensVertex),
                          reinterpret_cast<const void*>(offset));
}

constexpr std::array<Eye, 2> kEyes{Eye::left, Eye::right};

}  // namespace

Result<LensPainter> LensPainter::make(const EyeMap& map) {
    Result<GlProgram> program = link_program(kVertexShader, kFragmentShader);
    if (!program) return program.error();
    return LensPainter(std::move(program).value(), map);
}

LensPainter::LensPainter(GlProgram program, const EyeMap& map)
    : program_(std::move(program)),
      map_(map),
      turn_(glGetUniformLocation(program_.name(), "viewport_from_panel")),
      frustum_(glGetUniformLocation(program_.name(), "frustum")),
      warp_(glGetUniformLocation(program_.name(), "rendered_from_newest")) {
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

void LensPainter::paint(const PanelView& view, std::size_t eyes,
                        const std::array<dmat3, 2>& rendered_from_newest) const {
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_BLEND);
    glClearColor(0.0F, 0.0F, 0.0F, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT);
    const PanelView::Rectangle& r = view.viewport();
    glViewport(r.x_px, r.y_px, r.width_px, r.height_px);
    glUseProgram(program_.name());
    const glm::mat2 turn(view.viewport_from_panel());
    glUniformMatrix2fv(turn_, 1, GL_FALSE, glm::value_ptr(turn));
    glActiveTexture(GL_TEXTURE0);
    for (std::size_t i = 0; i < eyes; ++i) {
        const TangentFrustum f = map_.frustum(kEyes[i]);
        glUniform4f(frustum_, static_cast<float>(f.left), static_cast<float>(f.right),
                    static_cast<float>(f.up), static_cast<float>(f.down));
        const glm::mat3 warp(rendered_from_newest[i]);
        glUniformMatrix3fv(warp_, 1, GL_FALSE, glm::value_ptr(warp));
        glBindTexture(GL_TEXTURE_2D, textures_[i].name());
        glBindVertexArray(meshes_[i].array.name());
        glDrawElements(GL_TRIANGLES, meshes_[i].index_count, GL_UNSIGNED_INT, nullptr);
    }
    glBindVertexArray(0);
}

}  // namespace foverig::window
