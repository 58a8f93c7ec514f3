#include "data/io/robot/import_mesh.h"

#include <filesystem>

#include <fmt/format.h>

#include "base/error.h"
#include "base/file_io.h"

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

std::string existing(const fs::path& path) {
  return is_file(path) ? path.lexically_normal().string() : "";
}

}  // namespace

std::string find_mesh(const std::string& name, const std::string& robot_file) {
  // Windows paths, too.
  std::string plain = without_scheme(name);
  for (char& letter : plain)
    if (letter == '\\') letter = '/';
  const bool in_package = starts_with(name, "package://") || starts_with(name, "model://");
  if (fs::path(plain).is_absolute() && !in_package) return existing(plain);

  // The first folder of a package name may be the current one under another name.
  std::vector<fs::path> tails{plain};
  if (in_package && plain.find('/') != std::string::npos)
    tails.emplace_back(plain.substr(plain.find('/') + 1));
  // Search every folder from the robot's file upwards.
  const fs::path start = fs::absolute(fs::path(robot_file)).parent_path();
  for (const fs::path& tail : tails)
    for (fs::path folder = start;; folder = folder.parent_path()) {
      std::string found = existing(folder / tail);
      if (!found.empty()) return found;
      if (folder == folder.parent_path()) break;
    }
  return "";
}

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

bool try_mesh(ShapeSpec& shape, const std::string& name, const MeshPlacement& placement,
              const NamedMeshes& from, const std::string& link,
              std::vector<std::string>& warnings) {
  // A missing or unreadable mesh is a warning, not an error.
  const std::string file = find_mesh(name, from.robot_file);
  if (file.empty()) {
    warnings.push_back(fmt::format("MISSING MESH '{}': link '{}' goes without it", name, link));
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
