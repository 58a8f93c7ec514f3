#pragma once

/// Triangle meshes of reports: each is stored once and referred to by name.

#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/spatial.h"
#include "geometry/triangle_mesh.h"
#include "report/blocks.h"

namespace thenar {

/// A colour as bytes of red, green, blue.
using MeshColor = Eigen::Matrix<unsigned char, 3, 1>;

/// Appearance of a mesh.
struct MeshLook {
  double crease = -1;  // smallest angle of edges that look sharp [deg]; negative: all are smooth
  std::vector<MeshColor> colors;  // colour of every vertex; empty: that of its layer
};

/// Smallest angle of edges of bodies that look sharp [deg].
inline constexpr double kBodyCrease = 35;

/// Returns an item of a picture that shows a mesh of the table at a pose.
[[nodiscard]] Json mesh_item(const std::string& mesh, const Pose<double>& X);

/// The `meshes` of a report. Corners are rounded to a 65534th of the mesh's largest side, 3 um for
/// 0.2 m.
class MeshTable {
 public:
  /// Adds a mesh and returns its name; an equal mesh is not added again.
  /// @throws InputError if the mesh is empty, not finite, or its number of colours differs from
  /// that of vertices.
  [[nodiscard]] std::string add(const TriangleMesh& mesh, const MeshLook& look = {});

  [[nodiscard]] const Json& json() const { return meshes_; }

 private:
  Json meshes_ = Json::object();
  std::map<std::string, std::string> names_;  // name by the text of a mesh
};

/// Returns the bytes in base64 (RFC 4648, padded).
[[nodiscard]] std::string base64(const unsigned char* bytes, std::size_t count);

}  // namespace thenar
