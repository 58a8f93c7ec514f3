// Poses and shapes from TOML and to it.

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "base/error.h"
#include "data/io/mesh/mesh_file.h"
#include "data/io/robot/robot_parts.h"

namespace thenar::internal {
namespace {

Eigen::Matrix3d read_quaternion(TomlTable& table) {
  const std::vector<double> q = table.numbers(Dimension::kNumber, "quaternion_wxyz", 4);
  const Eigen::Quaterniond quaternion(q[0], q[1], q[2], q[3]);
  if (std::abs(quaternion.norm() - 1) > 1e-3)  // figures are printed to a few digits
    table.fail(fmt::format("wanted 'quaternion_wxyz' of length 1, got {:.6g}", quaternion.norm()),
               "quaternion_wxyz");
  return quaternion.normalized().toRotationMatrix();
}

/// Roll, pitch, yaw about the fixed x, y, z:  R = Rz Ry Rx.
Eigen::Matrix3d read_rpy(TomlTable& table) {
  const Eigen::Vector3d rpy = table.vector(Dimension::kAngle, "rpy");
  return rotation_about<double>(Eigen::Vector3d::UnitZ(), rpy.z()) *
         rotation_about<double>(Eigen::Vector3d::UnitY(), rpy.y()) *
         rotation_about<double>(Eigen::Vector3d::UnitX(), rpy.x());
}

/// The keys of a pose, from the table they stand in.
Pose<double> pose_in(TomlTable& table) {
  Pose<double> X;
  X.p = table.vector_or(Dimension::kLength, "position", {0, 0, 0});
  const bool rows = table.has("rotation"), quaternion = table.has("quaternion_wxyz");
  const bool rpy = table.has(Dimension::kAngle, "rpy");
  if (rows + quaternion + rpy > 1)
    table.fail("give one of 'rotation', 'quaternion_wxyz' and 'rpy', not several");
  if (rows) X.R = table.rows3("rotation");
  if (quaternion) X.R = read_quaternion(table);
  if (rpy) X.R = read_rpy(table);
  return X;
}

/// Triangles written out: `vertices` and `triangles` as flat lists.
TriangleMesh read_triangles(TomlTable& table) {
  const std::vector<double> vertices = table.numbers(Dimension::kLength, "vertices");
  const std::vector<double> corners = table.numbers(Dimension::kNumber, "triangles");
  if (vertices.size() % 3 != 0 || corners.size() % 3 != 0)
    table.fail("wanted 'vertices' and 'triangles' as triples", "triangles");
  TriangleMesh mesh;
  mesh.vertices = Eigen::Map<const Eigen::Matrix3Xd>(
      vertices.data(), 3, static_cast<Eigen::Index>(vertices.size() / 3));
  mesh.triangles.resize(3, static_cast<Eigen::Index>(corners.size() / 3));
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (corners[i] != std::floor(corners[i]) || corners[i] < 0 ||
        corners[i] >= static_cast<double>(mesh.vertices.cols()))
      table.fail(fmt::format("wanted corners 0..{} in 'triangles', got {}",
                             mesh.vertices.cols() - 1, corners[i]),
                 "triangles");
    mesh.triangles(static_cast<Eigen::Index>(i)) = static_cast<int>(corners[i]);
  }
  return mesh;
}

void read_mesh_shape(TomlTable& table, const std::string& path, ShapeSpec& shape) {
  shape.mesh_scale = table.number_or(Dimension::kNumber, "scale", 1, Range::kPositive);
  shape.mesh_file = table.text_or("file", "");
  if (shape.mesh_file.empty()) {
    shape.mesh = read_triangles(table);
  } else {
    shape.mesh = read_mesh((std::filesystem::path(path).parent_path() / shape.mesh_file).string(),
                           shape.mesh_scale);
  }
}

std::vector<std::string> mesh_lines(const ShapeSpec& shape) {
  std::vector<std::string> lines;
  if (shape.mesh_scale != 1) lines.push_back("scale = " + toml_number(shape.mesh_scale));
  if (!shape.mesh_file.empty()) {
    lines.push_back("file = " + toml_text(shape.mesh_file));
    return lines;
  }
  const TriangleMesh& mesh = shape.mesh;
  const std::vector<double> vertices(mesh.vertices.data(),
                                     mesh.vertices.data() + mesh.vertices.size());
  lines.push_back("vertices_m = " + toml_list(vertices));
  std::vector<int> corners(mesh.triangles.data(), mesh.triangles.data() + mesh.triangles.size());
  lines.push_back(fmt::format("triangles = [{}]", fmt::join(corners, ", ")));
  return lines;
}

}  // namespace

int size_count(ShapeKind kind) {
  switch (kind) {
    case ShapeKind::kMesh:
      return 0;
    case ShapeKind::kSphere:
      return 1;
    case ShapeKind::kCylinder:
    case ShapeKind::kCapsule:
      return 2;
    default:
      return 3;
  }
}

Pose<double> read_pose(TomlTable& table) {
  Pose<double> X = pose_in(table);
  table.done();
  return X;
}

ShapeSpec read_shape(TomlTable& table, const std::string& path) {
  ShapeSpec shape;
  const std::vector<std::string>& names = shape_names();
  const std::string kind = table.choice("kind", names);
  shape.kind = static_cast<ShapeKind>(std::find(names.begin(), names.end(), kind) - names.begin());
  shape.X_BS = pose_in(table);
  if (shape.kind == ShapeKind::kMesh) read_mesh_shape(table, path, shape);
  if (const int count = size_count(shape.kind); count > 0) {
    const std::vector<double> size =
        table.numbers(Dimension::kLength, "size", count, Range::kNotNegative);
    std::copy(size.begin(), size.end(), shape.size.data());
  }
  if (shape.kind == ShapeKind::kSuperellipsoid) {
    const std::vector<double> e = table.numbers(Dimension::kNumber, "exponents", 2);
    shape.exponents << e[0], e[1];
  }
  table.done();
  return shape;
}

std::vector<std::string> pose_lines(const Pose<double>& X) {
  std::vector<std::string> lines;
  if (!same_bits(X.p, Eigen::Vector3d(0, 0, 0))) lines.push_back("position_m = " + toml_list(X.p));
  if (!same_bits(X.R, Eigen::Matrix3d(Eigen::Matrix3d::Identity())))
    lines.push_back(fmt::format("rotation = [{}, {}, {}]",
                                toml_list(Eigen::Vector3d(X.R.row(0).transpose())),
                                toml_list(Eigen::Vector3d(X.R.row(1).transpose())),
                                toml_list(Eigen::Vector3d(X.R.row(2).transpose()))));
  return lines;
}

std::vector<std::string> shape_lines(const ShapeSpec& shape) {
  std::vector<std::string> lines{"kind = " + toml_text(name_of(shape.kind))};
  if (const int count = size_count(shape.kind); count > 0)
    lines.push_back("size_m = " +
                    toml_list(std::vector<double>(shape.size.data(), shape.size.data() + count)));
  if (shape.kind == ShapeKind::kSuperellipsoid)
    lines.push_back("exponents = " +
                    toml_list(std::vector<double>{shape.exponents.x(), shape.exponents.y()}));
  if (shape.kind == ShapeKind::kMesh)
    for (std::string& line : mesh_lines(shape)) lines.push_back(std::move(line));
  for (std::string& line : pose_lines(shape.X_BS)) lines.push_back(std::move(line));
  return lines;
}

}  // namespace thenar::internal
