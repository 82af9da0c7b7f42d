#pragma once
#include "renderer/scene/imported.h"

namespace foverig::scene_import {

/// Gives every vertex a unit normal. A mesh without normals gets angle-weighted ones over faces
/// that share a position, not smoothed across edges sharper than `crease_deg` (vertices are split
/// there). Normals that are zero or not finite are replaced by the average of their triangles'
/// normals.
void complete_normals(ImportedMesh& mesh, double crease_deg = 40.0);

/// Drops triangles with a corner that is not finite; gives their number.
std::size_t drop_non_finite(ImportedMesh& mesh);

}  // namespace foverig::scene_import
