#include "report/answers/grasp_words.h"

#include <array>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/units.h"

namespace thenar {
namespace {

constexpr double kEpsilonRounding = 1e-9;  // Rounding of an epsilon of unit forces [1]
// Error of a measured clearance, over that up to which parts touch [1]
constexpr double kClearanceErrorShare = 1.0 / 4;

const std::string& name_of(const Hand& hand, int surface) {
  return hand.surfaces()[static_cast<std::size_t>(surface)].name;
}

/// Why coordinates stop that no limit and no contact stops.
constexpr std::array kStopWords{EnumName{StoppedBy::kNothing, "free"},
                                EnumName{StoppedBy::kCoupling, "coupled with one that is stopped"},
                                EnumName{StoppedBy::kNoDrive, "no closing drive moves it"}};

/// Gaps with the setup, and between all surfaces that may meet.
std::vector<Clearance> all_gaps(const PosedCollisionHand& posed, const GraspSetup& setup) {
  std::vector<Clearance> clearances = find_clearances(posed, setup);
  for (const SurfacePair& pair : posed.collision_hand.self_pairs) {
    Clearance clearance{pair.a, pair.b};
    clearance.bound = bounding_ball_clearance(clearance, posed);
    clearances.push_back(clearance);
  }
  return clearances;
}

bool moves(const CollisionHand& hand, int surface, int coordinate) {
  return surface >= 0 && hand.moved_by(surface, coordinate);
}

/// Returns the contacts that a coordinate changes: those of which it moves one side only.
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

}  // namespace

std::vector<Touching> find_touching(const PosedCollisionHand& posed, const GraspSetup& setup,
                                    double within) {
  std::vector<Touching> touching;
  for (Clearance& clearance : all_gaps(posed, setup)) {
    if (clearance.bound > within) continue;
    const double distance =
        measure_clearance(clearance, posed, kClearanceErrorShare * within, 2 * within).distance;
    const bool self = clearance.body == nullptr;
    if (distance > within || (self && distance < -within)) continue;  // neighbours overlap
    touching.push_back(
        {clearance.surface,
         self ? name_of(*posed.collision_hand.hand, clearance.other) : clearance.body->name,
         distance, self ? clearance.other : -1});
  }
  return touching;
}

std::vector<std::string> stop_words(const CollisionHand& hand, const ClosedHand& closed,
                                    const std::vector<Touching>& touching) {
  const HandLayout& layout = hand.hand->layout();
  std::vector<std::string> words;
  // A coordinate that stopped at a limit says at which one.
  for (int c = 0; c < static_cast<int>(closed.stopped.size()); ++c) {
    const double above = closed.q[c] - layout.lower[c], below = layout.upper[c] - closed.q[c];
    const StoppedBy by = closed.stopped[static_cast<std::size_t>(c)];
    if (by == StoppedBy::kLimit)
      words.emplace_back(below <= above ? "at its upper limit" : "at its lower limit");
    else if (by == StoppedBy::kContact)
      words.push_back(contact_words(hand, c, touching));
    else
      words.push_back(name_in(kStopWords, by));
  }
  return words;
}

std::string value_words(double value, bool slides) {
  const double rounded = std::round(value / (slides ? 1e-5 : 0.1 * kDegree));
  return slides ? fmt::format("{:.2f} mm", rounded / 100 + 0.0)  // no -0
                : fmt::format("{:.1f} deg", rounded / 10 + 0.0);
}

double epsilon_or_zero(double epsilon) {
  return std::abs(epsilon) < kEpsilonRounding ? 0 : epsilon;
}

}  // namespace thenar
