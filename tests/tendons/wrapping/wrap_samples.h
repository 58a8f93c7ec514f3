#pragma once

/// Scenes for the tests of wrapped paths.

#include <random>

#include "hand/chain.h"
#include "tendons/wrapping/path_arms.h"

namespace thenar::sample {

/// A surface of the base with its frame at the origin.
inline BoneSurface surface(SurfaceShape shape, const Eigen::Vector3d& size) {
  return {"bone", -1, shape, size, {}};
}

/// One strand of the base from a to b over the given surfaces, each passed on the side of `side`.
inline PathSet string_over(std::vector<BoneSurface> surfaces, const Eigen::Vector3d& a,
                           const Eigen::Vector3d& b, const Eigen::Vector3d& side) {
  PathSet set;
  WrappedPath path;
  path.name = "string";
  path.points = {{-1, a}, {-1, b}};
  path.bends.resize(1);
  for (std::size_t i = 0; i < surfaces.size(); ++i)
    path.bends[0].push_back({static_cast<int>(i), surfaces[i].X.inverse() * side});
  set.surfaces = std::move(surfaces);
  set.paths = {path};
  return set;
}

/// Shape of the only strand of a set that does not move.
inline PathShape shape_of(const PathSet& set) { return PathSolver(set).solve({})[0]; }

/// Three skew hinges in a row, 40 mm apart along -x, that flex towards -y.
inline Tree<double> finger() {
  using Eigen::Vector3d;
  return {{-1, 0, 1, 0, Vector3d(0.1, -0.05, 1).normalized(), {0, 0, 0}},
          {0, 1, 1, 0, Vector3d(-0.05, 0.1, 1).normalized(), {-0.04, 0, 0}},
          {1, 2, 1, 0, Vector3d(0.02, 0.1, 1).normalized(), {-0.08, 0, 0}}};
}

/// An extensor over the heads of two bones of that finger, whatever their shape; sizes in mm.
inline PathSet extensor(SurfaceShape shape) {
  using Eigen::Vector3d;
  Vector3d size(0.006, 0, 0);
  if (shape == SurfaceShape::kCapsule) size = {0.006, 0.004, 0};
  if (shape == SurfaceShape::kEllipsoid) size = {0.008, 0.006, 0.010};
  if (shape == SurfaceShape::kTorus) size = {0.0015, 0.0035, 0};
  const auto head = [&](int link, double x) {
    Pose<double> X;
    X.p = {x, 0, 0.0005};
    X.R = rotation_about(Vector3d(Vector3d(1, 1, 0.3).normalized()), 0.1);
    if (shape == SurfaceShape::kTorus) {  // a sleeve dorsally, along the finger
      X.p.y() = 0.007;
      X.R = X.R * rotation_about(Vector3d(Vector3d::UnitY()), 1.5707963);
    }
    return BoneSurface{"head", link, shape, size, X};
  };
  PathSet set;
  set.surfaces = {head(0, -0.038), head(1, -0.079)};
  WrappedPath path;
  path.name = "ED";
  const bool ring = shape == SurfaceShape::kTorus;
  path.points = {{2, {-0.1, 0.004, 0.001}},
                 {1, {-0.055, 0.008, ring ? 0.000 : -0.001}},
                 {-1, {0.02, 0.009, 0.002}}};
  for (int bend : {1, 0}) {
    const BoneSurface& over = set.surfaces[static_cast<std::size_t>(bend)];
    const Vector3d side = over.X.p + Vector3d(0, ring ? 0 : 0.012, 0);
    path.bends.push_back({{bend, over.X.inverse() * side}});
  }
  set.paths = {path};
  return set;
}

/// The length of a path at a posture [m].
inline double length_at(const Tree<double>& tree, const PathSet& set, const Eigen::VectorXd& q,
                        std::size_t path = 0) {
  return PathSolver(set).solve(pose_tree(tree, q))[path].length;
}

/// -dL/dq by central differences of fourth order [m/rad].
inline Eigen::RowVectorXd measured_arms(const Tree<double>& tree, const PathSet& set,
                                        const Eigen::VectorXd& q, std::size_t path = 0) {
  constexpr double h = 1e-3;  // [rad]
  Eigen::RowVectorXd R(q.size());
  for (Eigen::Index j = 0; j < q.size(); ++j) {
    const auto at = [&](double step) {
      Eigen::VectorXd moved = q;
      moved[j] += step;
      return length_at(tree, set, moved, path);
    };
    R[j] = -(8 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12 * h);
  }
  return R;
}

}  // namespace thenar::sample
