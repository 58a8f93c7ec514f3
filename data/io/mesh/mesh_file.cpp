#include "data/io/mesh/mesh_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <iterator>

#include <Eigen/Geometry>

#include "base/file_io.h"
#include "base/words.h"
#include "data/io/file_guard.h"
#include "data/io/mesh/foreign_mesh.h"
#include "data/io/mesh/polygons.h"
#include "data/io/mesh/transformed_primitive.h"
#include "data/io/mesh/triangle_soup.h"

namespace thenar {
namespace {

/// Format by the file name's ending; null: no mesh.
const MeshFormat* find_format(const std::string& path) {
  static const std::map<std::string, MeshFormat> formats{
      {".obj", MeshFormat::kObj},     {".stl", MeshFormat::kStl},   {".ply", MeshFormat::kPly},
      {".off", MeshFormat::kOff},     {".gltf", MeshFormat::kGltf}, {".glb", MeshFormat::kGltf},
      {".dae", MeshFormat::kCollada}, {".wrl", MeshFormat::kVrml},  {".vrml", MeshFormat::kVrml},
      {".iv", MeshFormat::kInventor}};
  const auto found = formats.find(lower_case(std::filesystem::path(path).extension().string()));
  return found == formats.end() ? nullptr : &found->second;
}

}  // namespace

MeshFormat mesh_format(const std::string& path) {
  const MeshFormat* format = find_format(path);
  if (format == nullptr)
    throw DataError(path, 1,
                    "a mesh is .obj, .stl, .ply, .off, .gltf, .glb, .dae, .wrl, .vrml or .iv");
  return *format;
}

std::string plain_file_name(std::string name) {
  std::replace_if(
      name.begin(), name.end(),
      [](unsigned char c) { return std::isalnum(c) == 0 && c != '.' && c != '-'; }, '_');
  return name;
}

bool is_mesh_file(const std::string& path) { return find_format(path) != nullptr; }

namespace {

TriangleSoup read_soup(const std::string& path, MeshTime& left) {
  const MeshFormat format = mesh_format(path);
  const auto text = [&] { return read_guarded(path, GuardedKind::kMesh); };
  if (format == MeshFormat::kStl) return parse_stl(text(), path);
  if (format == MeshFormat::kObj) return triangulate_polygons(parse_obj(text(), path), path);
  if (format == MeshFormat::kPly) return triangulate_polygons(parse_ply(text(), path), path);
  if (format == MeshFormat::kOff) return triangulate_polygons(parse_off(text(), path), path);
  return read_foreign_mesh(path, format, left);
}

/// @throws DataError if the file was never fetched from the store for large files of its repository
void require_no_pointer(const std::string& path) {
  const std::string beginning = "version https://git-lfs.github.com/spec/";
  if (read_start(path, beginning.size()) == beginning)
    throw DataError(path, 1,
                    "this is a pointer of Git LFS, not the mesh; `git lfs pull` fetches the mesh");
}

MeshContent read_in(const std::string& path, double scale, MeshTime& left) {
  require(scale > 0 && std::isfinite(scale), "a mesh is scaled by a number > 0, got {}", scale);
  require_no_pointer(path);
  const TriangleSoup soup = read_soup(path, left);
  // Weld the loose triangles; exact shapes get the same scale.
  MeshContent content{weld_vertices(soup, scale, path), {}};
  for (const ShapeSpec& shape : soup.exact) content.exact.push_back(scaled_primitive(shape, scale));
  return content;
}

}  // namespace

TriangleMesh read_mesh(const std::string& path, double scale) {
  return read_mesh_content(path, scale).mesh;
}

MeshContent read_mesh_content(const std::string& path, double scale) {
  MeshTime time;
  return read_in(path, scale, time);
}

const MeshContent& MeshReader::content(const std::string& path, double scale) {
  const auto key = std::make_pair(path, scale);
  // A file that failed once fails again, without being read.
  if (const auto failed = failures_.find(key); failed != failures_.end()) throw failed->second;
  auto found = contents_.find(key);
  try {
    // Read once, then count its triangles against the limit.
    if (found == contents_.end()) found = contents_.emplace(key, read_in(path, scale, left_)).first;
    if (found->second.mesh.triangles.cols() > kMaxTogether - triangles_)
      throw DataError(path, 1,
                      fmt::format("is not read: with it the meshes of one file have more than {} "
                                  "triangles",
                                  kMaxTogether));
  } catch (const DataError& error) {
    failures_.emplace(key, error);
    throw;
  }
  triangles_ += found->second.mesh.triangles.cols();
  return found->second;
}

FileDigests MeshReader::files() const {
  std::vector<std::string> paths;
  for (const auto& [key, content] : contents_) paths.push_back(key.first);
  for (const auto& [key, error] : failures_)
    if (is_file(key.first)) paths.push_back(key.first);
  return digests_of(paths);
}

namespace {

using Text = std::back_insert_iterator<std::string>;

/// Appends vertices, one a line, with as many digits as they need.
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
void append_value(std::string& text, T value) {
  std::array<char, sizeof(T)> bytes;
  std::memcpy(bytes.data(), &value, sizeof(T));  // little-endian, as every target of ours
  text.append(bytes.data(), bytes.size());
}

/// Binary STL: 80 bytes of header, a count, then 50 bytes a triangle.
std::string stl(const TriangleMesh& mesh) {
  std::string text(80, ' ');
  append_value(text, static_cast<std::uint32_t>(mesh.triangles.cols()));
  for (const auto& t : mesh.triangles.colwise()) {
    const Eigen::Vector3d a = mesh.vertices.col(t(0)), b = mesh.vertices.col(t(1)),
                          c = mesh.vertices.col(t(2));
    // Normal and corners in single precision, then two unused bytes.
    const Eigen::Vector3d normal = (b - a).cross(c - a).normalized();
    for (const Eigen::Vector3d& v : {normal, a, b, c})
      for (const double coordinate : v) append_value(text, static_cast<float>(coordinate));
    append_value(text, std::uint16_t{0});
  }
  return text;
}

}  // namespace

std::string mesh_bytes(const std::string& path, const TriangleMesh& mesh) {
  require(!mesh.empty() && mesh.vertices.allFinite(),
          "wanted a mesh of triangles with finite corners to write to '{}'", path);
  require(mesh.triangles.minCoeff() >= 0 && mesh.triangles.maxCoeff() < mesh.vertices.cols(),
          "a triangle of the mesh for '{}' has a corner that does not exist", path);
  // Formats that can be written.
  const MeshFormat format = mesh_format(path);
  if (format == MeshFormat::kObj) return obj(mesh);
  if (format == MeshFormat::kStl) return stl(mesh);
  if (format == MeshFormat::kPly) return ply(mesh);
  if (format == MeshFormat::kOff) return off(mesh);
  throw InputError(fmt::format("meshes are written as .obj, .stl, .ply or .off, not '{}'", path));
}

void write_mesh(const std::string& path, const TriangleMesh& mesh) {
  write_file(path, mesh_bytes(path, mesh));
}

}  // namespace thenar
