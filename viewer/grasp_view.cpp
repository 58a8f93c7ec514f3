#include "viewer/grasp_view.h"

#include <algorithm>
#include <cmath>

#include "base/angles.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

constexpr double kAlong = 5e-3;     // from a contact to where its ray begins [m]
constexpr double kStep = 5e-4;      // least, along a ray [m]
constexpr double kFar = 0.4;        // where rays end [m]
constexpr double kHidden = -2e-4;   // so deep in something a ray is not only grazing it [m]
constexpr double kNearness = 0.15;  // of the given direction [1]
constexpr int kRound = 24;          // directions at each height
const Vector3d kUp(0, 0, 1);

/// Whether a ray from p along d meets a shape that stands at X_WS.
bool meets(const Shape& shape, const Pose<double>& X_WS, const Vector3d& p, const Vector3d& d) {
  const Pose<double> X_SW = X_WS.inverse();
  const Vector3d from = X_SW * p, along = X_SW.R * d;
  for (double gone = 0; gone < kFar;) {
    const double distance = shape.distance(from + gone * along);
    if (distance < kHidden) return true;
    gone += std::max(kStep, distance);
  }
  return false;
}

bool is_seen(const PosedHand& posed, const Scene& scene, const Vector3d& p, const Vector3d& d) {
  const std::vector<LinkSurface>& surfaces = posed.touching.hand->surfaces();
  for (int s = 0; s < static_cast<int>(surfaces.size()); ++s)
    if (meets(*surfaces[static_cast<std::size_t>(s)].solid->shape, posed.of_surface(s), p, d))
      return false;
  return std::none_of(scene.obstacles.begin(), scene.obstacles.end(), [&](const SceneBody& body) {
    return meets(*body.solid.shape, body.X_WB, p, d);
  });
}

std::vector<Vector3d> directions(const Vector3d& given) {
  std::vector<Vector3d> all{given};
  for (const double height : {10 * kDegree, 25 * kDegree, 40 * kDegree})
    for (int i = 0; i < kRound; ++i) {
      const double round = 2 * kPi * (i + 0.5) / kRound;  // not along the axes
      const Vector3d level(std::cos(round), std::sin(round), 0);
      all.emplace_back(std::cos(height) * level + std::sin(height) * kUp);
    }
  return all;
}

}  // namespace

Vector3d view_of_contacts(const PosedHand& posed, const Scene& scene,
                          const std::vector<HandContact>& contacts, const Vector3d& from) {
  const Vector3d given = from.normalized();
  if (contacts.empty()) return given;
  Vector3d best = given;
  double most = -1;
  for (const Vector3d& d : directions(given)) {
    double score = kNearness * d.dot(given);
    for (const HandContact& found : contacts) {
      const Contact contact = seen_from(scene.object.X_WB, found.contact);
      if (is_seen(posed, scene, contact.p + kAlong * contact.n, d))
        score += d.cross(contact.n).norm() / static_cast<double>(contacts.size());
    }
    if (score <= most) continue;
    most = score;
    best = d;
  }
  return best;
}

}  // namespace thenar
