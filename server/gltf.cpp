#include "server/gltf.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <map>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "report/json.h"
#include "report/picture/mesh_table.h"
#include "server/bytes.h"
#include "server/frame.h"

namespace thenar {
namespace {

constexpr std::size_t kMaxGltfBytes = 1UL << 30U;  // largest size of the buffer [bytes]

// Constants of the format.
constexpr int kFloat = 5126, kUnsigned = 5125;          // component types
constexpr int kVertices = 34962, kIndices = 34963;      // targets of buffer views
constexpr int kLineStrip = 3;                           // mode of a primitive
constexpr std::array<std::array<double, 3>, 6> kColors{{// RGB colours of roles, and of lines [1]
                                                        {0.87, 0.68, 0.55},
                                                        {0.93, 0.80, 0.74},
                                                        {0.92, 0.89, 0.80},
                                                        {0.35, 0.55, 0.80},
                                                        {0.60, 0.60, 0.60},
                                                        {0.75, 0.10, 0.10}}};
constexpr int kLineColor = 5;

/// glTF file under construction.
class GltfFile {
 public:
  GltfFile() : json_{{"asset", {{"version", "2.0"}, {"generator", "thenar"}}}, {"scene", 0}} {
    for (const auto& color : kColors)
      json_["materials"].push_back(
          {{"pbrMetallicRoughness",
            {{"baseColorFactor", {color[0], color[1], color[2], 1}}, {"metallicFactor", 0}}},
           {"doubleSided", true}});
  }

  /// Adds points [m]. @return their accessor
  std::size_t add_points(const Eigen::Matrix3Xd& points) {
    LittleEndianWriter out(static_cast<std::size_t>(12 * points.cols()));
    const Eigen::Matrix3Xf rounded = points.cast<float>();
    for (const float coordinate : rounded.reshaped()) out.add<float>(coordinate);
    // State the bounds, which the format requires of positions.
    const Eigen::Vector3f min = rounded.rowwise().minCoeff(), max = rounded.rowwise().maxCoeff();
    OrderedJson accessor{{"componentType", kFloat}, {"count", points.cols()}, {"type", "VEC3"}};
    accessor["min"] = {min.x(), min.y(), min.z()};
    accessor["max"] = {max.x(), max.y(), max.z()};
    return add_accessor(out.take(), kVertices, std::move(accessor));
  }

  /// Adds a mesh of triangles. @return its index
  std::size_t add_mesh(const TriangleMesh& mesh, int material) {
    const std::size_t points = add_points(mesh.vertices);
    LittleEndianWriter out(static_cast<std::size_t>(12 * mesh.triangles.cols()));
    for (const int corner : mesh.triangles.reshaped()) out.add<std::uint32_t>(corner);
    const std::size_t corners = add_accessor(
        out.take(), kIndices,
        {{"componentType", kUnsigned}, {"count", mesh.triangles.size()}, {"type", "SCALAR"}});
    return add_primitive(
        {{"attributes", {{"POSITION", points}}}, {"indices", corners}, {"material", material}});
  }

  /// Adds a line through points. @return index of its mesh
  std::size_t add_line(const Eigen::Matrix3Xd& points) {
    return add_primitive({{"attributes", {{"POSITION", add_points(points)}}},
                          {"mode", kLineStrip},
                          {"material", kLineColor}});
  }

  void add_node(OrderedJson node) { nodes_.push_back(append("nodes", std::move(node))); }

  /// Returns the file, with a root node above all nodes.
  [[nodiscard]] std::string text() {
    // Add the root, which rotates by -90 degrees about x: z becomes y.
    const double half = std::sqrt(0.5);
    OrderedJson root{{"name", "z up"}, {"rotation", {-half, 0, 0, half}}};
    if (!nodes_.empty()) root["children"] = nodes_;
    OrderedJson scene;
    scene["nodes"].push_back(append("nodes", std::move(root)));
    json_["scenes"].push_back(std::move(scene));
    // Embed the buffer.
    if (buffer_.empty()) return json_text(json_, -1);
    const auto* bytes = reinterpret_cast<const unsigned char*>(buffer_.data());
    json_["buffers"].push_back(
        {{"byteLength", buffer_.size()},
         {"uri", "data:application/octet-stream;base64," + base64(bytes, buffer_.size())}});
    return json_text(json_, -1);
  }

 private:
  std::size_t append(const char* list, OrderedJson entry) {
    json_[list].push_back(std::move(entry));
    return json_[list].size() - 1;
  }

  /// Adds a mesh with one primitive. @return its index
  std::size_t add_primitive(OrderedJson primitive) {
    OrderedJson mesh;
    mesh["primitives"].push_back(std::move(primitive));
    return append("meshes", std::move(mesh));
  }

  std::size_t add_accessor(const std::string& bytes, int target, OrderedJson accessor) {
    require(buffer_.size() + bytes.size() <= kMaxGltfBytes, "the picture is too large for glTF");
    accessor["bufferView"] = append("bufferViews", {{"buffer", 0},
                                                    {"byteOffset", buffer_.size()},
                                                    {"byteLength", bytes.size()},
                                                    {"target", target}});
    buffer_ += bytes;
    return append("accessors", std::move(accessor));
  }

  OrderedJson json_;
  std::string buffer_;
  std::vector<std::size_t> nodes_;
};

OrderedJson node_of(const LiveBody& body, const Pose<double>& X, std::size_t mesh) {
  const Eigen::Vector4d q = quaternion_of(X.R);  // w, x, y, z; glTF has x, y, z, w
  return {{"name", body.name},
          {"mesh", mesh},
          {"translation", to_json(X.p)},
          {"rotation", {q(1), q(2), q(3), q(0)}}};
}

}  // namespace

std::string gltf_text(const LiveShape& shape, const LiveInstant& instant) {
  GltfFile file;
  // Add the bodies; those with the same mesh and role share one mesh of the file.
  std::map<std::pair<const TriangleMesh*, int>, std::size_t> meshes;
  for (std::size_t i = 0; i < shape.bodies.size(); ++i) {
    const LiveBody& body = shape.bodies[i];
    if (body.mesh == nullptr || body.mesh->empty()) continue;
    const std::pair<const TriangleMesh*, int> key{body.mesh.get(), static_cast<int>(body.role)};
    const auto found = meshes.find(key);
    const std::size_t mesh = found != meshes.end()
                                 ? found->second
                                 : (meshes[key] = file.add_mesh(*body.mesh, key.second));
    file.add_node(node_of(body, instant.bodies[i], mesh));
  }
  // Add the lines.
  std::size_t point = 0;
  for (const LiveLine& line : shape.lines) {
    Eigen::Matrix3Xd points(3, line.points);
    for (int k = 0; k < line.points; ++k) points.col(k) = instant.line_points[point++];
    if (line.points < 2) continue;
    file.add_node({{"name", line.name}, {"mesh", file.add_line(points)}});
  }
  return file.text();
}

}  // namespace thenar
