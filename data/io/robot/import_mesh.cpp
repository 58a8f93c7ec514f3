#include "data/io/robot/import_mesh.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "base/error.h"
#include "base/file_io.h"
#include "base/nearest_name.h"
#include "base/outside_path.h"

namespace thenar::internal {
namespace {

namespace fs = std::filesystem;

bool starts_with(const std::string& text, const std::string& beginning) {
  return text.compare(0, beginning.size(), beginning) == 0;
}

/// Name without its scheme: "/a/b" for "file:///a/b"; "pkg/a/b" for "package://pkg/a/b".
std::string without_scheme(const std::string& name) {
  for (const std::string scheme : {"file://", "package://", "model://"})
    if (starts_with(name, scheme)) return name.substr(scheme.size());
  return name;
}

/// Returns whether a robot's file may name another: what was dropped names nothing elsewhere.
bool may_name(const std::string& robot_file, const fs::path& path) {
  return may_link(fs::absolute(robot_file).parent_path().string(),
                  path.lexically_normal().string());
}

/// Paths that the name of a mesh may stand for, in the order of search.
std::vector<fs::path> places_of_mesh(const std::string& name, const std::string& robot_file) {
  // Windows paths, too.
  std::string plain = without_scheme(name);
  std::replace(plain.begin(), plain.end(), '\\', '/');
  const bool in_package = starts_with(name, "package://") || starts_with(name, "model://");
  if (fs::path(plain).is_absolute() && !in_package) return {plain};

  // The first folder of a package name may be the current one under another name.
  std::vector<fs::path> tails{plain};
  if (in_package && plain.find('/') != std::string::npos)
    tails.emplace_back(plain.substr(plain.find('/') + 1));
  // Every folder from the robot's file upwards.
  const fs::path start = fs::absolute(fs::path(robot_file)).parent_path();
  std::vector<fs::path> places;
  for (const fs::path& tail : tails)
    for (fs::path folder = start;; folder = folder.parent_path()) {
      places.push_back(folder / tail);
      if (folder == folder.parent_path()) break;
    }
  return places;
}

/// Describes the folders that find_mesh() searched in vain, and the nearest name there: "looked for
/// it in A and the folders above it, did you mean 'tip.stl'?".
std::string lost_mesh_words(const std::string& name, const std::string& robot_file) {
  if (const auto fault = outside_fault(name, OutsideUse::kRead))
    return fmt::format("its name has {}", *fault);
  // Files that are where it should be.
  const std::vector<fs::path> places = places_of_mesh(name, robot_file);
  std::vector<std::string> beside;
  std::error_code none;
  for (const fs::path& path : places)
    if (may_name(robot_file, path))
      for (const fs::directory_entry& entry : fs::directory_iterator(path.parent_path(), none))
        if (is_mesh_file(entry.path().filename().string()))
          beside.push_back(entry.path().filename().string());
  const std::string file = places.front().filename().string();
  const bool above = places.size() > 1;
  return fmt::format("looked {} '{}'{}{}", above ? "beside" : "for",
                     above ? robot_file : places.front().string(),
                     above ? " and in all folders above" : "", did_you_mean(file, beside));
}

/// Reads a mesh as a shape; a file with one exact shape (MeshContent) that is only scaled becomes
/// it.
/// @param file  as find_mesh() returns it
/// @throws DataError if the file cannot be read.
ShapeSpec mesh_shape(const std::string& file, const MeshPlacement& placement, MeshReader& reader) {
  const Eigen::Matrix3d& A = placement.A;
  const double scale = A(0, 0);
  ShapeSpec shape;
  shape.kind = ShapeKind::kMesh;
  // A file of exactly one sphere, box or cylinder becomes this shape.
  if (scale > 0 && A == Eigen::Matrix3d(scale * Eigen::Matrix3d::Identity()) &&
      placement.b.isZero(0)) {
    const MeshContent& content = reader.content(file, scale);
    if (content.exact.size() == 1) return content.exact.front();
    shape.mesh = content.mesh;
    shape.mesh_file = file;
    shape.mesh_scale = scale;
    return shape;
  }
  // Any other map is applied to the vertices; mirroring turns triangles over.
  shape.mesh = reader.read(file);
  shape.mesh.vertices = (A * shape.mesh.vertices).colwise() + placement.b;
  if (A.determinant() < 0) shape.mesh.triangles.row(1).swap(shape.mesh.triangles.row(2));
  return shape;
}

}  // namespace

std::string find_mesh(const std::string& name, const std::string& robot_file) {
  if (outside_fault(name, OutsideUse::kRead)) return "";
  for (const fs::path& path : places_of_mesh(name, robot_file))
    if (may_name(robot_file, path) && is_file(path.lexically_normal().string()))
      return path.lexically_normal().string();
  return "";
}

bool try_mesh(ShapeSpec& shape, const std::string& name, const MeshPlacement& placement,
              const NamedMeshes& from, const std::string& link,
              std::vector<std::string>& warnings) {
  // A missing or unreadable mesh is a warning, not an error.
  const std::string file = find_mesh(name, from.robot_file);
  if (file.empty()) {
    warnings.push_back(fmt::format("MISSING MESH '{}': link '{}' goes without it; {}", name, link,
                                   lost_mesh_words(name, from.robot_file)));
    return false;
  }
  try {
    const Pose<double> X_BS = shape.X_BS;
    shape = mesh_shape(file, placement, from.reader);
    shape.X_BS = X_BS * shape.X_BS;
  } catch (const DataError& error) {
    warnings.push_back(
        fmt::format("UNREADABLE MESH, link '{}' goes without it: {}", link, error.what()));
    return false;
  }
  return true;
}

}  // namespace thenar::internal
