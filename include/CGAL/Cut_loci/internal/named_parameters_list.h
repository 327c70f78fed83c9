// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// The named parameters of the package, in the form of CGAL's own list: no include guard, read several times.
CGAL_add_named_parameter(geodesic_solver_t, geodesic_solver, geodesic_solver)
CGAL_add_named_parameter(vertex_distance_map_t, vertex_distance_map, vertex_distance_map)
CGAL_add_named_parameter(cut_locus_method_t, cut_locus_method, cut_locus_method)
CGAL_add_named_parameter(cut_locus_curve_t, cut_locus_curve, cut_locus_curve)
CGAL_add_named_parameter(kept_part_t, kept_part, kept_part)
CGAL_add_named_parameter(edge_length_map_t, edge_length_map, edge_length_map)
CGAL_add_named_parameter(source_curves_t, source_curves, source_curves)
CGAL_add_named_parameter(source_border_t, source_border, source_border)
CGAL_add_named_parameter(maximum_relative_error_t, maximum_relative_error, maximum_relative_error)
CGAL_add_named_parameter(face_is_excluded_map_t, face_is_excluded_map, face_is_excluded_map)
#if CGAL_VERSION_NR < 1060000000 // has it itself since then
CGAL_add_named_parameter(concurrency_tag_t, concurrency_tag, concurrency_tag)
#endif
