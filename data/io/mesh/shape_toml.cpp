#include "data/io/mesh/shape_toml.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>

#include "base/error.h"
#include "data/io/linked_file.h"
#include "data/io/mesh/mesh_file.h"
#include "data/io/toml_text.h"

namespace thenar {
namespace {

constexpr double kRotationTolerance = 1e-9;  // Largest deviation of R R' from the identity [1]

Eigen::Matrix3d read_rows(TomlTable& table) {
  Eigen::Matrix3d R = table.rows3("rotation");
  if (!(R * R.transpose()).isIdentity(kRotationTolerance) || R.determinant() < 0)
    table.fail("wanted 'rotation' as the rows of a rotation", "rotation");
  return R;
}

/// Rotation by roll, pitch, yaw about the fixed x, y, z:  R = Rz Ry Rx.
Eigen::Matrix3d read_rpy(TomlTable& table) {
  const Eigen::Vector3d rpy = table.vector(Dimension::kAngle, "rpy");
  return rotation_about<double>(Eigen::Vector3d::UnitZ(), rpy.z()) *
         rotation_about<double>(Eigen::Vector3d::UnitY(), rpy.y()) *
         rotation_about<double>(Eigen::Vector3d::UnitX(), rpy.x());
}

bool same_bits(const double* a, const double* b, std::size_t count) {
  return std::memcmp(a, b, count * sizeof(double)) == 0;
}

/// Reads a mesh written out as flat lists `vertices` and `triangles`.
TriangleMesh read_triangles(TomlTable& table) {
  const std::vector<double> vertices = table.numbers(Dimension::kLength, "vertices");
  const std::vector<double> corners = table.numbers(Dimension::kNumber, "triangles");
  if (vertices.size() % 3 != 0 || corners.size() % 3 != 0 || corners.empty())
    table.fail("wanted 'vertices' and 'triangles' as triples", "triangles");
  // Columns of triples; every corner must exist.
  TriangleMesh mesh;
  mesh.vertices = Eigen::Map<const Eigen::Matrix3Xd>(
      vertices.data(), 3, static_cast<Eigen::Index>(vertices.size() / 3));
  mesh.triangles.resize(3, static_cast<Eigen::Index>(corners.size() / 3));
  const auto last = static_cast<double>(mesh.vertices.cols() - 1);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (corners[i] != std::floor(corners[i]) || corners[i] < 0 || corners[i] > last)
      table.fail(fmt::format("wanted corners 0..{} in 'triangles', got {}", last, corners[i]),
                 "triangles");
    mesh.triangles(static_cast<Eigen::Index>(i)) = static_cast<int>(corners[i]);
  }
  return mesh;
}

void read_mesh_keys(TomlTable& table, const std::string& path, ShapeSpec& shape) {
  shape.mesh_scale = table.number_or(Dimension::kNumber, "scale", 1, Range::kPositive);
  // Written out in the table, or in a file beside it.
  shape.mesh_file = table.text_or("file", "");
  if (shape.mesh_file.empty()) {
    shape.mesh = read_triangles(table);
    return;
  }
  const std::string folder = std::filesystem::path(path).parent_path().string();
  shape.mesh =
      read_mesh(linked_file(table, "file", shape.mesh_file, folder, "mesh"), shape.mesh_scale);
}

Eigen::Vector2d read_exponents(TomlTable& table) {
  const std::vector<double> e = table.numbers(Dimension::kNumber, "exponents", 2);
  if (std::min(e[0], e[1]) < 0.1 || std::max(e[0], e[1]) > 2)
    table.fail(fmt::format("wanted 'exponents' in 0.1..2, got {} and {}", e[0], e[1]), "exponents");
  return {e[0], e[1]};
}

std::vector<std::string> mesh_lines(const ShapeSpec& shape) {
  std::vector<std::string> lines;
  // A mesh with a file is named, another written out.
  if (shape.mesh_scale != 1 || !shape.mesh_file.empty())
    lines.push_back("scale = " + toml_number(shape.mesh_scale));
  if (!shape.mesh_file.empty()) {
    lines.push_back("file = " + toml_quoted(shape.mesh_file));
    return lines;
  }
  const TriangleMesh& mesh = shape.mesh;
  lines.push_back("vertices_m = " +
                  toml_list(std::vector<double>(mesh.vertices.data(),
                                                mesh.vertices.data() + mesh.vertices.size())));
  const std::vector<int> corners(mesh.triangles.data(),
                                 mesh.triangles.data() + mesh.triangles.size());
  lines.push_back(fmt::format("triangles = [{}]", fmt::join(corners, ", ")));
  return lines;
}

}  // namespace

Pose<double> read_pose_keys(TomlTable& table) {
  Pose<double> X;
  X.p = table.vector_or(Dimension::kLength, "position", {0, 0, 0});
  // At most one way to state the rotation.
  const bool rows = table.has("rotation"), quaternion = table.has("quaternion_wxyz");
  const bool rpy = table.has(Dimension::kAngle, "rpy");
  const bool turn = table.has(Dimension::kAngle, "angle");
  const std::array<bool, 4> stated{rows, quaternion, rpy, turn};
  if (std::count(stated.begin(), stated.end(), true) > 1)
    table.fail("wanted one of 'rotation', 'quaternion_wxyz', 'rpy' and 'angle', got several");
  if (rows) X.R = read_rows(table);
  if (quaternion) X.R = read_quaternion(table, "quaternion_wxyz");
  if (rpy) X.R = read_rpy(table);
  if (turn)
    X.R = rotation_about<double>(read_direction(table, "axis"),
                                 table.number(Dimension::kAngle, "angle"));
  return X;
}

ShapeSpec read_shape_table(TomlTable& table, const std::string& path) {
  ShapeSpec shape;
  shape.kind = table.choice("kind", kShapeKindNames);
  shape.X_BS = read_pose_keys(table);
  // Mesh, sizes and exponents, as far as the kind has them.
  if (shape.kind == ShapeKind::kMesh) read_mesh_keys(table, path, shape);
  if (const int count = size_entries(shape.kind); count > 0) {
    const std::vector<double> size =
        table.numbers(Dimension::kLength, "size", count, Range::kPositive);
    std::copy(size.begin(), size.end(), shape.size.data());
  }
  if (shape.kind == ShapeKind::kSuperellipsoid) shape.exponents = read_exponents(table);
  table.done();
  return shape;
}

FileDigests mesh_files(const std::vector<ShapeSpec>& shapes, const std::string& path) {
  std::vector<std::string> files;
  for (const ShapeSpec& shape : shapes)
    if (!shape.mesh_file.empty())
      files.push_back((std::filesystem::path(path).parent_path() / shape.mesh_file).string());
  return digests_of(files);
}

std::vector<std::string> toml_of(const Pose<double>& X) {
  // Defaults of the reader are left out.
  const Pose<double> none;
  std::vector<std::string> lines;
  if (!same_bits(X.p.data(), none.p.data(), 3)) lines.push_back("position_m = " + toml_list(X.p));
  if (!same_bits(X.R.data(), none.R.data(), 9)) lines.push_back("rotation = " + toml_rows(X.R));
  return lines;
}

std::vector<std::string> toml_of(const ShapeSpec& shape) {
  std::vector<std::string> lines{"kind = " + toml_quoted(name_of(shape.kind))};
  if (const int count = size_entries(shape.kind); count > 0)
    lines.push_back("size_m = " +
                    toml_list(std::vector<double>(shape.size.data(), shape.size.data() + count)));
  if (shape.kind == ShapeKind::kSuperellipsoid)
    lines.push_back("exponents = " +
                    toml_list(std::vector<double>{shape.exponents.x(), shape.exponents.y()}));
  if (shape.kind == ShapeKind::kMesh)
    for (std::string& line : mesh_lines(shape)) lines.push_back(std::move(line));
  for (std::string& line : toml_of(shape.X_BS)) lines.push_back(std::move(line));
  return lines;
}

}  // namespace thenar
