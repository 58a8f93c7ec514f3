#include "grasp/compare/pregrasp.h"

#include <algorithm>
#include <map>
#include <optional>
#include <random>

#include "base/lists.h"
#include "grasp/closing/approach_sampling.h"

namespace thenar {
namespace {

enum class Stream { kStart, kPosture };

/// Returns the random generator of one approach; std::seed_seq is the same on every platform.
std::mt19937 generator(unsigned seed, const std::string& object, int number, Stream stream) {
  std::vector<unsigned> words{seed, static_cast<unsigned>(number), static_cast<unsigned>(stream)};
  for (const char letter : object) words.push_back(static_cast<unsigned char>(letter));
  std::seed_seq sequence(words.begin(), words.end());
  return std::mt19937(sequence);
}

}  // namespace

std::set<std::string> touching_digits(const Hand& hand, const std::vector<HandContact>& contacts) {
  std::set<std::string> digits;
  for (const HandContact& contact : contacts) digits.insert(hand.surfaces()[contact.surface].digit);
  digits.erase("");
  return digits;
}

std::set<std::string> touching_tips(const Hand& hand, const std::vector<HandContact>& contacts) {
  const auto depth = [&](const LinkSurface& surface) {
    return joints_to(hand.layout(), surface.link);
  };
  std::map<std::string, int> outermost;
  for (const LinkSurface& surface : hand.surfaces())
    outermost[surface.digit] = std::max(outermost[surface.digit], depth(surface));
  std::set<std::string> tips;
  for (const HandContact& contact : contacts) {
    const LinkSurface& surface = hand.surfaces()[contact.surface];
    if (!surface.digit.empty() && depth(surface) == outermost[surface.digit])
      tips.insert(surface.digit);
  }
  return tips;
}

Pregrasp sample_pregrasp(const CollisionHand& hand, const GraspBody& object, unsigned seed,
                         int number) {
  // Two streams, so that a posture with more random numbers changes no pose.
  std::mt19937 posture = generator(seed, object.name, number, Stream::kPosture);
  std::mt19937 start = generator(seed, object.name, number, Stream::kStart);
  Pregrasp pregrasp;
  pregrasp.q = sample_preshape(hand, number, posture);
  pregrasp.approach_distance = approach_distance(hand, pregrasp.q, object);
  pregrasp.X_WH = sample_approach_pose(hand, pregrasp.q, object, start);
  pregrasp.stand_off = sample_stand_off(start);
  return pregrasp;
}

Grasp attempt_grasp(const CollisionHand& hand, const Pregrasp& pregrasp, const GraspSetup& setup,
                    GraspOptions options) {
  options.approach_distance = pregrasp.approach_distance;
  options.stand_off = pregrasp.stand_off;
  return centred_grasp(hand, pregrasp.X_WH, pregrasp.q, setup, options);
}

namespace {

constexpr double kMinPushSine = 0.2;     // sine of the angle between push and approach [1]
constexpr int kMaxSlideSteps = 200;      // maximum steps of conservative advancement
constexpr double kMaxSlideRatio = 4;     // slide of the object to another jaw over its radius [1]
constexpr double kMaxPushRatio = 12;     // push to a fixed part over the object's radius [1]
constexpr double kPushStepRatio = 0.02;  // step of this push over the object's radius [1]

/// Returns surfaces of other digits that the coordinate also moves.
std::vector<int> coupled_surfaces(const CollisionHand& hand, int coordinate,
                                  const std::string& digit) {
  std::vector<int> others;
  const std::vector<LinkSurface>& surfaces = hand.hand->surfaces();
  for (int s = 0; s < static_cast<int>(surfaces.size()); ++s)
    if (!surfaces[s].digit.empty() && surfaces[s].digit != digit && hand.moved_by(s, coordinate))
      others.push_back(s);
  return others;
}

/// Returns the fixed surfaces of a hand with a single digit, one of which may be a fixed jaw.
std::vector<int> fixed_surfaces(const CollisionHand& hand, const ClosingDrives& drives) {
  std::vector<int> still;
  if (hand.hand->layout().tips.size() != 1) return still;
  const Eigen::VectorXd rates = drives.rates();
  for (int s = 0; s < static_cast<int>(hand.hand->surfaces().size()); ++s) {
    bool moves = false;
    for (int j = 0; j < static_cast<int>(rates.size()); ++j)
      moves = moves || (rates[j] != 0 && hand.moved_by(s, j));
    if (!moves) still.push_back(s);
  }
  return still;
}

/// Push of one digit on the object, with the surfaces on its other side.
struct Push {
  Eigen::Vector3d along_W{0, 0, 0};  // unit; zero: no digit pushes alone (3)
  std::vector<int> others;           // surfaces that may stop the object
  bool fixed = false;                // whether these surfaces do not move
};

Push find_push(const CollisionHand& hand, const Grasp& grasp) {
  const std::set<std::string> digits = touching_digits(*hand.hand, grasp.contacts);
  // Only a single digit pushes the object aside.
  if (digits.size() != 1) return {};
  const ClosingDrives drives(hand.hand->layout());
  const Eigen::VectorXd rates = drives.rates();
  const std::vector<int> still = fixed_surfaces(hand, drives);
  for (const HandContact& contact : grasp.contacts) {
    const LinkSurface& surface = hand.hand->surfaces()[contact.surface];
    if (surface.digit.empty() || surface.link < 0) continue;
    // Find a moving coordinate of this digit that other digits share.
    for (int j = 0; j < static_cast<int>(rates.size()); ++j) {
      if (rates[j] == 0 || !hand.moved_by(contact.surface, j)) continue;
      Push push{{0, 0, 0}, coupled_surfaces(hand, j, surface.digit)};
      if (push.others.empty()) {
        push.others = still;
        push.fixed = true;
      }
      if (push.others.empty()) continue;
      // The object slides as the digit moves, across the approach.
      const Eigen::Vector3d middle = hand.trees[contact.surface].nodes[0].ball.c;
      const Eigen::Matrix3Xd J =
          hand.hand->jacobian(grasp.closed.q, surface.link, middle).bottomRows<3>();
      const Eigen::Vector3d v =
          push.fixed ? Eigen::Vector3d(J * rates) : Eigen::Vector3d(rates[j] * J.col(j));
      const Eigen::Vector3d& d = hand.hand->layout().approach.direction;
      const Eigen::Vector3d across = v - v.dot(d) * d;
      if (across.norm() > kMinPushSine * v.norm())
        push.along_W = grasp.approached.X_WH.R * across.normalized();
      return push;
    }
  }
  return {};
}

/// Returns the distance by which the object slides until another digit touches it; the maximum if
/// none does [m].
double slide_distance(const CollisionHand& hand, const Grasp& grasp, const Push& push,
                      const GraspSetup& setup, double accuracy) {
  PosedCollisionHand posed{hand, grasp.approached.X_WH, hand.hand->pose(grasp.closed.q)};
  const double max_distance = kMaxSlideRatio * setup.object.torque_scale;
  double distance = 0;
  for (int step = 0; step < kMaxSlideSteps && distance < max_distance; ++step) {
    // Sliding by half of the smallest clearance is always safe.
    double clearance = max_distance;
    for (const int surface : push.others) {
      Clearance between{surface, -1, &setup.object};
      clearance = std::min(clearance,
                           measure_clearance(between, posed, accuracy / 4, max_distance).distance);
    }
    if (clearance <= 2 * accuracy) return distance;
    distance += clearance / 2;  // clearances are measured within 1/5
    posed.X_WH.p -= clearance / 2 * push.along_W;
  }
  return max_distance;
}

/// Returns the distance by which the hand can move against the push, in place of the object, until
/// it would overlap the object or a body; nothing if it meets none [m].
std::optional<double> push_distance(const CollisionHand& hand, const Grasp& grasp, const Push& push,
                                    const GraspSetup& setup, double accuracy) {
  PosedCollisionHand posed{hand, {}, hand.hand->pose(grasp.closed.q)};
  const auto overlaps = [&](double distance) {
    posed.X_WH = grasp.approached.X_WH;
    posed.X_WH.p -= distance * push.along_W;
    return !find_overlaps(posed, setup, accuracy).empty();
  };
  // Step until there is an overlap, then bisect the last step.
  const double step = kPushStepRatio * setup.object.torque_scale;
  const double end = kMaxPushRatio * setup.object.torque_scale;
  double high = step;
  while (high < end && !overlaps(high)) high += step;
  if (high >= end) return std::nullopt;
  double low = high - step;
  while (high - low > accuracy / 4) (overlaps((low + high) / 2) ? high : low) = (low + high) / 2;
  return low;
}

/// Returns whether a fixed surface pushes against the push.
bool holds_against(const Push& push, const Grasp& grasp, const GraspBody& object) {
  return any_of(grasp.contacts, [&](const HandContact& each) {
    return contains(push.others, each.surface) &&
           (object.X_WB.R * each.contact.n).dot(push.along_W) < -kMinPushSine;
  });
}

}  // namespace

Grasp centred_grasp(const CollisionHand& hand, const Pose<double>& X_WH, const Eigen::VectorXd& q,
                    const GraspSetup& setup, const GraspOptions& options) {
  // A grasp with several digits, or without a push, is returned unchanged.
  Grasp first = grasp(hand, X_WH, q, setup, options);
  if (first.outcome != GraspOutcome::kGrasped) return first;
  const Push push = find_push(hand, first);
  if (push.others.empty() || push.along_W.isZero(0)) return first;

  // Close again from where the hand stopped, shifted against the push.
  const auto shifted = [&](double distance) {
    GraspOptions there = options;
    there.approach_distance = 0;
    Pose<double> X_shifted = first.approached.X_WH;
    X_shifted.p -= distance * push.along_W;
    Grasp second = grasp(hand, X_shifted, first.closed.q, setup, there);
    second.approached = first.approached;
    second.approached.X_WH = X_shifted;
    return second;
  };
  if (push.fixed) {
    // The object rests on a fixed surface, and the digit follows.
    if (holds_against(push, first, setup.object)) return first;
    const std::optional<double> distance =
        push_distance(hand, first, push, setup, options.close.accuracy);
    if (!distance) return first;
    Grasp second = shifted(*distance);
    const bool follows = !touching_digits(*hand.hand, second.contacts).empty();
    return follows && holds_against(push, second, setup.object) ? second : first;
  }
  const double distance = slide_distance(hand, first, push, setup, options.close.accuracy);
  if (distance >= kMaxSlideRatio * setup.object.torque_scale) return first;
  const std::set<std::string> pushing = touching_digits(*hand.hand, first.contacts);
  // Jaws that move equally fast meet at half the distance; others are found by bisection.
  double low = 0, high = distance;
  while (high - low > options.close.accuracy / 2) {
    Grasp second = shifted((low + high) / 2);
    const std::set<std::string> digits = touching_digits(*hand.hand, second.contacts);
    if (digits.size() >= 2) return second;
    // The same digit alone: shift more; another digit alone: shift less.
    (digits == pushing ? low : high) = (low + high) / 2;
  }
  return first;
}

}  // namespace thenar
