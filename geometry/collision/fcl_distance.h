#pragma once

/// The distance of two meshes as FCL finds it: a cross-check of signed_distance(), and its rival.

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

  struct Model;  // FCL's own; in fcl_separation.cpp
  [[nodiscard]] const Model& model() const { return *model_; }

 private:
  std::unique_ptr<Model> model_;
};

/// The distance of the surfaces in world, 0 where they cross [m]. FCL's meshes are surfaces: a body
/// wholly inside another is as far from it as its surface.
/// @param tolerance  error that FCL may make [m]; version 0.7 heeds none for trees of OBBRSS
[[nodiscard]] double fcl_distance(const FclMesh& a, const Pose<double>& X_WA, const FclMesh& b,
                                  const Pose<double>& X_WB, double tolerance = 0);

/// Returns whether the surfaces cross.
[[nodiscard]] bool fcl_collide(const FclMesh& a, const Pose<double>& X_WA, const FclMesh& b,
                               const Pose<double>& X_WB);

}  // namespace thenar
