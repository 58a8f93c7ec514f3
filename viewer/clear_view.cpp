#include "viewer/clear_view.h"

#include <algorithm>
#include <cmath>

#include "base/angles.h"
#include "base/spatial.h"

namespace thenar {
namespace {

constexpr int kAround = 10, kMostContacts = 12;
constexpr double kHeights[] = {-50, -20, 10, 40};  // above the plane across the approach [deg]
constexpr double kThrough = 0.7;                   // worth of a contact seen through the object [1]
constexpr double kUsual = 0.1;  // worth of looking from where one usually does [contacts]

/// A link as something in the way, with a ball around it.
struct Blocker {
  const TriangleMesh& mesh;
  Pose<double> X_WL;
  Eigen::Vector3d middle_W;
  double radius;
};

std::vector<Blocker> blockers_of(const HandPicture& picture) {
  const std::vector<Pose<double>> links = picture.hand.pose(picture.q);
  std::vector<Blocker> blockers;
  for (const LinkSurface& surface : picture.hand.surfaces()) {
    const TriangleMesh& mesh = surface.solid->picture;
    if (mesh.empty()) continue;
    const Pose<double> X_WL = surface.link < 0
                                  ? picture.X_WH
                                  : picture.X_WH * links[static_cast<std::size_t>(surface.link)];
    const Eigen::Vector3d middle =
        (mesh.vertices.rowwise().minCoeff() + mesh.vertices.rowwise().maxCoeff()) / 2;
    blockers.push_back({mesh, X_WL, X_WL * middle,
                        (mesh.vertices.colwise() - middle).colwise().norm().maxCoeff()});
  }
  return blockers;
}

/// Whether the ray from p along d meets the triangle. Source: [Moller1997].
bool meets(const Eigen::Vector3d& p, const Eigen::Vector3d& d, const Eigen::Vector3d& a,
           const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const Eigen::Vector3d ab = b - a, ac = c - a, across = d.cross(ac);
  const double volume = ab.dot(across);
  if (volume == 0) return false;
  const Eigen::Vector3d ap = p - a;
  const double u = ap.dot(across) / volume;
  if (u < 0 || u > 1) return false;
  const Eigen::Vector3d turned = ap.cross(ab);
  const double v = d.dot(turned) / volume;
  return v >= 0 && u + v <= 1 && ac.dot(turned) / volume > 0;
}

bool blocks(const Blocker& blocker, const Eigen::Vector3d& p_W, const Eigen::Vector3d& d_W) {
  const Eigen::Vector3d away = blocker.middle_W - p_W;
  if (away.dot(d_W) < -blocker.radius || away.cross(d_W).norm() > blocker.radius) return false;
  const Eigen::Vector3d p = blocker.X_WL.inverse() * p_W, d = blocker.X_WL.R.transpose() * d_W;
  const Eigen::Matrix3Xd& at = blocker.mesh.vertices;
  for (const auto& t : blocker.mesh.triangles.colwise())
    if (meets(p, d, at.col(t[0]), at.col(t[1]), at.col(t[2]))) return true;
  return false;
}

/// How much of the contacts is seen from there [contacts].
double seen(const std::vector<Blocker>& blockers, const std::vector<Contact>& contacts,
            double inside, const Eigen::Vector3d& eye) {
  const std::size_t step = (contacts.size() + kMostContacts - 1) / kMostContacts;
  double sum = 0, asked = 0;
  for (std::size_t i = 0; i < contacts.size(); i += std::max<std::size_t>(step, 1)) {
    const Eigen::Vector3d p = contacts[i].p + inside * contacts[i].n;
    ++asked;
    const bool hidden = std::any_of(blockers.begin(), blockers.end(),
                                    [&](const Blocker& each) { return blocks(each, p, eye); });
    if (!hidden) sum += contacts[i].n.dot(eye) > 0 ? kThrough : 1;
  }
  return asked > 0 ? sum / asked : 0;
}

}  // namespace

Eigen::Vector3d clear_view(const HandPicture& picture, const std::vector<Contact>& contacts,
                           double inside, const Eigen::Vector3d& usual) {
  const Eigen::Vector3d back =
      -(picture.X_WH.R * picture.hand.layout().approach.direction).normalized();
  const Tangents side = tangents(back);
  const std::vector<Blocker> blockers = blockers_of(picture);
  Eigen::Vector3d best = usual.normalized();
  double most = seen(blockers, contacts, inside, best) + kUsual;
  for (const double height : kHeights)
    for (int i = 0; i < kAround; ++i) {
      const double turn = 2 * kPi * i / kAround, up = height * kPi / 180;
      const Eigen::Vector3d eye =
          std::cos(up) * (std::cos(turn) * side.e1 + std::sin(turn) * side.e2) +
          std::sin(up) * back;
      const double worth =
          seen(blockers, contacts, inside, eye) + kUsual * eye.dot(usual.normalized());
      if (worth <= most) continue;
      most = worth;
      best = eye;
    }
  return best;
}

}  // namespace thenar
