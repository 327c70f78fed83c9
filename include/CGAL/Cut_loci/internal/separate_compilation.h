// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_INTERNAL_SEPARATE_COMPILATION_H
#define CGAL_CUT_LOCI_INTERNAL_SEPARATE_COMPILATION_H

/*
 * What does not depend on the type of the user's mesh is most of the package. It is compiled with each program, as all of
 * CGAL is, or, if `CGAL_CUT_LOCI_SEPARATE_COMPILATION` is defined, once, in the library
 * `CGAL::Surface_mesh_cut_locus`: a header `Name.h` then only declares what `Name_impl.h` defines.
 */
#ifdef CGAL_CUT_LOCI_SEPARATE_COMPILATION
#define CGAL_CUT_LOCI_INLINE
#else
#define CGAL_CUT_LOCI_INLINE inline
#endif

#endif // CGAL_CUT_LOCI_INTERNAL_SEPARATE_COMPILATION_H
