// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// Runs the program on damaged files and on command lines at random, for a given time. Each run must end soon, by
// itself, with a result or with one line that names the cause.
//
//   program_fuzz [SECONDS [SEED]]

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using Words = std::vector<std::string>;

// the files are of a few hundred bytes; most of it is for loaded machines
constexpr std::chrono::seconds time_limit(10);
#if defined(__SANITIZE_ADDRESS__)
constexpr rlim_t memory_limit = RLIM_INFINITY; // the sanitizer maps more than there is
#else
constexpr rlim_t memory_limit = rlim_t(1) << 30;
#endif

class Random
{
public:
  explicit Random(unsigned seed) : engine_(seed) {}
  std::size_t below(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(engine_); }
  bool one_in(std::size_t n) { return below(n) == 0; }
  template <typename Range>
  const auto& of(const Range& range)
  {
    return range[below(std::size(range))];
  }

private:
  std::mt19937 engine_;
};

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
                               "graph",       "direction",
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

Outcome run(const Words& arguments, const fs::path& folder)
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
  for(const auto start = Clock::now(); !outcome.has_ended && Clock::now() - start < time_limit;)
  {
    outcome.has_ended = waitpid(child, &status, WNOHANG) == child;
    if(!outcome.has_ended)
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
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
    std::ifstream report(folder / "report.json");
    const std::string text((std::istreambuf_iterator<char>(report)), std::istreambuf_iterator<char>());
    if(text.find("\"length\": null") != std::string::npos) // how JSON says that a number is none
      return "a length that is not a number";
  }
  return std::string();
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
    std::string kind;
    const Words arguments =
      random.one_in(4) ? wrong_command_line(folder, random, kind) : damaged_file(folder, random, kind);
    const Outcome outcome = run(arguments, folder);
    ++counts[kind][outcome.status == 0 ? 0 : 1];
    const std::string cause = fault(outcome, folder);
    if(cause.empty())
      continue;
    ++faults;
    const fs::path kept =
      fs::temp_directory_path() / ("cut_locus_fault_" + std::to_string(getpid()) + "_" + std::to_string(faults));
    fs::rename(folder, kept);
    std::cout << kind << ": " << cause << ", in " << kept.string() << ":\n  cut_locus";
    for(const std::string& a : arguments)
      std::cout << " '" << a << "'";
    std::cout << "\n  " << outcome.messages << std::endl;
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
