// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_DEMO_PACKING_H
#define SURFACE_MESH_CUT_LOCUS_DEMO_PACKING_H

#include "charts.h"

#include <vector>

// Charts in a square, none closer to another or to the border than `margin_of_packing` of its side.
struct Packing
{
  struct Place
  {
    UV corner = {{0., 0.}}; // the lower left one
    bool is_turned = false; // by half a turn
  };

  // Where a vertex of a chart is, in the unit square.
  UV operator()(const Chart& chart, const Place& place, Mesh::Vertex_index v) const;

  std::vector<Place> places; // of the charts
  double side = 0.;          // of the square
};

constexpr double margin_of_packing = 1. / 128.;

// Packs charts that are placed: the highest ones first, each where its top is lowest above what is there already, upright
// or upside down, as its outline and not the box around it allows [Levy, Petitjean, Ray, Maillot: Least squares conformal maps for automatic
// texture atlas generation, 2002]. Of squares found by bisection the least into which all go.
Packing pack(const Charts& charts);

#endif // SURFACE_MESH_CUT_LOCUS_DEMO_PACKING_H
