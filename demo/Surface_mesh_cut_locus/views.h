// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_DEMO_VIEWS_H
#define SURFACE_MESH_CUT_LOCUS_DEMO_VIEWS_H

#include "Scene.h"

#include <vector>

namespace picture {

View look_from(const Vector& toward, const Vector& up);

// The axis that points upwards: the shortest one of a flat scene, else y, as most models have it.
Vector guess_up(const Scene& scene);

// Two views: one that shows `front`, and one from the other side that shows `back` and what the first one hides of the
// polylines; of the directions that do, those are taken from which much of the surface is seen.
std::vector<View> choose_two_views(const Scene& scene, const Vector& front, const Vector& back);

} // namespace picture

#endif // SURFACE_MESH_CUT_LOCUS_DEMO_VIEWS_H
