#include "report/picture/mesh_table.h"

#include <cmath>
#include <cstdint>

#include <fmt/format.h>

#include "base/error.h"

namespace thenar {
namespace {

constexpr double kMaxSteps = 32767;         // either way from the middle
constexpr Eigen::Index kShortMost = 65536;  // vertices that 16 bits can count

void append(std::vector<unsigned char>& bytes, std::uint32_t value, int count) {
  for (int i = 0; i < count; ++i) bytes.push_back((value >> (8 * i)) & 0xFF);
}

std::string coded(const std::vector<unsigned char>& bytes) {
  return base64(bytes.data(), bytes.size());
}

/// Corners in steps from the middle of their box, [mm].
void add_vertices(const TriangleMesh& mesh, Json& json) {
  const Eigen::Vector3d lowest = mesh.vertices.rowwise().minCoeff();
  const Eigen::Vector3d highest = mesh.vertices.rowwise().maxCoeff();
  const Eigen::Vector3d middle = (lowest + highest) / 2;
  const double half = (highest - lowest).maxCoeff() / 2;
  const double step = half > 0 ? half / kMaxSteps : 1;  // [m]
  std::vector<unsigned char> bytes;
  for (Eigen::Index i = 0; i < mesh.vertices.cols(); ++i)
    for (int k = 0; k < 3; ++k) {
      const long steps = std::lround((mesh.vertices(k, i) - middle[k]) / step);
      append(bytes, static_cast<std::uint32_t>(steps), 2);
    }
  json["origin"] = in_mm(middle);
  json["step"] = 1000 * step;
  json["vertices"] = coded(bytes);
}

std::string triangles_of(const TriangleMesh& mesh) {
  const int width = mesh.vertices.cols() > kShortMost ? 4 : 2;
  std::vector<unsigned char> bytes;
  for (Eigen::Index i = 0; i < mesh.triangles.size(); ++i)
    append(bytes, static_cast<std::uint32_t>(mesh.triangles.data()[i]), width);
  return coded(bytes);
}

}  // namespace

std::string base64(const unsigned char* bytes, std::size_t count) {
  static constexpr char kLetters[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((count + 2) / 3 * 4);
  for (std::size_t i = 0; i < count; i += 3) {
    const std::size_t left = std::min<std::size_t>(3, count - i);
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 3; ++k) word = word << 8 | (k < left ? bytes[i + k] : 0);
    for (std::size_t k = 0; k < 4; ++k)
      text += k <= left ? kLetters[word >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

std::string MeshTable::add(const TriangleMesh& mesh, const MeshLook& look) {
  require(!mesh.empty(), "a mesh for a picture has no triangle");
  require(mesh.vertices.allFinite(), "a mesh for a picture has a vertex that is not finite");
  const auto vertices = static_cast<std::size_t>(mesh.vertices.cols());
  require(look.colors.empty() || look.colors.size() == vertices,
          "a mesh of {} vertices has colours for {}", vertices, look.colors.size());
  Json json;
  add_vertices(mesh, json);
  json["triangles"] = triangles_of(mesh);
  if (look.crease >= 0) json["crease"] = look.crease;
  if (!look.colors.empty()) json["colors"] = base64(look.colors.front().data(), 3 * vertices);
  const auto [entry, is_new] =
      names_.emplace(json.dump(), fmt::format("mesh {}", names_.size() + 1));
  if (is_new) meshes_[entry->second] = std::move(json);
  return entry->second;
}

Json mesh_item(const std::string& mesh, const Pose<double>& X) {
  return {
      {"kind", "mesh"},
      {"mesh", mesh},
      {"rotation", Json::array({numbers3(X.R.row(0)), numbers3(X.R.row(1)), numbers3(X.R.row(2))})},
      {"position", in_mm(X.p)}};
}

}  // namespace thenar
