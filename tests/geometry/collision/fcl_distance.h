#pragma once

/// Distance of two meshes by the library FCL: a cross-check of signed_distance().

#include <memory>

#include "base/spatial.h"
#include "geometry/triangle_mesh.h"

namespace thenar {

/// A mesh in FCL's tree of oriented boxes swept by spheres (OBBRSS).
class FclMesh {
 public:
  /// @throws InputError if the mesh is empty or not finite.
  explicit FclMesh(const TriangleMesh& mesh);
  ~FclMesh();
  FclMesh(FclMesh&&) noexcept;
  FclMesh& operator=(FclMesh&&) noexcept;
  FclMesh(const FclMesh&) = delete;
  FclMesh& operator=(const FclMesh&) = delete;

  struct Model;  // type of FCL, in fcl_distance.cpp
  [[nodiscard]] const Model& model() const { return *model_; }

 private:
  std::unique_ptr<Model> model_;
};

/// Computes the distance of the surfaces in world, 0 where they intersect [m]. FCL's meshes are
/// surfaces: for a body inside another it is the distance of their surfaces.
/// @param tolerance  error allowed for FCL [m]; version 0.7 ignores it for trees of OBBRSS
[[nodiscard]] double fcl_distance(const FclMesh& a, const Pose<double>& X_WA, const FclMesh& b,
                                  const Pose<double>& X_WB, double tolerance = 0);

/// Returns whether the surfaces intersect.
[[nodiscard]] bool fcl_collide(const FclMesh& a, const Pose<double>& X_WA, const FclMesh& b,
                               const Pose<double>& X_WB);

}  // namespace thenar
