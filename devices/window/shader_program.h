#pragma once
#include "devices/result.h"
#include "devices/window/gl_objects.h"

namespace foverig::window {

/// Vertex and fragment shader in one program; the error carries the driver's log.
Result<GlProgram> link_program(const char* vertex_source, const char* fragment_source);

}  // namespace foverig::window
