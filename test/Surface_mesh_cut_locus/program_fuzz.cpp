// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// Runs the program on damaged files, on command lines and on surfaces at random, for a given time. Each run must end soon,
// by itself, with a result or with one line that names the cause; a result has the right topology, and nodes with exact
// distances; vertices that are doubled at seams change nothing; and where it is killed, outputs are whole or not there.
//
//   program_fuzz [SECONDS [SEED]]

#include "fuzz_surfaces.h"
#include "octahedron_3mf.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using Words = std::vector<std::string>;
using fuzz_surfaces::Random;

// the files are of a few hundred bytes; most of it is for loaded machines
constexpr std::chrono::seconds time_limit(10);
#if defined(__SANITIZE_ADDRESS__)
constexpr rlim_t memory_limit = RLIM_INFINITY; // the sanitizer maps more than there is
#else
constexpr rlim_t memory_limit = rlim_t(1) << 30;
#endif

// The words of a binary file, in either byte order.
class Bytes
{
public:
  explicit Bytes(std::string text, bool is_little = true) : text_(std::move(text)), is_little_(is_little) {}
  template <typename Number>
  Bytes& add(Number number)
  {
    std::array<char, sizeof(Number)> bytes;
    std::memcpy(bytes.data(), &number, sizeof(Number)); // on machines of the other order, files are just more damaged
    if(!is_little_)
      std::reverse(bytes.begin(), bytes.end());
    text_.append(bytes.begin(), bytes.end());
    return *this;
  }
  const std::string& text() const { return text_; }

private:
  std::string text_;
  bool is_little_;
};

// an octahedron, each format with its extension
const int octahedron_points[6][3] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
const int octahedron_faces[8][3] = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                    {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};

std::string text_file(const std::string& head, const std::string& before_point, const std::string& after_point,
                      const std::string& before_face, int first_number, bool counts_points)
{
  std::ostringstream text;
  text << head;
  int count = first_number;
  for(const auto& p : octahedron_points)
  {
    text << before_point;
    if(counts_points)
      text << count++ << ' ';
    text << p[0] << ' ' << p[1] << ' ' << p[2] << after_point << '\n';
  }
  for(const auto& f : octahedron_faces)
    text << before_face << f[0] + first_number << ' ' << f[1] + first_number << ' ' << f[2] + first_number << '\n';
  return text.str();
}

std::string binary_off(bool is_little)
{
  Bytes bytes("OFF BINARY\n", is_little);
  bytes.add<std::int32_t>(6).add<std::int32_t>(8).add<std::int32_t>(0);
  for(const auto& p : octahedron_points)
    for(int x : p)
      bytes.add(static_cast<float>(x));
  for(const auto& f : octahedron_faces)
  {
    bytes.add<std::int32_t>(3);
    for(int v : f)
      bytes.add<std::int32_t>(v);
    bytes.add<std::int32_t>(0);
  }
  return bytes.text();
}

std::string ply_header(const std::string& format, const std::string& length)
{
  return "ply\nformat " + format +
         " 1.0\ncomment of no use\nelement vertex 6\nproperty float x\nproperty float y\nproperty float z\n"
         "element face 8\nproperty list " +
         length + " int vertex_indices\nend_header\n";
}

std::string binary_ply(bool is_little, bool has_long_lists)
{
  Bytes bytes(ply_header(is_little ? "binary_little_endian" : "binary_big_endian", has_long_lists ? "uint" : "uchar"),
              is_little);
  for(const auto& p : octahedron_points)
    for(int x : p)
      bytes.add(static_cast<float>(x));
  for(const auto& f : octahedron_faces)
  {
    if(has_long_lists)
      bytes.add<std::uint32_t>(3);
    else
      bytes.add<std::uint8_t>(3);
    for(int v : f)
      bytes.add<std::int32_t>(v);
  }
  return bytes.text();
}

std::string binary_stl()
{
  Bytes bytes(std::string(80, ' '));
  bytes.add<std::uint32_t>(8);
  for(const auto& f : octahedron_faces)
  {
    for(int i = 0; i < 3; ++i)
      bytes.add(0.f);
    for(int v : f)
      for(int x : octahedron_points[v])
        bytes.add(static_cast<float>(x));
    bytes.add<std::uint16_t>(0);
  }
  return bytes.text();
}

std::string text_stl()
{
  std::ostringstream text;
  text << "solid octahedron\n";
  for(const auto& f : octahedron_faces)
  {
    text << "facet normal 0 0 0\nouter loop\n";
    for(int v : f)
      text << "vertex " << octahedron_points[v][0] << ' ' << octahedron_points[v][1] << ' ' << octahedron_points[v][2]
           << '\n';
    text << "endloop\nendfacet\n";
  }
  return text.str() + "endsolid octahedron\n";
}

std::string vtp()
{
  std::ostringstream text;
  text << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\"><PolyData><Piece><Points><DataArray format=\"ascii\">\n";
  for(const auto& p : octahedron_points)
    text << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  text << "</DataArray></Points><Polys><DataArray Name=\"connectivity\">\n";
  for(const auto& f : octahedron_faces)
    text << f[0] << ' ' << f[1] << ' ' << f[2] << '\n';
  text << "</DataArray><DataArray Name=\"offsets\">\n3 6 9 12 15 18 21 "
          "24\n</DataArray></Polys></Piece></PolyData></VTKFile>\n";
  return text.str();
}

struct Sample
{
  std::string kind, extension, content;
};

std::string dae()
{
  const std::string end = "</p></triangles></mesh></geometry></library_geometries><library_visual_scenes>"
                          "<visual_scene id=\"s\"><node><instance_geometry url=\"#g\"/></node></visual_scene>"
                          "</library_visual_scenes><scene><instance_visual_scene url=\"#s\"/></scene></COLLADA>\n";
  const std::string middle = "</float_array><technique_common><accessor source=\"#a\" count=\"6\" stride=\"3\">"
                             "<param name=\"X\" type=\"float\"/><param name=\"Y\" type=\"float\"/>"
                             "<param name=\"Z\" type=\"float\"/></accessor></technique_common></source>"
                             "<vertices id=\"v\"><input semantic=\"POSITION\" source=\"#p\"/></vertices>"
                             "<triangles count=\"8\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><p>";
  std::string text = "<?xml version=\"1.0\"?>\n<COLLADA version=\"1.4.1\"><library_geometries><geometry id=\"g\">"
                     "<mesh><source id=\"p\"><float_array id=\"a\" count=\"18\">";
  for(const auto& p : octahedron_points)
    for(int x : p)
      text += std::to_string(x) + " ";
  text += middle;
  for(const auto& f : octahedron_faces)
    for(int v : f)
      text += std::to_string(v) + " ";
  return text + end;
}

std::string glb()
{
  Bytes data("", true);
  for(const auto& p : octahedron_points)
    for(int x : p)
      data.add(static_cast<float>(x));
  for(const auto& f : octahedron_faces)
    for(int v : f)
      data.add<std::uint16_t>(static_cast<std::uint16_t>(v));
  std::string json = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"meshes":[{)"
                     R"("primitives":[{"attributes":{"POSITION":0},"indices":1}]}],"accessors":[{"bufferView":0,)"
                     R"("componentType":5126,"count":6,"type":"VEC3"},{"bufferView":1,"componentType":5123,"count":24,)"
                     R"("type":"SCALAR"}],"bufferViews":[{"buffer":0,"byteLength":72},{"buffer":0,"byteOffset":72,)"
                     R"("byteLength":48}],"buffers":[{"byteLength":120}]})";
  json.resize((json.size() + 3) / 4 * 4, ' ');
  Bytes bytes("glTF", true);
  bytes.add<std::uint32_t>(2).add(static_cast<std::uint32_t>(28 + json.size() + data.text().size()));
  bytes.add(static_cast<std::uint32_t>(json.size()));
  Bytes end("JSON" + json, true);
  end.add(static_cast<std::uint32_t>(data.text().size()));
  return bytes.text() + end.text() + std::string("BIN\0", 4) + data.text();
}

std::vector<Sample> samples()
{
  return {{"OFF", ".off", text_file("OFF\n6 8 0\n", "", "", "3 ", 0, false)},
          {"OFF with colors", ".off", text_file("COFF\n6 8 0\n", "", " 255 0 0 255", "3 ", 0, false)},
          {"OFF with normals", ".off", text_file("STCNOFF\n6 8 0\n", "", " 0 0 1 1 1 1 1 0 0", "3 ", 0, false)},
          {"OFF, homogeneous", ".off", text_file("4OFF\n6 8 0\n", "", " 1", "3 ", 0, false)},
          {"OFF of polygons", ".off",
           "OFF\n6 3 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 2 0\n0 0 1\n"
           "4 0 1 2 3\n3 3 2 4\n5 0 1 2 4 5\n"},
          {"OFF, binary", ".off", binary_off(false)},
          {"OFF, binary, little endian", ".off", binary_off(true)},
          {"OBJ", ".obj", text_file("# text\n", "v ", "", "f ", 1, false) + "vt 0 0\nf 1/1 3/1 5/1\nf -1 -2 -3\n"},
          {"PLY", ".ply", text_file(ply_header("ascii", "int"), "", "", "3 ", 0, false)},
          {"PLY, binary", ".ply", binary_ply(true, false)},
          {"PLY, binary, long lists", ".ply", binary_ply(true, true)},
          {"PLY, binary, big endian", ".ply", binary_ply(false, true)},
          {"STL", ".stl", text_stl()},
          {"STL, binary", ".stl", binary_stl()},
          {"VTP", ".vtp", vtp()},
          {"DAE", ".dae", dae()},
          {"GLB", ".glb", glb()},
          {"3MF", ".3mf", octahedron_3mf()},
          {"TS", ".ts", text_file("GOCAD TSurf 1\nTFACE\n", "VRTX ", "", "TRGL ", 1, true) + "END\n"}};
}

const Words nasty_words = {"-1",         "0",        "1",       "3",    "99999", "4000000000", "99999999999999999999",
                           "1e400",      "1e-320",   "nan",     "inf",  "1e7",   "#",          "x",
                           "end_header", "property", "element", "list", "OFF",   "f",          "v",
                           "l 1 2",      "BINARY"};

void damage(std::string& content, Random& random)
{
  const auto position = [&]() { return random.below(content.size() + 1); };
  const auto length = [&](std::size_t start)
  { return random.below((std::min)(content.size() - start, std::size_t(40)) + 1); };
  switch(random.below(7))
  {
  case 0:
    if(!content.empty())
      content[random.below(content.size())] = static_cast<char>(random.below(256));
    break;
  case 1:
    content.resize(position());
    break;
  case 2: {
    const std::size_t start = position();
    content.erase(start, length(start));
    break;
  }
  case 3: {
    const std::size_t start = position();
    const std::string part = content.substr(start, length(start));
    content.insert(position(), part);
    break;
  }
  case 4: // a word by another one
  {
    const std::size_t start = content.find_first_not_of(" \n", position());
    if(start != std::string::npos)
      content.replace(start, (std::min)(content.find_first_of(" \n", start), content.size()) - start,
                      random.of(nasty_words));
    break;
  }
  case 5:
    content.insert(position(), " " + random.of(nasty_words) + (random.one_in(2) ? " " : "\n"));
    break;
  case 6: // four bytes, as counts of binary files are
    if(content.size() > 4)
    {
      const std::size_t start = random.below(content.size() - 4);
      for(std::size_t i = start; i < start + 4; ++i)
        content[i] = static_cast<char>(random.one_in(2) ? 0xff : random.below(256));
    }
    break;
  }
}

Words damaged_file(const fs::path& folder, Random& random, std::string& kind)
{
  static const std::vector<Sample> all = samples();
  const Sample& sample = random.of(all);
  kind = sample.kind;
  std::string content = sample.content;
  for(std::size_t i = random.below(4); i > 0; --i) // sometimes none
    damage(content, random);
  const fs::path file = folder / ("mesh" + (random.one_in(20) ? random.of(all).extension : sample.extension));
  std::ofstream(file, std::ios_base::binary) << content;
  // the exact distances of needles that a damaged coordinate makes take long
  return {file.string(), "--quiet", "--solver", "graph", "--report", (folder / "report.json").string()};
}

Words wrong_command_line(const fs::path& folder, Random& random, std::string& kind)
{
  kind = "command line";
  const fs::path file = folder / "mesh.off";
  std::ofstream(file) << samples().front().content;
  static const Words options = {"--source",
                                "--source-point",
                                "--repair",
                                "--solver",
                                "--max-relative-error",
                                "--method",
                                "--curve",
                                "--min-branch-width",
                                "--min-branch-gap",
                                "--min-branch-curvature",
                                "--angle",
                                "--laplacian",
                                "--policy",
                                "--min-branch-edges",
                                "--min-branch-length",
                                "--smooth",
                                "-o",
                                "--view",
                                "--edges",
                                "--cells",
                                "--keep",
                                "--uv",
                                "--parameterization",
                                "--unfold",
                                "--report",
                                "--check",
                                "--quiet",
                                "--help",
                                "--none",
                                "",
                                "-x"};
  static const Words values = {"0",           "5",
                               "6",           "-1",
                               "1e9",         "999999999",
                               "1e400",       "nan",
                               "0.5",         "1,2",
                               "1,2,3",       "0,0,0",
                               "auto",        "none",
                               "exact",       "heat",
                               "voronoi",     "medial",
                               "heat-direct", "cgal-exact",
                               "graph",       "default",
                               "polyhedral",  "laplacian",
                               "edges",       "faces",
                               "prune",       "grow",
                               "arap",        "lscm",
                               "convex",      "",
                               "--quiet",     "a.obj",
                               "a.off",       "a.svg",
                               "a.ply",       "a.png",
                               "a.vtp",       "a.polylines.txt",
                               "mesh.off",    "no/such/folder.obj",
                               ".",           "/dev/null",
                               "/dev/full"};
  Words words = {file.string()};
  if(random.one_in(20))
    words.clear();
  for(std::size_t i = random.below(5); i > 0; --i)
  {
    words.push_back(random.of(options));
    if(!random.one_in(8))
      words.push_back(random.of(values));
  }
  words.push_back("--quiet");
  return words;
}

struct Outcome
{
  bool has_ended = false, was_killed = false;
  int status = 0;
  std::string messages;
};

// `time` after which it is killed, if it has not ended
Outcome run(const Words& arguments, const fs::path& folder, std::chrono::microseconds time = time_limit)
{
  const std::string messages = (folder / "messages.txt").string();
  const pid_t child = fork();
  if(child == 0)
  {
    const rlimit memory = {memory_limit, memory_limit};
    setrlimit(RLIMIT_AS, &memory);
    const rlimit no_core = {0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
    const int in = open("/dev/null", O_RDONLY), out = open(messages.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    dup2(in, 0);
    dup2(out, 1);
    dup2(out, 2);
    std::vector<char*> argv = {const_cast<char*>(CUT_LOCUS_PROGRAM)};
    for(const std::string& a : arguments)
      argv.push_back(const_cast<char*>(a.c_str()));
    argv.push_back(nullptr);
    if(chdir(folder.c_str()) == 0)
      execv(CUT_LOCUS_PROGRAM, argv.data());
    _exit(127);
  }
  Outcome outcome;
  int status = 0;
  for(const auto start = Clock::now(); !outcome.has_ended && Clock::now() - start < time;)
  {
    outcome.has_ended = waitpid(child, &status, WNOHANG) == child;
    if(!outcome.has_ended)
      std::this_thread::sleep_for((std::min)(time / 10, std::chrono::microseconds(2000)));
  }
  if(!outcome.has_ended)
  {
    kill(child, SIGKILL);
    waitpid(child, &status, 0);
  }
  outcome.was_killed = !WIFEXITED(status);
  outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  std::ifstream is(messages);
  outcome.messages.assign(std::istreambuf_iterator<char>(is), std::istreambuf_iterator<char>());
  return outcome;
}

std::string content_of(const fs::path& file)
{
  std::ifstream is(file, std::ios_base::binary);
  return std::string(std::istreambuf_iterator<char>(is), std::istreambuf_iterator<char>());
}

// What is wrong with an outcome, or nothing.
std::string fault(const Outcome& outcome, const fs::path& folder)
{
  if(!outcome.has_ended)
    return "does not end";
  if(outcome.was_killed)
    return "crashed";
  if(outcome.status != 0 && outcome.status != 1 && outcome.status != 2)
    return "exit status " + std::to_string(outcome.status);
  if(outcome.status != 0 && outcome.messages.compare(0, 11, "cut_locus: ") != 0 &&
     outcome.messages.compare(0, 7, "check: ") != 0)
    return "no message that starts with the name of the program";
  if(outcome.status != 0 && std::count(outcome.messages.begin(), outcome.messages.end(), '\n') != 1)
    return "not one line";
  if(outcome.messages.find("memory") != std::string::npos)
    return "a small file, and not enough memory";
  if(outcome.status == 0)
  {
    const std::string text = content_of(folder / "report.json");
    if(text.find("\"length\": null") != std::string::npos) // how JSON says that a number is none
      return "a length that is not a number";
  }
  return std::string();
}

// -- surfaces --------------------------------------------------------------------------------------------------------

std::string point(const fuzz_surfaces::Point& p)
{
  std::ostringstream text;
  text.precision(17);
  text << p[0] << ',' << p[1] << ',' << p[2];
  return text.str();
}

// in the middle of a face, but by `away` in direction of a corner
std::string source_point(const fuzz_surfaces::Surface& s, std::size_t face, double away)
{
  const fuzz_surfaces::Face& f = s.faces[face];
  const fuzz_surfaces::Point middle =
    fuzz_surfaces::between(fuzz_surfaces::between(s.points[f[0]], s.points[f[1]], 0.47), s.points[f[2]], 0.31);
  return "--source-point=" + point(fuzz_surfaces::between(middle, s.points[f[0]], away));
}

// A surface with thin faces, curves as sources, or sources that are close to each other, or all of that.
Words surface_with_sources(const fs::path& folder, Random& random, std::string& kind, bool& has_thin_faces)
{
  fuzz_surfaces::Surface s = fuzz_surfaces::surface(random);
  const std::size_t which = random.below(3);
  kind = which == 0 ? "thin faces" : which == 1 ? "curves" : "close sources";
  has_thin_faces = which == 0 || random.one_in(8);
  if(has_thin_faces)
    add_thin_faces(s, random);
  const fs::path file = folder / "mesh.off";
  std::ofstream(file) << fuzz_surfaces::off(s);
  Words words = {file.string(), "--quiet", "--check", "--report", (folder / "report.json").string()};
  if(which == 1)
  {
    std::ofstream(folder / "curves.txt") << fuzz_surfaces::curves(s, random);
    words.insert(words.end(), {"--source-edges", (folder / "curves.txt").string()});
    if(random.one_in(4))
      words.push_back("--source-border"); // of a closed surface that is refused
    if(random.one_in(4))
      words.push_back(source_point(s, random.below(s.faces.size()), 0.));
  }
  else if(which == 2)
  {
    const std::size_t face = random.below(s.faces.size());
    const double away = std::pow(10., random.between(-9., -1.));
    for(std::size_t i = 2 + random.below(3); i > 0; --i)
      words.push_back(source_point(s, random.one_in(6) ? random.below(s.faces.size()) : face, away * double(i)));
  }
  else if(random.one_in(2))
    words.push_back(source_point(s, random.below(s.faces.size()), 0.));
  else
    words.insert(words.end(), {"--source", std::to_string(random.of(random.of(s.faces)))});
  if(random.one_in(3))
    words.insert(words.end(), {"--method", "polyhedral"});
  if(random.one_in(4))
    words.insert(words.end(), {"--curve", "edges"});
  return words;
}

double number_after(const std::string& text, const std::string& words)
{
  const std::size_t start = text.find(words);
  return start == std::string::npos ? 0. : std::strtod(text.c_str() + start + words.size(), nullptr);
}

// What `--check` says. Paths across thin faces may be longer by two millionths of their edges each.
std::string fault_of_result(const Outcome& outcome, bool has_thin_faces)
{
  const double most = has_thin_faces ? 5e-5 : 1e-6;
  for(const char* wrong : {"WRONG", "can not be measured"})
    if(outcome.messages.find(wrong) != std::string::npos)
      return "the result is wrong";
  const std::size_t distances = outcome.messages.find("distances of nodes");
  if(distances != std::string::npos && number_after(outcome.messages.substr(distances), ", max ") > most)
    return "distances of nodes are off";
  return std::string();
}

struct Trial
{
  std::string kind;
  Words arguments; // of the last run
  Outcome outcome;
  std::string fault;
};

Trial try_sources(const fs::path& folder, Random& random)
{
  Trial trial;
  bool has_thin_faces = false;
  trial.arguments = surface_with_sources(folder, random, trial.kind, has_thin_faces);
  trial.outcome = run(trial.arguments, folder);
  trial.fault = fault(trial.outcome, folder);
  if(trial.fault.empty())
    trial.fault = fault_of_result(trial.outcome, has_thin_faces);
  return trial;
}

// The curve does not depend on vertices that are doubled.
Trial try_seams(const fs::path& folder, Random& random)
{
  Trial trial;
  trial.kind = "seams";
  const fuzz_surfaces::Surface whole = fuzz_surfaces::surface(random);
  const std::string source = source_point(whole, random.below(whole.faces.size()), 0.);
  std::array<std::string, 2> report;
  for(std::size_t i = 0; i < 2 && trial.fault.empty(); ++i)
  {
    const fs::path file = folder / (i == 0 ? "mesh.off" : "seams.off");
    std::ofstream(file) << fuzz_surfaces::off(i == 0 ? whole : with_seams(whole, random));
    trial.arguments = {file.string(), "--quiet", source, "--report", (folder / "report.json").string()};
    trial.outcome = run(trial.arguments, folder);
    trial.fault = fault(trial.outcome, folder);
    report[i] = trial.outcome.status == 0 ? content_of(folder / "report.json") : trial.outcome.messages;
  }
  for(const char* key :
      {"\"edges\": ", "\"cycles\": ", "\"genus\": ", "\"border_loops\": ", "\"length\": ", "\"injectivity_radius\": "})
  {
    const double a = number_after(report[0], key), b = number_after(report[1], key);
    if(trial.fault.empty() && !(std::fabs(a - b) <= 1e-9 * (1. + std::fabs(a))))
      trial.fault = "seams change " + std::string(key);
  }
  return trial;
}

// Killed at any time, each output is the old one or the new one.
Trial try_to_kill(const fs::path& folder, Random& random)
{
  Trial trial;
  trial.kind = "killed";
  const fuzz_surfaces::Surface s = fuzz_surfaces::surface(random);
  const fs::path file = folder / "mesh.off";
  std::ofstream(file) << fuzz_surfaces::off(s);
  const Words outputs = {"a.obj", "a.vtp", "a.ply", "a.json", "s.vtp", "c.ply", "edges.txt"};
  trial.arguments = {file.string(), "--quiet", "-o",        "a.obj", "-o",      "a.vtp", "-o",      "a.ply",
                     "-o",          "a.json",  "--surface", "s.vtp", "--cells", "c.ply", "--edges", "edges.txt"};
  const auto start = Clock::now();
  trial.outcome = run(trial.arguments, folder);
  const auto time = std::chrono::duration_cast<std::chrono::microseconds>(Clock::now() - start);
  trial.fault = fault(trial.outcome, folder);
  if(!trial.fault.empty() || trial.outcome.status != 0)
    return trial;
  Words complete;
  for(const std::string& name : outputs)
    complete.push_back(content_of(folder / name));
  for(int i = 0; i < 5 && trial.fault.empty(); ++i)
  {
    for(const std::string& name : outputs)
      std::ofstream(folder / name) << "old\n";
    const Outcome outcome = run(trial.arguments, folder, time * random.below(1100) / 1000);
    for(std::size_t k = 0; k < outputs.size(); ++k)
    {
      const std::string content = content_of(folder / outputs[k]);
      if(content != complete[k] && (content != "old\n" || outcome.has_ended))
        trial.fault = "half of " + outputs[k];
    }
  }
  return trial;
}

Trial try_any(const fs::path& folder, Random& random)
{
  if(random.one_in(2))
    return random.one_in(6)   ? try_to_kill(folder, random)
           : random.one_in(3) ? try_seams(folder, random)
                              : try_sources(folder, random);
  Trial trial;
  trial.arguments =
    random.one_in(4) ? wrong_command_line(folder, random, trial.kind) : damaged_file(folder, random, trial.kind);
  trial.outcome = run(trial.arguments, folder);
  trial.fault = fault(trial.outcome, folder);
  return trial;
}

} // namespace

int main(int argc, char* argv[])
{
  const std::chrono::seconds duration(argc > 1 ? std::atoi(argv[1]) : 60);
  const unsigned seed = argc > 2 ? static_cast<unsigned>(std::atoi(argv[2])) : 1;
  const fs::path folder = fs::temp_directory_path() / ("cut_locus_fuzz_" + std::to_string(getpid()));
  Random random(seed);
  std::map<std::string, std::array<int, 2>> counts; // of each kind: results, messages
  int faults = 0;
  for(const auto start = Clock::now(); Clock::now() - start < duration && faults < 10;)
  {
    fs::remove_all(folder);
    fs::create_directories(folder);
    const Trial trial = try_any(folder, random);
    ++counts[trial.kind][trial.outcome.status == 0 ? 0 : 1];
    if(trial.fault.empty())
      continue;
    ++faults;
    const fs::path kept =
      fs::temp_directory_path() / ("cut_locus_fault_" + std::to_string(getpid()) + "_" + std::to_string(faults));
    fs::rename(folder, kept);
    std::cout << trial.kind << ": " << trial.fault << ", in " << kept.string() << ":\n  cut_locus";
    for(const std::string& a : trial.arguments)
      std::cout << " '" << a << "'";
    std::cout << "\n  " << trial.outcome.messages << std::endl;
  }
  fs::remove_all(folder);
  int runs = 0;
  for(const auto& [kind, count] : counts)
  {
    std::cout << kind << ": " << count[0] << " results, " << count[1] << " messages\n";
    runs += count[0] + count[1];
  }
  std::cout << runs << " runs with seed " << seed << ", " << faults << " faults" << std::endl;
  return faults == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
