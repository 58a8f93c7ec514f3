#include "report/picture/grasp_view.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

constexpr double kRayOffset = 4e-3;     // Distance from a contact to where its ray begins [m]
constexpr double kThroughWeight = 0.7;  // Weight of a contact seen through the object [1]
constexpr double kUsualWeight = 0.15;   // Weight of the usual direction [1]
constexpr int kMaxCorners = 48;         // Most corners of the object
constexpr int kRoundDirections = 24;    // Directions at each height
constexpr double kHeights[] = {-50, -35, -20, -5, 10, 25, 40};  // Heights of the eye [deg]

/// A mesh in the way, with a ball around it.
struct Blocker {
  const TriangleMesh& mesh;
  Pose<double> X_WM;
  Vector3d middle_W;
  double radius;
};

Blocker blocker(const TriangleMesh& mesh, const Pose<double>& X_WM) {
  const Vector3d middle =
      (mesh.vertices.rowwise().minCoeff() + mesh.vertices.rowwise().maxCoeff()) / 2;
  return {mesh, X_WM, X_WM * middle,
          (mesh.vertices.colwise() - middle).colwise().norm().maxCoeff()};
}

std::vector<Blocker> blockers_of(const HandPicture& hand, const GraspSetup& setup) {
  const std::vector<Pose<double>> links = hand.hand.pose(hand.q);
  std::vector<Blocker> blockers;
  for (const LinkSurface& surface : hand.hand.surfaces()) {
    const Pose<double> X_WL = surface.link < 0 ? hand.X_WH : hand.X_WH * nth(links, surface.link);
    if (!surface.solid->visual.empty()) blockers.push_back(blocker(surface.solid->visual, X_WL));
  }
  for (const GraspBody& body : setup.obstacles)
    blockers.push_back(blocker(body.solid.visual, body.X_WB));
  return blockers;
}

/// Returns true if the ray from p along d meets the triangle. Source: [Moller1997].
bool meets(const Vector3d& p, const Vector3d& d, const Vector3d& a, const Vector3d& b,
           const Vector3d& c) {
  const Vector3d ab = b - a, ac = c - a, across = d.cross(ac);
  const double volume = ab.dot(across);
  if (volume == 0) return false;
  const Vector3d ap = p - a;
  const double u = ap.dot(across) / volume;
  if (u < 0 || u > 1) return false;
  const Vector3d turned = ap.cross(ab);
  const double v = d.dot(turned) / volume;
  return v >= 0 && u + v <= 1 && ac.dot(turned) / volume > 0;
}

bool blocks(const Blocker& blocker, const Vector3d& p_W, const Vector3d& d_W) {
  const Vector3d away = blocker.middle_W - p_W;
  if (away.dot(d_W) < -blocker.radius || away.cross(d_W).norm() > blocker.radius) return false;
  const Vector3d p = blocker.X_WM.inverse() * p_W, d = blocker.X_WM.R.transpose() * d_W;
  const Eigen::Matrix3Xd& at = blocker.mesh.vertices;
  const auto triangles = blocker.mesh.triangles.colwise();
  return std::any_of(triangles.begin(), triangles.end(), [&](const auto& t) {
    return meets(p, d, at.col(t[0]), at.col(t[1]), at.col(t[2]));
  });
}

bool is_seen(const std::vector<Blocker>& blockers, const Vector3d& p_W, const Vector3d& d_W) {
  return !any_of(blockers, [&](const Blocker& each) { return blocks(each, p_W, d_W); });
}

std::vector<Vector3d> directions(const Eyes& eyes) {
  const Vector3d up = eyes.up.normalized();
  const Tangents level = tangents(up);
  std::vector<Vector3d> all{eyes.usual_direction.normalized()};
  for (const double degrees : kHeights) {
    const double height = degrees * kDegree;
    if (height < eyes.min_elevation) continue;
    for (int i = 0; i < kRoundDirections; ++i) {
      const double round = 2 * kPi * (i + 0.5) / kRoundDirections;  // not along the axes
      const Vector3d out = std::cos(round) * level.e1 + std::sin(round) * level.e2;
      all.emplace_back(std::cos(height) * out + std::sin(height) * up);
    }
  }
  return all;
}

/// World frame (3, corners).
Eigen::Matrix3Xd corners_of(const GraspBody& object) {
  const Eigen::Matrix3Xd& all = object.solid.visual.vertices;
  const Eigen::Index count = std::min<Eigen::Index>(kMaxCorners, all.cols());
  Eigen::Matrix3Xd corners(3, count);
  for (Eigen::Index i = 0; i < count; ++i)
    corners.col(i) = object.X_WB * Vector3d(all.col(i * all.cols() / count));
  return corners;
}

/// World frame.
std::vector<Contact> seen_in_world(const std::vector<HandContact>& contacts,
                                   const Pose<double>& X_WB) {
  return transformed(
      contacts, [&](const HandContact& each) { return transform_contact(X_WB, each.contact); });
}

/// Share of the contacts that is seen from there [1].
double contacts_seen(const std::vector<Blocker>& blockers, const std::vector<Contact>& contacts,
                     const Vector3d& eye) {
  double sum = 0;
  for (const Contact& each : contacts)
    if (is_seen(blockers, each.p + kRayOffset * each.n, eye))
      sum += (each.n.dot(eye) > 0 ? kThroughWeight : 1) * eye.cross(each.n).norm();
  return sum / static_cast<double>(contacts.size());
}

/// Share of the corners that is seen from there [1].
double corners_seen(const std::vector<Blocker>& blockers, const Eigen::Matrix3Xd& corners,
                    const Vector3d& eye) {
  double count = 0;
  for (const auto& corner : corners.colwise())
    if (is_seen(blockers, corner, eye)) ++count;
  return count / static_cast<double>(corners.cols());
}

}  // namespace

Vector3d view_of_contacts(const HandPicture& hand, const GraspSetup& setup,
                          const std::vector<HandContact>& contacts, const Eyes& eyes) {
  Vector3d usual = eyes.usual_direction.normalized();
  if (contacts.empty()) return usual;
  const std::vector<Blocker> blockers = blockers_of(hand, setup);
  const std::vector<Contact> in_world = seen_in_world(contacts, setup.object.X_WB);
  const Eigen::Matrix3Xd corners = corners_of(setup.object);
  Vector3d best = usual;
  double most = -1;
  for (const Vector3d& eye : directions(eyes)) {
    const double worth =
        contacts_seen(blockers, in_world, eye) * std::sqrt(corners_seen(blockers, corners, eye)) +
        kUsualWeight * eye.dot(usual);
    if (worth <= most) continue;
    most = worth;
    best = eye;
  }
  return best;
}

}  // namespace thenar
