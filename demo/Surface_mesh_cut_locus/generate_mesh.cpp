// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// Writes sample surfaces as OFF: generate_mesh SHAPE SIZE FILE. SIZE is the number of edges along a characteristic
// line, so the number of faces grows with its square.

#include "test_meshes.h"

#include <cstdlib>
#include <fstream>
#include <functional>
#include <iomanip>
#include <iostream>
#include <map>
#include <string>

namespace {

using namespace test_meshes;

const std::map<std::string, std::function<Mesh_data(int)>>& shapes()
{
  static const std::map<std::string, std::function<Mesh_data(int)>> result = {
    {"torus", [](int n) { return torus(1., 0.4, 5 * n / 2, n, 0.2, 1); }},
    {"sphere", [](int n) { return jittered_sphere(n, 0.15, 1); }},
    {"sphere-with-bump",
     [](int n) {
    return sphere_with_bump(n, {{1., 0., 0.}}, 0.15, 0.08);
     }},
    {"bumpy-sphere", [](int n) { return bumpy_sphere(n, 0.5, 1); }},
    {"irregular-bumpy-sphere", [](int n) { return irregular_bumpy_sphere(n, 0.5, 1); }},
    {"remeshed-bumpy-sphere", [](int n) { return remeshed(irregular_bumpy_sphere(n, 0.5, 1)); }},
    {"rough-sphere", [](int n) { return rough(bumpy_sphere(n, 0.5, 1), 0.1, 1); }},
    {"ellipsoid", [](int n) { return ellipsoid(1., 0.8, 0.6, n, 0.1, 1); }},
    {"capsule", [](int n) { return capsule(1., 2 * n, 2 * n); }},
    {"square", [](int n) { return square(n, 0.2, 1); }},
    {"rounded-genus-3", [](int n) { return remeshed(rounded_plate(3, 1, n)); }},
    {"rounded-genus-56", [](int n) { return remeshed(rounded_plate(8, 7, n)); }},
    {"genus-3", [](int n) { return perforated_plate(3, 1, n, 1); }},
    {"genus-56", [](int n) { return perforated_plate(8, 7, n, 1); }}};
  return result;
}

} // namespace

int main(int argc, char** argv)
{
  const auto shape = argc == 4 ? shapes().find(argv[1]) : shapes().end();
  const int size = argc == 4 ? std::atoi(argv[2]) : 0;
  if(shape == shapes().end() || size < 1)
  {
    std::cerr << "Usage: generate_mesh SHAPE SIZE FILE.off, with SIZE > 0 and SHAPE one of:\n";
    for(const auto& s : shapes())
      std::cerr << "  " << s.first << "\n";
    return EXIT_FAILURE;
  }
  const Mesh_data mesh = shape->second(size);
  std::ofstream out(argv[3]);
  out << "OFF\n" << mesh.points.size() << " " << mesh.triangles.size() << " 0\n" << std::setprecision(17);
  for(const Point& p : mesh.points)
    out << p[0] << " " << p[1] << " " << p[2] << "\n";
  for(const Triangle& t : mesh.triangles)
    out << "3 " << t[0] << " " << t[1] << " " << t[2] << "\n";
  if(!out.flush())
  {
    std::cerr << "generate_mesh: cannot write " << argv[3] << "\n";
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
