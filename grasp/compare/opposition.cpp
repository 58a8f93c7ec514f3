#include "grasp/compare/opposition.h"

#include <algorithm>

#include <fmt/format.h>
#include <Eigen/Cholesky>

#include "base/lists.h"
#include "base/numbers.h"

#include "grasp/closing/approach_sampling.h"
#include "grasp/closing/fingertip_paths.h"
#include "grasp/compare/grasp_type.h"

namespace thenar {
namespace {

constexpr double kSkinContactDistance = 10e-3;  // distance within which points of skin meet [m]
// Distance within which centres of tips meet, about a finger's thickness [m]
constexpr double kTipContactDistance = 20e-3;
constexpr int kSearchStarts = 12, kSearchSteps = 60;  // number of starts, and of steps from each
constexpr double kMaxJointStep = 0.3;                 // maximum motion of a joint in a step [rad]
constexpr double kAngleDamping = 1e-6;                // damping of joint steps [m^2/rad^2]

HandPlace place_of(const HandTip& tip) { return {tip.digit, tip.link, tip.p, 0}; }

Eigen::Matrix3Xd jacobian(const Hand& hand, const Eigen::VectorXd& q, const HandPlace& place) {
  if (place.link < 0) return Eigen::Matrix3Xd::Zero(3, q.size());
  return hand.jacobian(q, place.link, place.p).bottomRows<3>();
}

/// Minimises the distance of two landmarks from a start q, until it is below `near` [m].
double bring_together(const Hand& hand, Eigen::VectorXd q, const HandPlace& a, const HandPlace& b,
                      double near) {
  const HandLayout& layout = hand.layout();
  double best = kInfinity;
  for (int step = 0; step < kSearchSteps; ++step) {
    const std::vector<Pose<double>> links = hand.pose(q);
    const Eigen::Vector3d gap = moved_with(links, b.link, b.p) - moved_with(links, a.link, a.p);
    best = std::min(best, gap.norm());
    if (best < near) break;
    // Relative Jacobian of the two landmarks.
    Eigen::Matrix3Xd J = jacobian(hand, q, a) - jacobian(hand, q, b);
    // Joints at a limit that would move beyond it are fixed.
    for (Eigen::Index j = 0; j < q.size(); ++j) {
      const double push = J.col(j).dot(gap);
      if ((q[j] <= layout.lower[j] && push < 0) || (q[j] >= layout.upper[j] && push > 0))
        J.col(j).setZero();
    }
    // Damped least-squares step with limited joint motion.
    const Eigen::Matrix3d normal = J * J.transpose() + kAngleDamping * Eigen::Matrix3d::Identity();
    Eigen::VectorXd dq = J.transpose() * normal.ldlt().solve(gap);
    const double largest = dq.cwiseAbs().maxCoeff();
    if (largest > kMaxJointStep) dq *= kMaxJointStep / largest;
    q = (q + dq).cwiseMax(layout.lower).cwiseMin(layout.upper);
  }
  return best;
}

bool meet(const Hand& hand, const HandPlace& a, const HandPlace& b,
          const std::vector<Eigen::VectorXd>& starts, double near) {
  return any_of(
      starts, [&](const Eigen::VectorXd& q) { return bring_together(hand, q, a, b, near) < near; });
}

std::vector<Eigen::VectorXd> draw_starts(const HandLayout& layout, std::mt19937& random) {
  std::vector<Eigen::VectorXd> starts{(layout.lower + layout.upper) / 2};
  while (static_cast<int>(starts.size()) < kSearchStarts)
    starts.push_back(sample_posture(layout, random));
  return starts;
}

Opposition kapandji(const ComparedHand& hand, const std::vector<Eigen::VectorXd>& starts,
                    const Progress& progress) {
  Opposition out;
  out.scale = "Kapandji, highest of ten places";
  for (const HandPlace& place : hand.places) {
    if (progress.stop()) break;
    // The score is that of the highest landmark that the thumb meets.
    if (!meet(*hand.hand, hand.thumb, place, starts, kSkinContactDistance)) continue;
    out.reached.push_back(place.name);
    out.score = std::max(out.score, static_cast<double>(place.score));
  }
  return out;
}

/// Returns the names of other digits whose tips the tip of a digit meets.
std::vector<std::string> met_by(const Hand& hand, const HandTip& thumb,
                                const std::vector<Eigen::VectorXd>& starts) {
  std::vector<std::string> met;
  for (const HandTip& tip : hand.layout().tip_points)
    if (tip.digit != thumb.digit &&
        meet(hand, place_of(thumb), place_of(tip), starts, kTipContactDistance))
      met.push_back(tip.digit);
  return met;
}

Opposition analogous(const Hand& hand, const std::vector<Eigen::VectorXd>& starts,
                     const Progress& progress) {
  const std::vector<HandTip>& tips = hand.layout().tip_points;
  const std::string thumb = opposing_digit(hand);
  Opposition out;
  out.scale = "not defined: fewer than two digits";
  out.score = kNaN;
  // Opposition needs two digits.
  if (tips.size() < 2) return out;
  out.score = 0;
  out.scale = fmt::format("share of other tips met by '{}', times 10",
                          thumb.empty() ? tips.front().digit : thumb);
  for (const HandTip& tip : tips) {
    if (progress.stop()) break;
    // Only the thumb counts, or in a hand without one the best digit.
    if (!thumb.empty() && tip.digit != thumb) continue;
    std::vector<std::string> met = met_by(hand, tip, starts);
    if (met.size() <= out.reached.size()) continue;
    out.score = 10.0 * static_cast<double>(met.size()) / static_cast<double>(tips.size() - 1);
    out.scale = fmt::format("share of other tips met by '{}', times 10", tip.digit);
    out.reached = std::move(met);
  }
  return out;
}

}  // namespace

Opposition measure_opposition(const ComparedHand& hand, std::mt19937& random,
                              const Progress& progress) {
  const std::vector<Eigen::VectorXd> starts = draw_starts(hand.hand->layout(), random);
  return hand.places.empty() ? analogous(*hand.hand, starts, progress)
                             : kapandji(hand, starts, progress);
}

}  // namespace thenar
