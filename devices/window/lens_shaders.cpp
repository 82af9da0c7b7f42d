#include "devices/window/lens_shaders.h"

#include <fmt/format.h>

#include "devices/display/display.h"

namespace foverig::window {
namespace {

constexpr const char* kInputs = R"(#version 330 core
in vec2 red_tangent;
in vec2 green_tangent;
in vec2 blue_tangent;
uniform sampler2D picture;
uniform vec4 frustum;  // tangents: left, right, up, down
uniform mat3 rendered_from_newest;
out vec4 colour;

// Where a ray lies in the eye's picture, 0..1; else it is not in it.
vec2 place_of(vec2 tangent) {
    vec3 ray = rendered_from_newest * vec3(tangent, -1.0);
    if (ray.z >= 0.0) return vec2(-1.0);
    vec2 t = ray.xy / -ray.z;
    return vec2((t.x + frustum.x) / (frustum.x + frustum.y),
                (frustum.z - t.y) / (frustum.z + frustum.w));
}
bool outside(vec2 at) {
    return any(lessThan(at, vec2(0.0))) || any(greaterThan(at, vec2(1.0)));
}
)";

// Outside the picture is black, as in the lens pass on the CPU.
constexpr const char* kPlainFetch = R"(
vec3 fetch(vec2 tangent) {
    vec2 at = place_of(tangent);
    return outside(at) ? vec3(0.0) : textureLod(picture, at, 0.0).rgb;
}
)";

// The bilinear filter by hand: texels that met nothing give their weight to the camera's picture.
constexpr const char* kSeeingFetch = R"(
uniform sampler2D behind;
uniform vec2 behind_focal;  // its lens, as shares of its width and height
uniform vec2 behind_centre;
uniform vec4 behind_bend;
uniform vec2 behind_tangential;
uniform float behind_farthest;
uniform bool behind_fisheye;
uniform mat3 camera_from_newest;

float radial(float s) {
    vec4 k = behind_bend;
    return 1.0 + s * (k.x + s * (k.y + s * (k.z + s * k.w)));
}

vec3 seen_behind(vec2 tangent) {
    vec3 ray = vec3(1.0, -1.0, -1.0) * (camera_from_newest * vec3(tangent, -1.0));  // z ahead
    vec2 bent;
    if (behind_fisheye) {
        float away = length(ray.xy);
        float angle = atan(away, ray.z);
        if (angle > behind_farthest) return vec3(0.0);
        bent = angle * radial(angle * angle) / max(away, 1e-9) * ray.xy;
    } else {
        vec2 t = ray.xy / ray.z;
        float r2 = dot(t, t);
        if (ray.z <= 0.0 || r2 > behind_farthest * behind_farthest) return vec3(0.0);
        vec2 p = behind_tangential;
        bent = radial(r2) * t + 2.0 * t.x * t.y * p + p.yx * (r2 + 2.0 * t * t);
    }
    return textureLod(behind, behind_centre + behind_focal * bent, 0.0).rgb;
}

vec3 fetch(vec2 tangent) {
    vec2 at = place_of(tangent);
    if (outside(at)) return seen_behind(tangent);
    ivec2 size = textureSize(picture, 0);
    vec2 p = at * vec2(size) - 0.5;
    vec2 far = fract(p);
    ivec2 first = ivec2(floor(p));
    vec3 sum = vec3(0.0);
    float nothing = 0.0;
    for (int i = 0; i < 4; ++i) {
        ivec2 step = ivec2(i & 1, i >> 1);
        vec3 texel = texelFetch(picture, clamp(first + step, ivec2(0), size - 1), 0).rgb;
        vec2 w = mix(1.0 - far, far, vec2(step));
        bool met = any(greaterThan(abs(texel - nothing_met), 0.02 * nothing_met));
        sum += met ? w.x * w.y * texel : vec3(0.0);
        nothing += met ? 0.0 : w.x * w.y;
    }
    return nothing > 0.0 ? sum + nothing * seen_behind(tangent) : sum;
}
)";

constexpr const char* kMain = R"(
vec3 srgb(vec3 linear) {
    vec3 c = clamp(linear, 0.0, 1.0);
    return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, greaterThan(c, vec3(0.0031308)));
}

void main() {
    colour = vec4(srgb(vec3(fetch(red_tangent).r, fetch(green_tangent).g, fetch(blue_tangent).b)),
                  1.0);
}
)";

}  // namespace

const char* const kLensVertexShader = R"(#version 330 core
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

std::string lens_fragment_shader(bool sees_through) {
    if (!sees_through) return std::string(kInputs) + kPlainFetch + kMain;
    const std::string key =
        fmt::format("\nconst vec3 nothing_met = vec3({:.12e}, {:.12e}, {:.12e});\n", kNothingMet[0],
                    kNothingMet[1], kNothingMet[2]);
    return kInputs + key + kSeeingFetch + kMain;
}

}  // namespace foverig::window
