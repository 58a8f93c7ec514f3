#include <algorithm>
#include <cmath>
#include <utility>

#include "grasp/robot/hand_digits.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

constexpr double kParallelCosine = 0.9;  // least cosine of axes about which links bend together [1]
constexpr double kShortShare = 0.3;      // share of a link across its axis that tells no bend [1]
constexpr double kNoLink = 1e-3;         // distance of hinges that tells no bend [m]
constexpr double kFoldedBend = 2;        // Larger bends are not of a digit that lies open [rad]
constexpr double kStraightBend = 0.15;   // Smaller bends stay as they are [rad]
constexpr double kSameRow = 0.8;  // least cosine between ways of fingers of a row, either way [1]
constexpr double kBesideWays = 0.5;  // largest cosine of the ways to the line between roots [1]

/// Bend of one link against another about an axis; 0: they do not tell. [rad]
double bend_about(const Vector3d& axis, const Vector3d& inner, const Vector3d& outer) {
  const Vector3d u = inner - inner.dot(axis) * axis, v = outer - outer.dot(axis) * axis;
  for (const auto& [part, whole] : {std::make_pair(u, inner), std::make_pair(v, outer)})
    if (part.norm() < std::max(kNoLink, kShortShare * whole.norm())) return 0;
  const double bend = std::atan2(axis.dot(u.cross(v)), u.dot(v));
  return std::abs(bend) < kFoldedBend ? bend : 0;
}

}  // namespace

/// Hinges of a digit that turn about axes parallel to its last one, the innermost first.
std::vector<int> HandDigits::hinges_of(const HandDigit& digit) const {
  const RobotHand& hand = grip_.hand();
  const Vector3d last = last_axis(digit);
  std::vector<int> hinges;
  for (int link = grip_.surfaces()[digit.last].link; link >= 0;
       link = hand.layout().parents[static_cast<std::size_t>(link)])
    if (std::abs(hand.axis(rest_, link).dot(last)) > kParallelCosine) hinges.push_back(link);
  std::reverse(hinges.begin(), hinges.end());
  return hinges;
}

/// Turns the hinges of curled digits back at rest, as far as they go, until each link goes on along
/// the one before. How far the first link is bent is not seen: it counts as the mean of the others.
void HandDigits::straighten() {
  const RobotHand& hand = grip_.hand();
  const std::vector<Pose<double>> links = hand.pose(rest_);
  const auto point = [&](int link) -> Vector3d {
    return links[static_cast<std::size_t>(link)] * hand.axis_point(link);
  };
  std::vector<std::pair<int, double>> turns;  // coordinates, by how much [rad]
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
      // Joints that one motor turns share a coordinate: the innermost one tells.
      const int coordinate = hand.coordinate_of(hinges[k]);
      if (std::none_of(hinges.begin(), hinges.begin() + static_cast<std::ptrdiff_t>(k),
                       [&](int inner) { return hand.coordinate_of(inner) == coordinate; }))
        turns.emplace_back(coordinate, -bend);
    }
    const double first = std::copysign(1.0, hand.axis(rest_, hinges[0]).dot(last));
    turns.emplace_back(hand.coordinate_of(hinges[0]), -first * mean);
  }
  for (const auto& [coordinate, angle] : turns) turn_by(coordinate, angle);
}

/// Turns a coordinate at rest within its limits, with all that its drive moves, if it comes first
/// among them and its drive curls digits.
void HandDigits::turn_by(int coordinate, double angle) {
  if (std::abs(angle) < kStraightBend) return;
  const HandLayout& layout = grip_.hand().layout();
  for (std::size_t d = 0; d < drives_.size(); ++d) {
    const DrivenCoordinate& first = drives_[d].moves.front();
    const bool curls = std::any_of(digits_.begin(), digits_.end(), [&](const HandDigit& digit) {
      return std::find(digit.curls.begin(), digit.curls.end(), static_cast<int>(d)) !=
             digit.curls.end();
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

/// Fingers side by side whose tips move along the same line close the same way.
void HandDigits::join_rows() {
  std::vector<Vector3d> ways;
  for (const HandDigit& digit : digits_) {
    Vector3d sum = Vector3d::Zero();
    for (const int d : digit.curls)
      sum += groups_.orientation[static_cast<std::size_t>(d)] *
             way(static_cast<std::size_t>(d), digit);
    ways.push_back(sum.normalized());
  }
  for (std::size_t a = 0; a < digits_.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) {
      if (digits_[a].curls.empty() || digits_[b].curls.empty()) continue;
      const double same = ways[a].dot(ways[b]);
      const Vector3d between = (digits_[a].root - digits_[b].root).normalized();
      const Vector3d long_a = digits_[a].tip - digits_[a].root,
                     long_b = digits_[b].tip - digits_[b].root;
      if (std::abs(same) < kSameRow || std::abs(between.dot(ways[a])) > kBesideWays ||
          std::abs(between.dot(ways[b])) > kBesideWays ||
          long_a.dot(long_b) < kSameRow * long_a.norm() * long_b.norm())
        continue;
      const int one = group_of(digits_[a]), other = group_of(digits_[b]);
      if (one == other) continue;
      for (std::size_t c = 0; c < digits_.size(); ++c)
        if (same < 0 && !digits_[c].curls.empty() && group_of(digits_[c]) == one) ways[c] *= -1;
      join_groups(one, other, same < 0);
    }
  // Numbers of groups without gaps.
  std::vector<int> numbers;
  for (int& group : groups_.group) {
    if (group < 0) continue;
    auto at = std::find(numbers.begin(), numbers.end(), group);
    if (at == numbers.end()) at = numbers.insert(numbers.end(), group);
    group = static_cast<int>(at - numbers.begin());
  }
}

int HandDigits::group_of(const HandDigit& digit) const {
  return groups_.group[static_cast<std::size_t>(digit.curls.front())];
}

/// Makes one group of two, the first of them turned round where asked.
void HandDigits::join_groups(int one, int other, bool reversed) {
  for (std::size_t d = 0; d < drives_.size(); ++d) {
    if (groups_.group[d] != one) continue;
    groups_.group[d] = other;
    if (reversed) groups_.orientation[d] *= -1;
  }
}

}  // namespace thenar
