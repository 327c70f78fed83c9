// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "output_file.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <random>
#include <stdexcept>
#include <system_error>

namespace {

namespace fs = std::filesystem;

// A file beside another one, with the same extensions, that nobody else writes; removed at the end if it is still there.
class File_beside
{
public:
  explicit File_beside(const fs::path& target)
  {
    const std::string name = target.filename().string();
    constexpr std::size_t enough = 64; // for extensions, as names have a largest length
    path_ = target.parent_path() / (".cut_locus_" + std::to_string(std::random_device()()) + "_" +
                                    name.substr(name.size() - (std::min)(name.size(), enough)));
  }
  ~File_beside()
  {
    std::error_code ignored;
    fs::remove(path_, ignored);
  }
  File_beside(const File_beside&) = delete;
  File_beside& operator=(const File_beside&) = delete;

  const fs::path& path() const { return path_; }

private:
  fs::path path_;
};

// A link stays one.
fs::path followed(const std::string& filename)
{
  std::error_code error;
  return fs::is_symlink(filename, error) ? fs::weakly_canonical(filename, error) : fs::path(filename);
}

std::ostream& write_to(std::ostream& os, const std::function<void(std::ostream&)>& write)
{
  os.precision(std::numeric_limits<double>::max_digits10);
  write(os);
  return os;
}

} // namespace

bool is_device(const std::string& filename)
{
  std::error_code error;
  return fs::exists(filename, error) && !fs::is_regular_file(filename, error);
}

void throw_not_written(const std::string& filename)
{
  throw std::runtime_error("cannot write to '" + filename + "'" +
                           (errno != 0 ? std::string(": ") + std::strerror(errno) : std::string()));
}

void write_file(const std::string& filename, const std::function<void(std::ostream&)>& write)
{
  errno = 0;
  if(is_standard_output(filename))
  {
    if(!write_to(std::cout, write).flush())
      throw_not_written("standard output");
    return;
  }
  const auto write_named = [&](const fs::path& path)
  {
    std::ofstream os(path, std::ios_base::binary);
    write_to(os, write);
    os.close();
    if(!os)
      throw_not_written(filename);
  };
  if(is_device(filename))
    return write_named(filename);
  const fs::path target = followed(filename);
  const File_beside file(target);
  write_named(file.path());
  std::error_code error;
  if(fs::exists(target, error))
    fs::permissions(file.path(), fs::status(target, error).permissions(), error);
  fs::rename(file.path(), target, error);
  if(error)
    throw std::runtime_error("cannot write to '" + filename + "': " + error.message());
}

std::string cause_not_writable(const std::string& filename)
{
  std::error_code ignored;
  errno = 0;
  if(is_device(filename)) // a pipe must not be opened before there is something to write
    return std::string();
  const fs::path target = followed(filename);
  if(fs::exists(target, ignored) && !std::ofstream(target, std::ios_base::app))
    return std::strerror(errno);
  const File_beside file(target);
  return std::ofstream(file.path()) ? std::string() : std::string("in its folder: ") + std::strerror(errno);
}
