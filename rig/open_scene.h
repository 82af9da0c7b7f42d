#pragma once
#include <memory>

#include "renderer/renderer.h"
#include "rig/scenario/scenario.h"
#include "rig/session/lens_pass.h"

namespace foverig {

/// The scenario's scene with the scenario's lights. Throws UsageError for a name that is neither
/// built in nor a file, with the nearest built-in one; SceneError for a file that cannot be used.
/// `sees_through`: rays that meet nothing bring kNothingMet, so that a display knows them.
std::shared_ptr<const Scene> open_scene(const Scenario& scenario, bool sees_through = false);

/// Throws, without loading anything, where open_scene would as there is no such scene: UsageError
/// for a name, InputError for a file.
void require_scene(const Scenario& scenario);

/// make_renderer, with what it refuses as UsageError.
std::unique_ptr<Renderer> open_renderer(std::shared_ptr<const Scene> scene,
                                        const RenderSettings& settings);

/// The renderer's backend, and of `auto` why it is that one.
std::string backend_text(const Renderer& renderer, const RenderSettings& settings);

/// The distortion pass, or null where the scenario leaves it out.
std::unique_ptr<LensPass> open_lens(const Scenario& scenario);

}  // namespace foverig
