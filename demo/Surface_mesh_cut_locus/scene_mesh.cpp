// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "scene_mesh.h"

#ifdef CUT_LOCUS_HAS_ASSIMP

#include <assimp/Importer.hpp>
#include <assimp/scene.h>

#include <boost/algorithm/string/predicate.hpp>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace {

using Matrix = aiMatrix4x4t<double>;
using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

// What a scene yields, as it goes from one process to another: polygons are the number of their corners, and these.
struct Arrays
{
  std::vector<double> coordinates, normals;
  std::vector<std::size_t> polygons;
};

void add_mesh(const aiMesh& mesh, const Matrix& place, Arrays& arrays)
{
  const std::size_t first = arrays.coordinates.size() / 3;
  const auto turned = aiMatrix3x3t<double>(Matrix(place).Inverse().Transpose());
  for(unsigned v = 0; v < mesh.mNumVertices; ++v)
  {
    const aiVector3D& p = mesh.mVertices[v];
    const aiVector3t<double> q = place * aiVector3t<double>(p.x, p.y, p.z);
    arrays.coordinates.insert(arrays.coordinates.end(), {q.x, q.y, q.z});
    if(mesh.HasNormals())
    {
      const aiVector3D& m = mesh.mNormals[v];
      const aiVector3t<double> n = turned * aiVector3t<double>(m.x, m.y, m.z);
      arrays.normals.insert(arrays.normals.end(), {n.x, n.y, n.z});
    }
  }
  const bool is_mirrored = place.Determinant() < 0.;
  for(unsigned f = 0; f < mesh.mNumFaces; ++f)
  {
    const aiFace& face = mesh.mFaces[f];
    if(face.mNumIndices < 3 ||
       std::any_of(face.mIndices, face.mIndices + face.mNumIndices, [&](unsigned v) { return v >= mesh.mNumVertices; }))
      continue; // points and lines, or damaged
    arrays.polygons.push_back(face.mNumIndices);
    for(unsigned i = 0; i < face.mNumIndices; ++i)
      arrays.polygons.push_back(first + face.mIndices[is_mirrored ? face.mNumIndices - 1 - i : i]);
  }
}

void add_scene(const aiScene& scene, Arrays& arrays)
{
  std::vector<std::pair<const aiNode*, Matrix>> stack = {{scene.mRootNode, Matrix()}};
  while(!stack.empty())
  {
    const auto [node, parent] = stack.back();
    stack.pop_back();
    const Matrix place = parent * Matrix(node->mTransformation);
    for(unsigned i = 0; i < node->mNumMeshes; ++i)
      add_mesh(*scene.mMeshes[node->mMeshes[i]], place, arrays);
    for(unsigned i = node->mNumChildren; i-- > 0;)
      stack.emplace_back(node->mChildren[i], place);
  }
}

template <typename T>
bool write(const std::vector<T>& values, std::FILE* out)
{
  const std::size_t n = values.size();
  return std::fwrite(&n, sizeof(n), 1, out) == 1 && std::fwrite(values.data(), sizeof(T), n, out) == n;
}

template <typename T>
bool read(std::vector<T>& values, std::FILE* in)
{
  std::size_t n = 0;
  if(std::fread(&n, sizeof(n), 1, in) != 1)
    return false;
  values.resize(n);
  return std::fread(values.data(), sizeof(T), n, in) == n;
}

// In a process of its own, which damaged files may crash.
bool import_scene(const Mesh_file& file, std::FILE* out)
{
  // Scenes are read at a second per megabyte or faster: ten times as much, and three seconds, are a loop without an end.
  const rlim_t seconds = 3 + file.text.size() / 100000;
  const rlimit no_core = {0, 0}, time = {seconds, seconds};
  setrlimit(RLIMIT_CORE, &no_core);
  setrlimit(RLIMIT_CPU, &time);
  if(std::freopen("/dev/null", "w", stderr) == nullptr)
    return false;
  // never deleted, which aborts in assimp 5.2 where a 3MF file has an object of components; the process ends anyway
  Assimp::Importer& importer = *new Assimp::Importer;
  const std::string format = file.extension.substr(1);
  // a scene with parts in other files is found by its name
  const bool is_named =
    boost::algorithm::iequals(std::filesystem::path(file.name).extension().string(), file.extension);
  const aiScene* const scene = is_named
                                 ? importer.ReadFile(file.name, 0)
                                 : importer.ReadFileFromMemory(file.text.data(), file.text.size(), 0, format.c_str());
  if(scene == nullptr || scene->mRootNode == nullptr)
    return false;
  Arrays arrays;
  add_scene(*scene, arrays);
  return write(arrays.coordinates, out) && write(arrays.normals, out) && write(arrays.polygons, out) &&
         std::fflush(out) == 0;
}

} // namespace

Polygon_soup read_scene(const Mesh_file& file)
{
  const File result(std::tmpfile(), &std::fclose);
  const pid_t child = result ? fork() : -1;
  if(child < 0)
    refuse_file(file.name, "there is no room for another process, or for a temporary file");
  if(child == 0)
    std::_Exit(import_scene(file, result.get()) ? EXIT_SUCCESS : EXIT_FAILURE);
  int status = 0;
  while(waitpid(child, &status, 0) < 0 && errno == EINTR)
    ;
  Arrays arrays;
  std::rewind(result.get());
  if(status != 0 || !read(arrays.coordinates, result.get()) || !read(arrays.normals, result.get()) ||
     !read(arrays.polygons, result.get()))
    refuse_file(file.name, "it is damaged, not of the format " + file.extension.substr(1) +
                             ", or has parts in other files that are not there");
  if(arrays.polygons.empty())
    refuse_file(file.name, "there is no mesh in the scene");

  Polygon_soup soup;
  for(std::size_t i = 0; i < arrays.coordinates.size(); i += 3)
    soup.points.emplace_back(arrays.coordinates[i], arrays.coordinates[i + 1], arrays.coordinates[i + 2]);
  if(arrays.normals.size() == arrays.coordinates.size()) // all parts have them
    for(std::size_t i = 0; i < arrays.normals.size(); i += 3)
      soup.normals.emplace_back(arrays.normals[i], arrays.normals[i + 1], arrays.normals[i + 2]);
  for(auto n = arrays.polygons.cbegin(); n != arrays.polygons.cend(); n += static_cast<std::ptrdiff_t>(*n + 1))
    soup.polygons.emplace_back(n + 1, n + 1 + static_cast<std::ptrdiff_t>(*n));
  return soup;
}

#else

Polygon_soup read_scene(const Mesh_file& file)
{
  refuse_file(file.name, "this program is built without libassimp, which reads " + file.extension +
                           ": install it (Debian: libassimp-dev) and build again, or convert the file to .obj");
}

#endif
