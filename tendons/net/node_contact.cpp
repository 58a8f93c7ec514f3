#include "tendons/net/node_contact.h"

#include <algorithm>
#include <cmath>

#include <Eigen/QR>

#include "base/spatial.h"

namespace thenar::internal {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kOnSurface = 1e-12;  // gap that counts as zero [m]

using Normals = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3>;
using Forces = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1>;

/// Surfaces in contact with a node.
struct HeldSurfaces {
  std::array<int, 3> number;  // indices in Net::surfaces
  int count;                  // number of surfaces
};

/// Computes normals and gaps of the surfaces `held`. @return largest |gap| [m]
double gaps(const Net& net, const NetScene& scene, const HeldSurfaces& held, const Vector3d& x,
            Normals& N, Forces& gap) {
  N.resize(3, held.count);
  gap.resize(held.count);
  for (int i = 0; i < held.count; ++i) {
    const SurfaceGap at = gap_world(net, scene, held.number[i], x);
    N.col(i) = at.normal;
    gap(i) = at.gap;
  }
  return gap.size() > 0 ? gap.cwiseAbs().maxCoeff() : 0;
}

/// Moves x to the nearest point, to first order, on all surfaces held. @return whether it converged
bool move_onto(const Net& net, const NetScene& scene, const HeldSurfaces& held, Vector3d& x) {
  if (held.count == 0) return true;
  // Move along the normal of one surface.
  if (held.count == 1) {  // twice for rounding
    for (int i = 0; i < 2; ++i) {
      const SurfaceGap at = gap_world(net, scene, held.number[0], x);
      x -= at.gap * at.normal;
      if (std::abs(at.gap) < 1e-12) return true;
    }
    return std::abs(gap_world(net, scene, held.number[0], x).gap) < kOnSurface;
  }
  // Solve all gaps together by Newton's method for several surfaces.
  Normals N;
  Forces gap;
  for (int i = 0; i < 30; ++i) {
    if (gaps(net, scene, held, x, N, gap) < 1e-16) return true;
    const Vector3d move = N.transpose().completeOrthogonalDecomposition().solve(gap);
    x -= move;
    if (move.norm() < 1e-15) break;
  }
  return gaps(net, scene, held, x, N, gap) < kOnSurface;
}

/// Returns the surface that x penetrates most; -1: none.
int deepest_surface(const Net& net, const NetScene& scene, const NetNode& node, const Vector3d& x) {
  int worst = -1;
  double depth = -kOnSurface;
  for (int s : node.surfaces) {
    const double gap = gap_world(net, scene, s, x).gap;
    if (gap < depth) depth = gap, worst = s;
  }
  return worst;
}

/// Sets the rows of Q to n and two tangents.
void set_basis(const Vector3d& n, Matrix3d& Q) {
  const Tangents t = tangents(n);
  Q << n.transpose(), t.e1.transpose(), t.e2.transpose();
}

/// Balances a node on one surface, as balance_node().
void balance_one(const Vector3d& g, double slop, const Matrix3d& curvature, NodeContact& contact) {
  const double force = contact.normal[0].dot(g);
  contact.pressed = contact.pinned = force >= -slop ? 1 : 0;
  if (contact.pressed == 0) return;
  contact.force[0] = force;
  contact.residual -= force * contact.normal[0];
  contact.curvature = force * curvature;
  set_basis(contact.normal[0], contact.Q);
}

}  // namespace

void balance_node(const Net& net, const NetScene& scene, const Vector3d& x, const Vector3d& g,
                  const std::array<double, 3>& slop, NodeContact& contact) {
  // Start with all touching surfaces pressed.
  contact.residual = g;
  contact.Q.setIdentity();
  contact.curvature.setZero();
  contact.pressed = contact.touching;
  contact.pinned = 0;
  // Balance a collapsed node by its pull, up to the pull's size.
  if (contact.collapsed > 0) {
    contact.residual *= std::max(1 - contact.collapsed / std::max(g.norm(), 1e-300), 0.0);
    contact.pinned = 3;
    contact.pressed = 0;
    return;
  }
  // Compute normals and curvatures at the node.
  std::array<Matrix3d, 3> curvature;
  std::array<double, 3> min_slop = slop;
  for (int i = 0; i < contact.touching; ++i) {
    const SurfaceProbe at = probe_world(net, scene, contact.surface[i], x);
    contact.normal[i] = at.normal;
    curvature[i] = at.curvature;
  }
  if (contact.touching == 1) return balance_one(g, min_slop[0], curvature[0], contact);
  // Solve by least squares; drop the surface with the most negative force, and repeat.
  Normals N;
  Forces force;
  while (contact.pressed > 0) {
    N.resize(3, contact.pressed);
    for (int i = 0; i < contact.pressed; ++i) N.col(i) = contact.normal[i];
    force = N.completeOrthogonalDecomposition().solve(g);
    int worst = 0;
    for (int i = 1; i < contact.pressed; ++i)
      if (force(i) + min_slop[i] < force(worst) + min_slop[worst]) worst = i;
    if (force(worst) >= -min_slop[worst]) break;
    // Release the surface with the largest tension: move it behind the pressed ones.
    --contact.pressed;
    std::swap(contact.surface[worst], contact.surface[contact.pressed]);
    std::swap(contact.normal[worst], contact.normal[contact.pressed]);
    std::swap(curvature[worst], curvature[contact.pressed]);
    std::swap(min_slop[worst], min_slop[contact.pressed]);
  }
  // Subtract the forces from the residual, and add up their curvatures.
  contact.pinned = contact.pressed;
  if (contact.pressed == 0) return;
  for (int i = 0; i < contact.pressed; ++i) {
    contact.force[i] = force(i);
    contact.residual -= force(i) * contact.normal[i];
    contact.curvature += force(i) * curvature[i];
  }
  // Build the basis of normals and tangents.
  if (contact.pressed == 1) {
    set_basis(contact.normal[0], contact.Q);
  } else {
    contact.Q = Matrix3d(Eigen::HouseholderQR<Normals>(N).householderQ()).transpose();
  }
}

bool project_node(const Net& net, const NetScene& scene, const NetNode& node, Vector3d& x,
                  NodeContact& contact) {
  // Start on the pressed surfaces, and add others that are penetrated.
  const Vector3d wanted = x;
  HeldSurfaces held{contact.surface, contact.pressed};
  while (true) {
    if (!move_onto(net, scene, held, x)) return false;
    // Find another surface that is penetrated there.
    const int next = deepest_surface(net, scene, node, x);
    if (next < 0) break;
    // Try the new surface alone; otherwise add it to those held.
    if (held.count > contact.pressed) {
      HeldSurfaces alone{contact.surface, contact.pressed + 1};
      alone.number[contact.pressed] = next;
      Vector3d there = wanted;
      if (move_onto(net, scene, alone, there) && deepest_surface(net, scene, node, there) < 0) {
        held = alone, x = there;
        break;
      }
    }
    // Fail beyond three surfaces, which determine a point.
    if (held.count == 3) return false;
    held.number[held.count++] = next;
  }
  contact.surface = held.number;
  contact.touching = contact.pressed = held.count;
  return true;
}

namespace {

/// Radial direction and distance from the centre of a sphere, or from the axis of a cylinder.
struct Radial {
  Vector3d normal;
  double distance, inverse;  // [m], [1/m]
};

bool is_round(const BoneSurface& bone) {
  return bone.shape == SurfaceShape::kSphere || bone.shape == SurfaceShape::kCylinder;
}

Radial radial(const BoneSurface& bone, const Pose<double>& X, const Vector3d& x) {
  Vector3d from = x - X.p;
  if (bone.shape == SurfaceShape::kCylinder) {
    const Vector3d d = X.R.col(2);
    from -= d.dot(from) * d;
  }
  const double distance = from.norm(), inverse = 1 / distance;
  return {inverse * from, distance, inverse};
}

}  // namespace

SurfaceGap gap_world(const Net& net, const NetScene& scene, int surface, const Vector3d& x) {
  // Use the closed form of round surfaces.
  const BoneSurface& bone = net.surfaces[surface];
  if (is_round(bone)) {
    const Radial at = radial(bone, scene.surface[surface], x);
    if (at.distance > 0) return {at.distance - bone.size[0], at.normal};
  }
  const SurfaceProbe at = probe_world(net, scene, surface, x);
  return {at.gap, at.normal};
}

SurfaceProbe probe_world(const Net& net, const NetScene& scene, int surface, const Vector3d& x) {
  const BoneSurface& bone = net.surfaces[surface];
  const Pose<double>& X = scene.surface[surface];
  if (is_round(bone)) {
    const Radial to = radial(bone, X, x);
    if (to.distance > 0) {
      Matrix3d across = Matrix3d::Identity() - to.normal * to.normal.transpose();
      // Remove the curvature along the axis of a cylinder.
      if (bone.shape == SurfaceShape::kCylinder) {
        const Vector3d d = X.R.col(2);
        across -= d * d.transpose();
      }
      return {to.distance - bone.size[0], to.normal, to.inverse * across};
    }
  }
  // Probe other surfaces in their own frame.
  SurfaceProbe at = probe(bone, X.R.transpose() * (x - X.p));
  at.normal = X.R * at.normal;
  at.curvature = X.R * at.curvature * X.R.transpose();
  return at;
}

}  // namespace thenar::internal
