#pragma once
// One generator per built-in scene; see builtin.cpp for what each shows. detail > 0 scales the
// count of triangles.
#include "renderer/scene/scene.h"

namespace foverig::builtin {

Scene make_cornell(double detail);
Scene make_atrium(double detail);
Scene make_tunnel_geom(double detail);
Scene make_tunnel_maps(double detail);
Scene make_voxel_town(double detail);
Scene make_city(double detail);

/// How many times finer to divide a surface in each direction, and at least `least`.
int finer(int count, double detail, int least);

}  // namespace foverig::builtin
