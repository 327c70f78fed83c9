// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_BENCHMARK_COMMAND_LINE_H
#define SURFACE_MESH_CUT_LOCUS_BENCHMARK_COMMAND_LINE_H

#include "jittered_torus.h"
#include "mesh_files.h"

#include <boost/program_options.hpp>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

// What the benchmarks have in common that take options. An error ends the program.
namespace command_line {

[[noreturn]] inline void fail(const std::string& message)
{
  std::cerr << message << "\n";
  std::exit(EXIT_FAILURE);
}

// Reads the command line; words that are no options are values of `positional`. `--help` ends the program, too.
inline boost::program_options::variables_map read(int argc, char** argv,
                                                  const boost::program_options::options_description& options,
                                                  const char* positional = nullptr)
{
  namespace po = boost::program_options;
  po::variables_map values;
  po::positional_options_description words;
  if(positional != nullptr)
    words.add(positional, -1);
  try
  {
    po::store(po::command_line_parser(argc, argv).options(options).positional(words).run(), values);
    po::notify(values);
  }
  catch(const po::error& error)
  {
    fail(error.what());
  }
  if(values.count("help"))
  {
    std::cout << options;
    std::exit(EXIT_SUCCESS);
  }
  return values;
}

template <typename Mesh>
Mesh read_mesh(const std::string& file)
{
  try
  {
    return test_meshes::read_surface_mesh<Mesh>(file);
  }
  catch(const std::exception& error)
  {
    fail(error.what());
  }
}

// Calls `measure(name, mesh)` for jittered tori of about so many faces, and for files.
template <typename Mesh, typename Measure>
void for_each_mesh(const std::vector<std::size_t>& tori, const std::vector<std::string>& files, const Measure& measure)
{
  try
  {
    for(std::size_t faces : tori)
    {
      const auto m = static_cast<std::size_t>(std::sqrt(0.2 * double(faces)));
      measure("jittered_torus", jittered_torus<Mesh>(5 * m / 2, m));
    }
    for(const std::string& file : files)
      measure(file.substr(file.find_last_of('/') + 1), read_mesh<Mesh>(file));
  }
  catch(const std::exception& error)
  {
    fail(error.what());
  }
}

} // namespace command_line

#endif // SURFACE_MESH_CUT_LOCUS_BENCHMARK_COMMAND_LINE_H
