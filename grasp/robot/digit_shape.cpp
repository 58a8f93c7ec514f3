#include <algorithm>
#include <cmath>
#include <utility>

#include "base/lists.h"
#include "grasp/robot/hand_digits.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

constexpr double kMinParallelCosine = 0.9;  // cosine of axes about which links bend together [1]
// Fraction of a link perpendicular to its axis, below which its bend is undefined [1]
constexpr double kMinPerpendicularFraction = 0.3;
constexpr double kMinLinkLength = 1e-3;  // distance of hinges below which a bend is undefined [m]
constexpr double kMaxOpenBend = 2;       // bend above which a digit is folded, not open [rad]
constexpr double kMinStraightening = 0.15;  // bend below which a joint is left unchanged [rad]
constexpr double kMinRowCosine = 0.8;  // |cosine| between the tip motions of fingers in a row [1]
constexpr double kMaxBesideCosine = 0.5;  // |cosine| of motions to the line between roots [1]

/// Returns the bend of one link relative to another about an axis; 0: it is undefined. [rad]
double bend_about(const Vector3d& axis, const Vector3d& inner, const Vector3d& outer) {
  const Vector3d u = inner - inner.dot(axis) * axis, v = outer - outer.dot(axis) * axis;
  for (const auto& [part, whole] : {std::make_pair(u, inner), std::make_pair(v, outer)})
    if (part.norm() < std::max(kMinLinkLength, kMinPerpendicularFraction * whole.norm())) return 0;
  const double bend = std::atan2(axis.dot(u.cross(v)), u.dot(v));
  return std::abs(bend) < kMaxOpenBend ? bend : 0;
}

}  // namespace

/// Returns the hinges of a digit about axes parallel to its last one, innermost first.
std::vector<int> HandDigits::hinges_of(const HandDigit& digit) const {
  const RobotHand& hand = grip_.hand();
  const Vector3d last = last_axis(digit);
  std::vector<int> hinges;
  for (const int link : links_of(digit))
    if (std::abs(hand.axis(rest_, link).dot(last)) > kMinParallelCosine) hinges.push_back(link);
  std::reverse(hinges.begin(), hinges.end());
  return hinges;
}

/// Straightens curled digits at rest, as far as their hinges go, until each link continues the
/// previous one. The bend of the first link is not visible: it counts as the mean of the others.
void HandDigits::straighten() {
  const RobotHand& hand = grip_.hand();
  const std::vector<Pose<double>> links = hand.pose(rest_);
  const auto point = [&](int link) -> Vector3d { return links[link] * hand.axis_point(link); };
  // Rotation of each coordinate that straightens its joint.
  std::vector<std::pair<int, double>> turns;  // coordinate, angle [rad]
  for (const HandDigit& digit : digits_) {
    const std::vector<int> hinges = hinges_of(digit);
    if (hinges.size() < 2) continue;
    const Vector3d last = last_axis(digit);
    double mean = 0;
    for (std::size_t k = 1; k < hinges.size(); ++k) {
      const Vector3d end = k + 1 < hinges.size() ? point(hinges[k + 1]) : digit.tip;
      const Vector3d here = point(hinges[k]), axis = hand.axis(rest_, hinges[k]);
      const double bend = bend_about(axis, here - point(hinges[k - 1]), end - here);
      mean += std::copysign(1.0, axis.dot(last)) * bend / static_cast<double>(hinges.size() - 1);
      // Joints of one motor share a coordinate: the innermost one decides.
      const int coordinate = hand.coordinate_of(hinges[k]);
      if (std::none_of(hinges.begin(), hinges.begin() + k,
                       [&](int inner) { return hand.coordinate_of(inner) == coordinate; }))
        turns.emplace_back(coordinate, -bend);
    }
    const double first = std::copysign(1.0, hand.axis(rest_, hinges[0]).dot(last));
    turns.emplace_back(hand.coordinate_of(hinges[0]), -first * mean);
  }
  for (const auto& [coordinate, angle] : turns) turn_in_range(coordinate, angle);
}

/// Rotates a coordinate at rest within its limits, with all others of its drive, if it is the first
/// coordinate of a drive that curls digits.
void HandDigits::turn_in_range(int coordinate, double angle) {
  if (std::abs(angle) < kMinStraightening) return;
  const HandLayout& layout = grip_.hand().layout();
  for (std::size_t d = 0; d < drives_.size(); ++d) {
    const DrivenCoordinate& first = drives_[d].moves.front();
    const bool curls = any_of(digits_, [&](const HandDigit& digit) {
      return contains(digit.curls, static_cast<int>(d));
    });
    if (first.coordinate != coordinate || !curls) continue;
    const double before = rest_[coordinate];
    const double after =
        std::clamp(before + angle, layout.lower[coordinate], layout.upper[coordinate]);
    for (const DrivenCoordinate& driven : drives_[d].moves) {
      double& q = rest_[driven.coordinate];
      q = std::clamp(q + (after - before) * driven.ratio / first.ratio,
                     layout.lower[driven.coordinate], layout.upper[driven.coordinate]);
    }
  }
}

/// Joins the groups of adjacent fingers whose tips move along the same line: they close together.
void HandDigits::join_rows() {
  // Direction in which the tip of each digit curls.
  std::vector<Vector3d> motions;
  for (const HandDigit& digit : digits_) {
    Vector3d sum = Vector3d::Zero();
    for (const int d : digit.curls)
      sum += groups_.orientation[d] * tip_translation(static_cast<std::size_t>(d), digit);
    motions.push_back(sum.normalized());
  }
  // Fingers are adjacent if they move along one line, across the line between their parallel roots.
  for (std::size_t a = 0; a < digits_.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) {
      if (digits_[a].curls.empty() || digits_[b].curls.empty()) continue;
      const double same = motions[a].dot(motions[b]);
      const Vector3d between = (digits_[a].root - digits_[b].root).normalized();
      const Vector3d long_a = digits_[a].tip - digits_[a].root,
                     long_b = digits_[b].tip - digits_[b].root;
      if (std::abs(same) < kMinRowCosine || std::abs(between.dot(motions[a])) > kMaxBesideCosine ||
          std::abs(between.dot(motions[b])) > kMaxBesideCosine ||
          long_a.dot(long_b) < kMinRowCosine * long_a.norm() * long_b.norm())
        continue;
      const int one = group_of(digits_[a]), other = group_of(digits_[b]);
      if (one == other) continue;
      // Opposite signs: the whole group is reversed.
      for (std::size_t c = 0; c < digits_.size(); ++c)
        if (same < 0 && !digits_[c].curls.empty() && group_of(digits_[c]) == one) motions[c] *= -1;
      join_groups(one, other, same < 0);
    }
  // Renumber the groups without gaps.
  std::vector<int> numbers;
  for (int& group : groups_.group) {
    if (group < 0) continue;
    auto at = std::find(numbers.begin(), numbers.end(), group);
    if (at == numbers.end()) at = numbers.insert(numbers.end(), group);
    group = static_cast<int>(at - numbers.begin());
  }
}

int HandDigits::group_of(const HandDigit& digit) const {
  return groups_.group[digit.curls.front()];
}

/// Merges two groups; `reversed` reverses the drives of the first one.
void HandDigits::join_groups(int one, int other, bool reversed) {
  for (std::size_t d = 0; d < drives_.size(); ++d) {
    if (groups_.group[d] != one) continue;
    groups_.group[d] = other;
    if (reversed) groups_.orientation[d] *= -1;
  }
}

}  // namespace thenar
