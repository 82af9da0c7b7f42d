#include "devices/window/shader_program.h"

#include <fmt/format.h>

namespace foverig::window {
namespace {

/// Of a shader or a program.
template <class GetInt, class GetLog>
std::string log_of(GLuint name, GetInt get_int, GetLog get_log) {
    GLint size = 0;
    get_int(name, GL_INFO_LOG_LENGTH, &size);
    std::string text(static_cast<std::size_t>(size), '\0');
    get_log(name, size, &size, text.data());
    text.resize(static_cast<std::size_t>(size));
    return text;
}

Result<GLuint> compiled(GLenum kind, const char* source) {
    const GLuint shader = glCreateShader(kind);
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    GLint good = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
    if (good == GL_TRUE) return shader;
    const std::string log = log_of(shader, glGetShaderiv, glGetShaderInfoLog);
    glDeleteShader(shader);
    return Error{ErrorCode::unsupported,
                 fmt::format("the graphics driver refuses a {} shader: {}",
                             kind == GL_VERTEX_SHADER ? "vertex" : "fragment", log)};
}

}  // namespace

Result<GlProgram> link_program(const char* vertex_source, const char* fragment_source) {
    GlProgram program;
    for (const auto& [kind, source] :
         {std::pair{GL_VERTEX_SHADER, vertex_source}, {GL_FRAGMENT_SHADER, fragment_source}}) {
        const Result<GLuint> shader = compiled(static_cast<GLenum>(kind), source);
        if (!shader) return shader.error();
        glAttachShader(program.name(), *shader);
        glDeleteShader(*shader);  // lives on in the program
    }
    glLinkProgram(program.name());
    GLint good = GL_FALSE;
    glGetProgramiv(program.name(), GL_LINK_STATUS, &good);
    if (good == GL_TRUE) return program;
    return Error{ErrorCode::unsupported,
                 "the graphics driver cannot link a program: " +
                     log_of(program.name(), glGetProgramiv, glGetProgramInfoLog)};
}

}  // namespace foverig::window
