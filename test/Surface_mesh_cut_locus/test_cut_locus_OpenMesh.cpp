// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <CGAL/boost/graph/graph_traits_PolyMesh_ArrayKernelT.h>
#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>

#include "built_mesh.h"

#include <gtest/gtest.h>

struct Double_traits : public OpenMesh::DefaultTraits
{
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};

using Mesh_types = ::testing::Types<Built_mesh<OpenMesh::PolyMesh_ArrayKernelT<Double_traits>>,
                                    Built_mesh<OpenMesh::TriMesh_ArrayKernelT<Double_traits>>>;

#include "cut_locus_cases.h"
