// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_DEMO_OPTION_DESCRIPTIONS_H
#define SURFACE_MESH_CUT_LOCUS_DEMO_OPTION_DESCRIPTIONS_H

#include <boost/program_options.hpp>

#include <string>
#include <utility>
#include <vector>

// Captions, and options.
std::vector<std::pair<std::string, boost::program_options::options_description>> option_groups();

boost::program_options::options_description all_options();

// The words that an option takes, and the extensions of its file, by the name of its value; nothing if it takes any.
std::vector<std::string> choices(const boost::program_options::option_description& option);
std::vector<std::string> file_extensions(const boost::program_options::option_description& option);

// What most runs need, with examples.
std::string help();
std::string help_on_all();
std::string version();
std::string purpose(); // what the program does, in a sentence

#endif
