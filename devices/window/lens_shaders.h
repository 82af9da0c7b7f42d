#pragma once
#include <string>

namespace foverig::window {

extern const char* const kLensVertexShader;

/// `sees_through`: what met nothing (kNothingMet), or lies beyond the picture, shows a camera's.
std::string lens_fragment_shader(bool sees_through);

}  // namespace foverig::window
