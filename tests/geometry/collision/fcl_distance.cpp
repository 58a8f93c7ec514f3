#include "tests/geometry/collision/fcl_distance.h"

#include <algorithm>
#include <vector>

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/math/bv/OBBRSS.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/collision_object.h>
#include <fcl/narrowphase/distance.h>

#include "base/error.h"

namespace thenar {

struct FclMesh::Model {
  std::shared_ptr<fcl::BVHModel<fcl::OBBRSS<double>>> tree;
};

namespace {

fcl::CollisionObject<double> posed(const FclMesh& mesh, const Pose<double>& X) {
  fcl::Transform3d transform = fcl::Transform3d::Identity();
  transform.linear() = X.R;
  transform.translation() = X.p;
  return fcl::CollisionObject<double>(mesh.model().tree, transform);
}

}  // namespace

FclMesh::FclMesh(const TriangleMesh& mesh) : model_(std::make_unique<Model>()) {
  require(!mesh.empty() && mesh.vertices.allFinite(),
          "a mesh for FCL must have finite vertices and triangles, got {} of these",
          mesh.triangles.cols());
  // Convert vertices and triangles to FCL's types.
  std::vector<fcl::Vector3d> vertices;
  for (Eigen::Index i = 0; i < mesh.vertices.cols(); ++i)
    vertices.emplace_back(mesh.vertices.col(i));
  std::vector<fcl::Triangle> triangles;
  const auto corner = [&](int k, Eigen::Index i) {
    return static_cast<std::size_t>(mesh.triangles(k, i));
  };
  for (Eigen::Index i = 0; i < mesh.triangles.cols(); ++i)
    triangles.emplace_back(corner(0, i), corner(1, i), corner(2, i));
  // Build FCL's tree.
  model_->tree = std::make_shared<fcl::BVHModel<fcl::OBBRSS<double>>>();
  model_->tree->beginModel();
  model_->tree->addSubModel(vertices, triangles);
  model_->tree->endModel();
}
FclMesh::~FclMesh() = default;
FclMesh::FclMesh(FclMesh&&) noexcept = default;
FclMesh& FclMesh::operator=(FclMesh&&) noexcept = default;

double fcl_distance(const FclMesh& a, const Pose<double>& X_WA, const FclMesh& b,
                    const Pose<double>& X_WB, double tolerance) {
  // Request no signed distance: for overlapping meshes FCL aborts, or returns -1.
  const fcl::DistanceRequest<double> request(false, false, 0, tolerance);
  fcl::DistanceResult<double> result;
  const auto posed_A = posed(a, X_WA), posed_B = posed(b, X_WB);
  return std::max(0.0, fcl::distance(&posed_A, &posed_B, request, result));
}

bool fcl_collide(const FclMesh& a, const Pose<double>& X_WA, const FclMesh& b,
                 const Pose<double>& X_WB) {
  const fcl::CollisionRequest<double> request;
  fcl::CollisionResult<double> result;
  const auto posed_A = posed(a, X_WA), posed_B = posed(b, X_WB);
  return fcl::collide(&posed_A, &posed_B, request, result) > 0;
}

}  // namespace thenar
