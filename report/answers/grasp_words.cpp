#include "report/answers/grasp_words.h"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/units.h"

namespace thenar {
namespace {

constexpr double kShare = 1.0 / 3;         // of the largest part that is still named [1]
constexpr double kAtLimit = 1e-9;          // as in closing [rad] or [m]
constexpr double kNoTurn = 1e-12;          // [1]
constexpr double kEpsilonRounding = 1e-9;  // of an epsilon of unit forces [1]
constexpr double kSearch = 1.0 / 4;  // of what still touches: how exactly clearances are measured

const std::string& name_of(const Hand& hand, int surface) {
  return hand.surfaces()[static_cast<std::size_t>(surface)].name;
}

/// Gaps with the scene, and between all surfaces that may meet.
std::vector<Clearance> all_gaps(const PosedCollisionHand& posed, const Scene& scene) {
  std::vector<Clearance> clearances = scene_clearances(posed, scene);
  for (const SurfacePair& pair : posed.touching.self) {
    Clearance clearance{pair.a, pair.b};
    clearance.bound = ball_bound(clearance, posed);
    clearances.push_back(clearance);
  }
  return clearances;
}

bool moves(const CollisionHand& hand, int surface, int coordinate) {
  return surface >= 0 && hand.moved_by(surface, coordinate);
}

/// What touches beyond a coordinate: of parts of the hand on both sides of it.
std::string contact_words(const CollisionHand& hand, int coordinate,
                          const std::vector<Touching>& touching) {
  std::vector<std::string> found;
  for (const Touching& each : touching) {
    if (moves(hand, each.surface, coordinate) == moves(hand, each.other_surface, coordinate))
      continue;
    found.push_back(fmt::format("{} on {}", name_of(*hand.hand, each.surface), each.other));
  }
  return found.empty() ? "contact" : fmt::format("contact: {}", fmt::join(found, ", "));
}

/// The large parts, those of the first three named `along`, the others `about`.
std::string large_parts(const ScaledWrench& vector, const char* along, const char* about) {
  const double largest = vector.cwiseAbs().maxCoeff();
  if (!(largest > 0)) return "none";
  std::vector<std::string> parts;
  for (int k = 0; k < 6; ++k)
    if (std::abs(vector[k]) >= kShare * largest)
      parts.push_back(
          fmt::format("{} {}{}", k < 3 ? along : about, vector[k] > 0 ? "+" : "-", "xyz"[k % 3]));
  return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace

std::vector<Touching> find_touching(const PosedCollisionHand& posed, const Scene& scene,
                                    double within) {
  std::vector<Touching> touching;
  for (Clearance& clearance : all_gaps(posed, scene)) {
    if (clearance.bound > within) continue;
    const double distance =
        measure_clearance(clearance, posed, kSearch * within, 2 * within).distance;
    const bool self = clearance.body == nullptr;
    if (distance > within || (self && distance < -within)) continue;  // neighbours overlap
    touching.push_back(
        {clearance.surface,
         self ? name_of(*posed.touching.hand, clearance.other) : clearance.body->name, distance,
         self ? clearance.other : -1});
  }
  return touching;
}

std::vector<std::string> stop_words(const CollisionHand& hand, const ClosedHand& closed,
                                    const std::vector<Touching>& touching) {
  const HandLayout& layout = hand.hand->layout();
  std::vector<std::string> words;
  for (int c = 0; c < static_cast<int>(closed.stopped.size()); ++c) {
    const double above = closed.q[c] - layout.lower[c], below = layout.upper[c] - closed.q[c];
    switch (closed.stopped[static_cast<std::size_t>(c)]) {
      case StoppedBy::kNothing:
        words.emplace_back("free");
        break;
      case StoppedBy::kLimit:
        words.emplace_back(below <= above ? "at its upper limit" : "at its lower limit");
        break;
      case StoppedBy::kContact:
        words.push_back(contact_words(hand, c, touching));
        break;
      case StoppedBy::kCoupling:
        words.emplace_back("coupled with one that is stopped");
        break;
      case StoppedBy::kNoDrive:
        words.emplace_back("nothing drives it");
        break;
    }
  }
  return words;
}

bool slides(const Hand& hand, const Eigen::VectorXd& q, int coordinate) {
  for (const LinkSurface& surface : hand.surfaces()) {
    if (surface.link < 0) continue;
    const Eigen::Vector3d p = surface.solid->shape->bounds().center();
    const Eigen::Matrix<double, 6, 1> column = hand.jacobian(q, surface.link, p).col(coordinate);
    if (column.norm() > kNoTurn) return column.head<3>().norm() <= kNoTurn;
  }
  return false;
}

std::string value_words(double value, bool slides) {
  const double rounded = std::round(value / (slides ? 1e-5 : 0.1 * kDegree));
  return slides ? fmt::format("{:.2f} mm", rounded / 100 + 0.0)  // no -0
                : fmt::format("{:.1f} deg", rounded / 10 + 0.0);
}

std::string direction_words(const ScaledWrench& wrench) {
  return large_parts(wrench, "force along", "torque about");
}

std::string motion_words(const ScaledWrench& motion) {
  return large_parts(motion, "along", "turning about");
}

double without_rounding(double epsilon) {
  return std::abs(epsilon) < kEpsilonRounding ? 0 : epsilon;
}

std::string overlap_words(const std::vector<Overlap>& overlaps) {
  std::vector<std::string> parts;
  for (const Overlap& each : overlaps)
    parts.push_back(
        fmt::format("{} is {:.2f} mm in {}", each.surface, 1000 * each.depth, each.other));
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string own_overlap_words(const ClosedHand& closed) {
  if (closed.self_overlaps.empty()) return "";
  return "links of the hand begin in each other, and do not stop each other: " +
         overlap_words(closed.self_overlaps);
}

std::string outcome_words(const Grasp& grasp) {
  const ApproachResult& way = grasp.approached;
  switch (grasp.outcome) {
    case GraspOutcome::kGrasped:
      return fmt::format("{}: {} contact{}, {}",
                         grasp.quality.force_closure ? "grasped" : "touched, not grasped",
                         grasp.contacts.size(), grasp.contacts.size() == 1 ? "" : "s",
                         grasp.quality.force_closure ? "force closure" : "no force closure");
    case GraspOutcome::kOverlaps:
      return "the hand begins in something: " +
             overlap_words(way.overlaps.empty() ? grasp.closed.overlaps : way.overlaps);
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

}  // namespace thenar
