// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "option_descriptions.h"
#include "file_checks.h"
#include "output.h"
#include "solvers.h"

#include <CGAL/version.h>

#include <sstream>
#include <vector>

namespace po = boost::program_options;

namespace {

constexpr unsigned columns = 110, columns_of_text = 70; // what is wider in front of the text has a line of its own

po::typed_value<std::string>* text(const std::string& name)
{
  return po::value<std::string>()->value_name(name);
}

po::typed_value<std::vector<std::string>>* texts(const std::string& name)
{
  return po::value<std::vector<std::string>>()->value_name(name);
}

// "a|b" of " .a .b" or " a b"
std::string with_bars(const std::string& names)
{
  std::istringstream words(names);
  std::string result;
  for(std::string word; words >> word;)
    result += (result.empty() ? "" : "|") + word.substr(word[0] == '.' ? 1 : 0);
  return result;
}

// "a", "b" of "a|b (=a)"
std::vector<std::string> words_of(const po::option_description& option)
{
  const std::string value = option.format_parameter();
  std::istringstream name(value.substr(0, value.find(' ')));
  std::vector<std::string> result(1);
  for(std::string word; std::getline(name, word, '|');)
    result.back().empty() ? result.back() = word : result.emplace_back(word);
  return result;
}

po::options_description input()
{
  po::options_description result;
  auto add = result.add_options();
  add("input-format", text(with_bars(input_formats())),
      "the format of the mesh (default: by the extension; if MESH is -, standard input, by its first words)");
  add("repair", text("weld|orient|none")->default_value("weld"),
      "weld: of any file with faces a mesh of triangles is made, and a line says how; border edges "
      "that lie on each other, two by two, are joined up to 1e-7 of the diagonal of the bounding box; "
      "the vertices keep the numbers of the file, and edges that are not in it are marked. orient: the "
      "same, but nothing is joined. none: a file that is no mesh of triangles is refused");
  return result;
}

po::options_description sources()
{
  po::options_description result;
  auto add = result.add_options();
  add("source", texts("V"),
      "vertex of the file, counted from 0 (default: the first one of the component with the largest area); repeatable, "
      "for "
      "the Voronoi diagram of several with the cut loci in its cells");
  add("source-point", texts("X,Y,Z"), "the point of the surface closest to x,y,z; repeatable, also with --source");
  add("sources", text("FILE"), "the vertices whose numbers are in this file");
  add("source-edges", text("FILE"),
      "curves along edges of the mesh: each line of the file has the numbers of the vertices along some edges, and all "
      "edges that are connected are one source");
  add("source-border", po::bool_switch(),
      "each border loop: of a flat mesh, its medial axis. Points, curves and the border may be mixed");
  add("from-view", text("X,Y,Z"),
      "the vertex that is nearest to somebody who looks from this direction: the cut locus, and so seams, are behind. "
      "With --uv and --seams that of each component");
  add("each-source", text("FILE"),
      "a cut locus for each source of a file, one on a line: a vertex, or x,y,z. The file of -o must end in .jsonl: it "
      "gets a line of JSON for each, with the injectivity radius, other figures and the polylines; --report gets a "
      "summary. Until all are there, their file is FILE.jsonl.part: the same command goes on where it was stopped");
  add("part", text("I/N"),
      "only the sources of the I-th of N parts of that file; the outputs of all parts, one after another, are that of "
      "one run");
  return result;
}

po::options_description method()
{
  po::options_description result;
  auto add = result.add_options();
  add("solver", text(with_bars(solver_names()))->default_value(default_solver_name()),
      ("geodesic distances by:\n" + solver_descriptions()).c_str());
  add("max-relative-error", text("E"),
      "lets the distances of the solver exact be longer by this share of their length, up to 0.1, with the methods "
      "default and laplacian: faster on smooth meshes of 100 000 faces and more, where 1e-5 moves the curve by a "
      "hundredth of an edge at most, in the mean (default: 0)");
  add("method", text("auto|default|polyhedral|laplacian")->default_value("auto"),
      ("how the cut locus is found:\n"
       "  auto: " +
       default_methods() +
       "\n"
       "  default: where the direction at the source jumps, without the branches of the mesh and its noise; with the "
       "solver exact\n"
       "  polyhedral: all of the cut locus of the polyhedron; with the solver exact\n"
       "  laplacian: valleys of the Laplacian of the distance, with any solver")
        .c_str());
  add("threads", text("N"),
      "threads; 0: as many as the machine has (default: 1). They are worth most with --each-source: distances from one "
      "source take one");
  return result;
}

po::options_description shown()
{
  po::options_description result;
  auto add = result.add_options();
  add(
    "curve", text("edges|faces"),
    "the curve that all outputs are about is made of segments through the faces of the mesh, or of its edges (default: "
    "faces; edges with --edges, --seams, --uv and --smooth 0)");
  add("min-branch-width", text("W"),
      "the two shortest paths to a branch must be as far apart as this somewhere, in units of the diagonal of the "
      "bounding box, at most 1, with the methods default and polyhedral (default: with default what the mesh "
      "resolves, or a quarter of that in limbs and at corners; 0 with polyhedral, or if there is a --min-branch-gap)");
  add("min-branch-curvature", text("RAD"),
      "what encloses as much curvature is kept at a quarter of the width, in radians, at most 4 pi: a limb encloses "
      "almost 2 pi, the corner of a box pi / 2, with the methods default and polyhedral (default: what mesh and noise "
      "do not explain; the width alone counts if one is given)");
  add("min-branch-gap", text("RAD"),
      "least angle, in radians, between these paths where they part, at most pi (default: 0)");
  add("min-branch-edges", text("N"),
      "branches of fewer edges of the curve, or with the method laplacian of the mesh, are removed; of edges of the "
      "mesh, "
      "those count by which a branch leads away from the rest (default: 3 with the method laplacian, else 0)");
  add("min-branch-length", text("L"),
      "branches that are shorter are removed, in units of the diagonal of the bounding box (default: 0)");
  add("keep", text("all|voronoi|medial"),
      "with several sources: only what is between two of them, or only what is inside the cells (default: all)");
  add("angle", text("RAD"),
      "least angle, in radians, above 0 and at most pi, at which shortest paths meet, with the method laplacian "
      "(default: 0.7)");
  add("laplacian", text("L"),
      "least value of minus the Laplacian of the distance times the mean edge length, with the method laplacian "
      "(default: none)");
  add(
    "policy", text("prune|grow"),
    "weak branches are pruned from the leaves, or the tree is grown from its root, with the method laplacian (default: "
    "prune)");
  add("smooth", text("N"),
      "N steps that move the curves off the edges of the mesh, onto the cut locus, with the method laplacian (default: "
      "4, which are enough, or 0 with --curve edges; 1000 are the most)");
  return result;
}

po::options_description output()
{
  po::options_description result;
  auto add = result.add_options();
  add("output,o", texts("FILE")->composing(),
      ("write the cut locus; may be given several times. By extension:\n" + output_descriptions()).c_str());
  add("output-format", text(with_bars(output_extensions()))->default_value("polylines.txt"),
      "the format of -o -, standard output: an extension as above, without the dot. --edges, --surface and --report "
      "take - "
      "as well; all else goes to stderr");
  add("view", text("X,Y,Z"), "pictures look from this direction only (default: two that show most)");
  add("edges", text("FILE"),
      "write its edges as pairs of vertices of the file, counted from 0, with the word 'marked' if the edge is not in "
      "the file");
  add("cells", text("FILE.ply|.vtp|.obj"),
      "write the surface with the number of the source nearest to each face, in the order of points, curves and the "
      "border: faces between two sources are split. Where no path leads from a source, number and distance are -1");
  add("surface", text("FILE.vtp"),
      "write the mesh with the distance, the number of the nearest source, that in the file, and the logarithmic map "
      "of each "
      "vertex");
  add("uv", text("FILE.obj|.glb"),
      "cut all components open along their cut loci and flatten them, into the unit square: the mesh with texture "
      "coordinates. An OBJ file stays as it is, but for these: polygons, groups, normals and materials; others get a "
      "texture. A component without a source among those given gets the vertex farthest from its center. Seams follow "
      "edges of the file's polygons; with --curve faces they are straight, and faces are split");
  add("seams", text("FILE.obj|.json|.py"),
      "write these seams on the vertices of the file: as lines, as a list of pairs counted from 0, or as a script that "
      "marks them in Blender");
  add("max-stretch", text("S"),
      "a component is cut along finer branches as long as a chart of it is stretched more than this, in the mean; with "
      "the "
      "method default, --parameterization injective, and no --min-branch-width, -gap or -curvature (default: 2, where "
      "lengths are doubled or halved)");
  add("parameterization", text("injective|arap|lscm|convex|logmap")->default_value("injective"),
      "how --uv flattens:\n"
      "  injective: as isometrically as may be without flipped or overlapping triangles\n"
      "  arap: as rigidly as possible; may flip and overlap\n"
      "  lscm: least squares conformal map; may, too\n"
      "  convex: mean value coordinates in a circle, without flipped triangles\n"
      "  logmap: distances and directions from the source as they are; straight through the faces, and may flip and "
      "overlap");
  add("unfold", text("FILE.svg|.obj"),
      "write the source unfolding of a convex polyhedron: cut along the exact cut locus, whatever the method, and laid "
      "flat; sides with the same number are glued");
  add("report", text("FILE"), "write figures and times as JSON");
  add("quiet", po::bool_switch(), "no progress on stderr");
  return result;
}

po::options_description checking()
{
  po::options_description result;
  auto add = result.add_options();
  add("check", po::bool_switch(),
      "check the topology of the result, also with --quiet, by how much cutting along it lengthens shortest paths, and "
      "how far its distances are from exact ones, in mean edge lengths; costs three exact computations of distances "
      "more. With several sources, distances are those to the nearest. The program fails if the topology is wrong");
  add("check-completeness", po::bool_switch(),
      "check as well how much of what is wide in the cut locus of the polyhedron is near the result, and the reverse; "
      "computes all of that cut locus");
  return result;
}

po::options_description asking()
{
  po::options_description result;
  auto add = result.add_options();
  add("help,h", po::bool_switch(), "the options that most runs need, and examples");
  add("help-all", po::bool_switch(), "all options");
  add("generate", text("man|completion"), "write a page for man, or completion for bash, to standard output");
  add("version", po::bool_switch(), "the version of the program and of CGAL");
  return result;
}

const char usage[] = "Usage: cut_locus MESH [OPTION]...\n";

} // namespace

std::string purpose()
{
  return "Computes the cut locus of a point on a mesh (.off, .obj, .ply, .stl, .ts, .vtp, a scene such as .glb, or - "
         "for "
         "standard input).";
}

std::vector<std::pair<std::string, po::options_description>> option_groups()
{
  return {{"Sources", sources()}, {"What is shown", shown()}, {"Output", output()}, {"Method", method()},
          {"Input", input()},     {"Checking", checking()},   {"Help", asking()}};
}

po::options_description all_options()
{
  po::options_description result(columns, columns_of_text);
  for(const auto& [caption, options] : option_groups())
  {
    po::options_description group(caption, columns, columns_of_text);
    for(const auto& option : options.options())
      group.add(option);
    result.add(group);
  }
  return result;
}

std::vector<std::string> choices(const po::option_description& option)
{
  const std::vector<std::string> words = words_of(option);
  return words.size() > 1 && words.front().compare(0, 4, "FILE") != 0 ? words : std::vector<std::string>();
}

std::vector<std::string> file_extensions(const po::option_description& option)
{
  std::vector<std::string> words = words_of(option);
  if(words.front().compare(0, 5, "FILE.") != 0)
    return {};
  words.front().erase(0, 4);
  return words;
}

std::string help()
{
  return usage + purpose() + R"(

The options that most runs need; cut_locus --help-all lists all of them.
  --source V               from this vertex of the file, counted from 0; repeatable
  --source-point X,Y,Z     from the point of the surface closest to this one; repeatable
  --source-border          from each border loop: of a flat mesh, its medial axis
  --each-source FILE       a cut locus for each source of a file
  --min-branch-width W     more branches, or fewer: how far apart the two shortest paths to a branch must be
                           somewhere, in units of the diagonal of the bounding box
  --curve edges|faces      along edges of the mesh, or through its faces (default: faces)
  -o FILE                  write the cut locus: .png, .svg, .vtp, .ply, .json, .obj, .polylines.txt
  --cells FILE.ply         write which source is the nearest
  --uv FILE.obj            cut the surface open along the cut locus and flatten it
  --seams FILE.py          write where it is cut, for Blender
  --report FILE.json       write figures and times
  --check                  check the result

Examples:
  cut_locus bunny.obj -o bunny.png
                           a picture of the cut locus of a vertex, from two sides
  cut_locus bunny.obj --source 4711 -o bunny.vtp -o bunny.polylines.txt
                           that of a chosen vertex, for ParaView and for CGAL
  cut_locus bunny.obj --min-branch-width 0.02 -o fine.png
                           with finer branches
  cut_locus bunny.obj --source 12 --source 4711 --keep voronoi --cells cells.ply
                           the geodesic Voronoi diagram of two vertices
  cut_locus plate.stl --source-border -o axis.svg --view 0,0,1
                           the medial axis of a plate
  cut_locus bunny.obj --uv bunny_uv.obj
                           the file with texture coordinates: a piece for each component
  zcat bunny.ply.gz | cut_locus - -o - --output-format json
                           from one program to the next
  cut_locus part.stl --check --report part.json
                           how good the result is
)";
}

std::string help_on_all()
{
  std::ostringstream result;
  result << usage << purpose() << "\n" << all_options();
  return result.str();
}

std::string version()
{
  return "cut_locus " CUT_LOCUS_VERSION ", with CGAL " CGAL_VERSION_STR "\n";
}
