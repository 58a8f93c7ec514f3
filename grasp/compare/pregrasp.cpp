#include "grasp/compare/pregrasp.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "grasp/closing/approach_sampling.h"

namespace thenar {
namespace {

enum class Stream { kStart, kPosture };

/// Random generator of one approach; std::seed_seq gives the same on every machine.
std::mt19937 generator(unsigned seed, const std::string& object, int number, Stream stream) {
  std::vector<unsigned> words{seed, static_cast<unsigned>(number), static_cast<unsigned>(stream)};
  for (const char letter : object) words.push_back(static_cast<unsigned char>(letter));
  std::seed_seq sequence(words.begin(), words.end());
  return std::mt19937(sequence);
}

}  // namespace

std::set<std::string> digits_of(const Hand& hand, const std::vector<HandContact>& contacts) {
  std::set<std::string> digits;
  for (const HandContact& contact : contacts)
    if (!hand.surfaces()[contact.surface].digit.empty())
      digits.insert(hand.surfaces()[contact.surface].digit);
  return digits;
}

Pregrasp sample_pregrasp(const CollisionHand& hand, const SceneBody& object, unsigned seed,
                         int number) {
  // Two streams, so that a posture with more draws changes no pose.
  std::mt19937 posture = generator(seed, object.name, number, Stream::kPosture);
  std::mt19937 start = generator(seed, object.name, number, Stream::kStart);
  Pregrasp pregrasp;
  pregrasp.q = sample_preshape(hand, number, posture);
  pregrasp.approach_distance = approach_distance(hand, pregrasp.q, object);
  pregrasp.X_WH = sample_approach_pose(hand, pregrasp.q, object, start);
  pregrasp.stand_off = sample_stand_off(start);
  return pregrasp;
}

Grasp attempt_grasp(const CollisionHand& hand, const Pregrasp& pregrasp, const Scene& scene,
                    GraspOptions options) {
  options.approach_distance = pregrasp.approach_distance;
  options.stand_off = pregrasp.stand_off;
  return centred_grasp(hand, pregrasp.X_WH, pregrasp.q, scene, options);
}

namespace {

constexpr double kAcross = 0.2;    // smallest sine of the angle between push and approach [1]
constexpr int kMaxGapSteps = 200;  // of conservative advancement across the clearance

/// Surfaces of other digits that the coordinate moves, too.
std::vector<int> mirrored(const CollisionHand& hand, int coordinate, const std::string& digit) {
  std::vector<int> others;
  const std::vector<LinkSurface>& surfaces = hand.hand->surfaces();
  for (int s = 0; s < static_cast<int>(surfaces.size()); ++s)
    if (!surfaces[s].digit.empty() && surfaces[s].digit != digit && hand.moved_by(s, coordinate))
      others.push_back(s);
  return others;
}

/// Push of one digit on the object, and the surfaces that wait on its other side.
struct Push {
  Eigen::Vector3d along_W{0, 0, 0};  // unit; zero: no digit pushes alone (3)
  std::vector<int> others;           // surfaces
};

Push find_push(const CollisionHand& hand, const Grasp& grasp) {
  const std::set<std::string> digits = digits_of(*hand.hand, grasp.contacts);
  // Only a single digit pushes the object aside.
  if (digits.size() != 1) return {};
  const Eigen::VectorXd rates = ClosingDrives(hand.hand->layout()).rates();
  for (const HandContact& contact : grasp.contacts) {
    const LinkSurface& surface = hand.hand->surfaces()[contact.surface];
    if (surface.digit.empty() || surface.link < 0) continue;
    // A moving coordinate of this digit that other digits share.
    for (int j = 0; j < static_cast<int>(rates.size()); ++j) {
      if (rates[j] == 0 || !hand.moved_by(contact.surface, j)) continue;
      Push push{{0, 0, 0}, mirrored(hand, j, surface.digit)};
      if (push.others.empty()) continue;
      // The object slides as the digit moves, across the approach.
      const Eigen::Vector3d middle = hand.trees[contact.surface].nodes[0].ball.c;
      const Eigen::Vector3d v =
          rates[j] *
          hand.hand->jacobian(grasp.closed.q, surface.link, middle).bottomRows<3>().col(j);
      const Eigen::Vector3d& d = hand.hand->layout().approach.direction;
      const Eigen::Vector3d across = v - v.dot(d) * d;
      if (across.norm() > kAcross * v.norm())
        push.along_W = grasp.approached.X_WH.R * across.normalized();
      return push;
    }
  }
  return {};
}

/// Distance that the object slides until another digit touches it; infinite: never [m].
double way_across(const CollisionHand& hand, const Grasp& grasp, const Push& push,
                  const Scene& scene, double accuracy) {
  PosedCollisionHand posed{hand, grasp.approached.X_WH, hand.hand->pose(grasp.closed.q)};
  const double most = 4 * scene.object.torque_scale;
  double way = 0;
  for (int step = 0; step < kMaxGapSteps && way < most; ++step) {
    // Half of the smallest clearance is always safe to slide.
    double clearance = most;
    for (const int surface : push.others) {
      Clearance between{surface, -1, &scene.object};
      clearance =
          std::min(clearance, measure_clearance(between, posed, accuracy / 4, most).distance);
    }
    if (clearance <= 2 * accuracy) return way;
    way += clearance / 2;  // clearances are measured to a fifth
    posed.X_WH.p -= clearance / 2 * push.along_W;
  }
  return most;
}

}  // namespace

Grasp centred_grasp(const CollisionHand& hand, const Pose<double>& X_WH, const Eigen::VectorXd& q,
                    const Scene& scene, const GraspOptions& options) {
  // A grasp with several digits, or without a push, stays as it is.
  Grasp first = grasp(hand, X_WH, q, scene, options);
  if (first.outcome != GraspOutcome::kGrasped) return first;
  const Push push = find_push(hand, first);
  if (push.others.empty() || push.along_W.isZero(0)) return first;
  const double way = way_across(hand, first, push, scene, options.close.accuracy);
  if (way >= 4 * scene.object.torque_scale) return first;

  // Close again from where the hand stopped, shifted against the push.
  GraspOptions there = options;
  there.approach_distance = 0;
  const std::set<std::string> pushing = digits_of(*hand.hand, first.contacts);
  // Jaws that move equally fast meet at half the distance; others are found by bisection.
  double least = 0, most = way;
  while (most - least > options.close.accuracy / 2) {
    Pose<double> X_shifted = first.approached.X_WH;
    X_shifted.p -= (least + most) / 2 * push.along_W;
    Grasp second = grasp(hand, X_shifted, first.closed.q, scene, there);
    const std::set<std::string> digits = digits_of(*hand.hand, second.contacts);
    // The same digit alone: shift more; another digit alone: shift less.
    if (digits.size() < 2) {
      (digits == pushing ? least : most) = (least + most) / 2;
      continue;
    }
    second.approached = first.approached;
    second.approached.X_WH = X_shifted;
    return second;
  }
  return first;
}

}  // namespace thenar
