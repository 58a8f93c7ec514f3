#include "grasp/closing/describe_grasp.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/lists.h"

namespace thenar {
namespace {

// Minimum size of a listed component over the largest [1]
constexpr double kMinComponentRatio = 1.0 / 3;
constexpr double kNoRotation = 1e-12;  // rotation per unit of a coordinate that is rounding [1]

/// Lists the large components, the first three as `along` an axis, the others as `about` one.
std::string large_components(const Eigen::Matrix<double, 6, 1>& vector, const char* along,
                             const char* about) {
  const double largest = vector.cwiseAbs().maxCoeff();
  if (!(largest > 0)) return "none";
  std::vector<std::string> parts;
  for (int k = 0; k < 6; ++k)
    if (std::abs(vector[k]) >= kMinComponentRatio * largest)
      parts.push_back(
          fmt::format("{} {}{}", k < 3 ? along : about, vector[k] > 0 ? "+" : "-", "xyz"[k % 3]));
  return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace

std::string direction_words(const ScaledWrench& wrench) {
  return large_components(wrench.vector(), "force along", "torque about");
}

std::string describe_motion(const ScaledMotion& motion) {
  return large_components(motion.vector(), "along", "turning about");
}

std::string describe_overlaps(const std::vector<Overlap>& overlaps) {
  const auto words = [](const Overlap& each) {
    return fmt::format("{} is {:.2f} mm in {}", each.surface, 1000 * each.depth, each.other);
  };
  return fmt::format("{}", fmt::join(transformed(overlaps, words), ", "));
}

std::string describe_self_overlaps(const ClosedHand& closed) {
  if (closed.self_overlaps.empty()) return "";
  return "some links overlap at the start, so contact between them is ignored: " +
         describe_overlaps(closed.self_overlaps);
}

bool is_held_between_two(const std::vector<HandContact>& contacts) {
  if (contacts.size() != 2) return false;
  const Contact &a = contacts[0].contact, &b = contacts[1].contact;
  const Eigen::Vector3d line = (b.p - a.p).normalized();
  // The line between the points must lie in both friction cones.
  const auto within = [](const Contact& contact, const Eigen::Vector3d& along) {
    const double cosine = contact.n.dot(along);
    return cosine > 0 && contact.n.cross(along).norm() < contact.friction * cosine;
  };
  return a.torsion == 0 && b.torsion == 0 && within(a, line) && within(b, -line);
}

std::string describe_outcome(const Grasp& grasp) {
  const ApproachResult& way = grasp.approached;
  switch (grasp.outcome) {
    case GraspOutcome::kGrasped:
      if (!grasp.quality.force_closure && is_held_between_two(grasp.contacts))
        return "held between 2 hard points, free to turn about the line through them: no force "
               "closure; soft pads would hold it";
      return fmt::format("{}: {} contact{}, {}",
                         grasp.quality.force_closure ? "grasped" : "touched, not grasped",
                         grasp.contacts.size(), grasp.contacts.size() == 1 ? "" : "s",
                         grasp.quality.force_closure ? "force closure" : "no force closure");
    case GraspOutcome::kOverlaps:
      return "the hand begins in something: " +
             describe_overlaps(way.overlaps.empty() ? grasp.closed.overlaps : way.overlaps);
    case GraspOutcome::kMissed:
      return "missed: the approach met nothing";
    case GraspOutcome::kBlocked:
      return fmt::format("blocked: {} met {} before the object", way.surface, way.body);
    case GraspOutcome::kTooLong:
      return fmt::format("closing did not end within {} steps", grasp.closed.steps);
    case GraspOutcome::kEmpty:
      break;
  }
  return "empty: the hand closed, and the object is not touched";
}

bool slides(const Hand& hand, const Eigen::VectorXd& q, int coordinate) {
  for (const LinkSurface& surface : hand.surfaces()) {
    if (surface.link < 0) continue;
    const Eigen::Vector3d p = surface.solid->shape->bounds().center();
    const Eigen::Matrix<double, 6, 1> column = hand.jacobian(q, surface.link, p).col(coordinate);
    if (column.norm() > kNoRotation) return column.head<3>().norm() <= kNoRotation;
  }
  return false;
}

}  // namespace thenar
