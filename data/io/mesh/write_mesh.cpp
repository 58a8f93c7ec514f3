#include <array>
#include <cstdint>
#include <cstring>
#include <iterator>

#include <Eigen/Geometry>

#include "base/error.h"
#include "base/write_file.h"
#include "data/io/mesh/mesh_file.h"

namespace thenar {
namespace {

using Text = std::back_insert_iterator<std::string>;

/// One line a column, numbers with as many digits as they need.
void append_vertices(Text out, const TriangleMesh& mesh, const char* prefix) {
  for (const auto& p : mesh.vertices.colwise())
    fmt::format_to(out, "{}{} {} {}\n", prefix, p.x(), p.y(), p.z());
}

void append_triangles(Text out, const TriangleMesh& mesh, const char* prefix, int first) {
  for (const auto& t : mesh.triangles.colwise())
    fmt::format_to(out, "{}{} {} {}\n", prefix, t.x() + first, t.y() + first, t.z() + first);
}

std::string obj(const TriangleMesh& mesh) {
  std::string text;
  append_vertices(std::back_inserter(text), mesh, "v ");
  append_triangles(std::back_inserter(text), mesh, "f ", 1);
  return text;
}

std::string off(const TriangleMesh& mesh) {
  std::string text = fmt::format("OFF\n{} {} 0\n", mesh.vertices.cols(), mesh.triangles.cols());
  append_vertices(std::back_inserter(text), mesh, "");
  append_triangles(std::back_inserter(text), mesh, "3 ", 0);
  return text;
}

std::string ply(const TriangleMesh& mesh) {
  std::string text = fmt::format(
      "ply\nformat ascii 1.0\nelement vertex {}\nproperty double x\nproperty double y\n"
      "property double z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
      mesh.vertices.cols(), mesh.triangles.cols());
  append_vertices(std::back_inserter(text), mesh, "");
  append_triangles(std::back_inserter(text), mesh, "3 ", 0);
  return text;
}

template <typename T>
void append_bytes(std::string& text, T value) {
  std::array<char, sizeof(T)> bytes;
  std::memcpy(bytes.data(), &value, sizeof(T));  // little-endian, as every target of ours
  text.append(bytes.data(), bytes.size());
}

/// 80 bytes of header, a count, then 50 bytes a triangle.
std::string stl(const TriangleMesh& mesh) {
  std::string text(80, ' ');
  append_bytes(text, static_cast<std::uint32_t>(mesh.triangles.cols()));
  for (const auto& t : mesh.triangles.colwise()) {
    const Eigen::Vector3d a = mesh.vertices.col(t(0)), b = mesh.vertices.col(t(1)),
                          c = mesh.vertices.col(t(2));
    const Eigen::Vector3d normal = (b - a).cross(c - a).normalized();
    for (const Eigen::Vector3d& v : {normal, a, b, c})
      for (const double coordinate : v) append_bytes(text, static_cast<float>(coordinate));
    append_bytes(text, std::uint16_t{0});
  }
  return text;
}

}  // namespace

std::string mesh_bytes(const std::string& path, const TriangleMesh& mesh) {
  require(!mesh.empty() && mesh.vertices.allFinite(),
          "wanted a mesh of triangles with finite corners to write to '{}'", path);
  require(mesh.triangles.minCoeff() >= 0 && mesh.triangles.maxCoeff() < mesh.vertices.cols(),
          "a triangle of the mesh for '{}' has a corner that does not exist", path);
  switch (mesh_format(path)) {
    case MeshFormat::kObj:
      return obj(mesh);
    case MeshFormat::kStl:
      return stl(mesh);
    case MeshFormat::kPly:
      return ply(mesh);
    case MeshFormat::kOff:
      return off(mesh);
    case MeshFormat::kGltf:
    case MeshFormat::kCollada:
    case MeshFormat::kVrml:
    case MeshFormat::kInventor:
      break;
  }
  throw InputError(fmt::format("meshes are written as .obj, .stl, .ply or .off, not '{}'", path));
}

void write_mesh(const std::string& path, const TriangleMesh& mesh) {
  write_file(path, mesh_bytes(path, mesh));
}

}  // namespace thenar
