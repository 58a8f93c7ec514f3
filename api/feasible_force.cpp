#include "api/feasible_force.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "base/error.h"
#include "base/nearest_name.h"
#include "base/units.h"

namespace thenar {
namespace {

ForceAxes force_axes(const DigitAtPosture& at, DirectionFrame frame) {
  if (!at.map.empty()) {
    require(frame == DirectionFrame::kWorld,
            "tip map '{}' knows only its own x, y, z; leave out --axes tip", at.map);
    return {"map", {"x", "y", "z"}, Eigen::Matrix3d::Identity()};
  }
  if (frame == DirectionFrame::kWorld) return {};
  return {"tip", {"proximal", "dorsal", "radial"}, *at.tip_axes};
}

void require_limits(const TipStatics& statics, const std::string& subject) {
  const std::vector<std::string> unknown = unlimited_muscles(statics);
  require(
      unknown.empty(),
      "feasible forces need the largest force of every muscle; unknown: {}. Give each [[muscle]] "
      "max_force_N, or pcsa_cm2 and specific_tension_N_cm2, in {}",
      listed(unknown), subject);
}

/// Derivative of the largest force by each joint; empty unless there is such a force of bones.
Eigen::VectorXd change_of(const DigitAtPosture& at, const MaxTipForce& largest,
                          DirectionFrame frame) {
  if (largest.status != Status::kSolved || largest.component < kNoTipForce || !at.map.empty())
    return {};
  return max_tip_force_gradient(at.statics, at.slopes, largest, frame);
}

WholeForceSet whole_set(const TipStatics& statics, const ForceAxes& axes) {
  WholeForceSet whole{feasible_force_set(statics), {}};
  for (int k = 0; k < 6; ++k)
    whole.along.push_back(max_tip_force(statics, (k % 2 == 0 ? 1 : -1) * axes.to_world.col(k / 2)));
  return whole;
}

/// Groups of muscles, by index, whose rows of R are the same and not zero.
std::vector<std::vector<int>> muscles_alike(const Eigen::MatrixXd& R) {
  constexpr double kRounding = 1e-12;  // of the largest arm [1]
  const double same = kRounding * R.cwiseAbs().maxCoeff();
  std::vector<std::vector<int>> groups;
  std::vector<bool> grouped(static_cast<std::size_t>(R.rows()), false);
  for (int i = 0; i < R.rows(); ++i) {
    if (grouped[static_cast<std::size_t>(i)] || R.row(i).cwiseAbs().maxCoeff() <= same) continue;
    std::vector<int> group{i};
    for (int k = i + 1; k < R.rows(); ++k)
      if ((R.row(k) - R.row(i)).cwiseAbs().maxCoeff() <= same) {
        group.push_back(k);
        grouped[static_cast<std::size_t>(k)] = true;
      }
    if (group.size() > 1) groups.push_back(std::move(group));
  }
  return groups;
}

/// Muscles of the digit that are paralysed, in its order; warns of those that do not cross it.
std::vector<std::string> paralysed_muscles(const std::vector<std::string>& wanted,
                                           const Subject& subject, DigitSweep& about) {
  std::vector<std::string> known, beside;
  for (const MuscleUnit& muscle : subject.muscles) known.push_back(muscle.name);
  for (const std::string& name : wanted) {
    (void)index_of_name(name, known, "muscle");
    if (std::count(about.muscles.begin(), about.muscles.end(), name) == 0) beside.push_back(name);
  }
  if (!beside.empty())
    about.warnings.push_back(
        fmt::format("their paralysis changes nothing, as they cross no free joint of the digit: {}",
                    listed(beside)));
  std::vector<std::string> paralysed;
  for (const std::string& muscle : about.muscles)
    if (std::count(wanted.begin(), wanted.end(), muscle) > 0) paralysed.push_back(muscle);
  return paralysed;
}

/// The digit with some of its muscles paralysed.
DigitAtPosture without_muscles(DigitAtPosture at, const std::vector<std::string>& paralysed) {
  for (std::size_t i = 0; i < at.statics.muscles.size(); ++i)
    if (std::count(paralysed.begin(), paralysed.end(), at.statics.muscles[i]) > 0)
      at.statics.max_tension[static_cast<Eigen::Index>(i)] = 0;
  return at;
}

ParalysisLoss loss_of(const MaxTipForce& left, MaxTipForce intact) {
  // A posture in which nothing balances makes no force.
  const auto newtons = [](const MaxTipForce& force) {
    if (force.status == Status::kInfeasible) return 0.0;
    return force.status == Status::kSolved ? force.component
                                           : std::numeric_limits<double>::quiet_NaN();
  };
  const double all = newtons(intact);
  const double share =
      all < kNoTipForce ? std::numeric_limits<double>::quiet_NaN() : 1 - newtons(left) / all;
  return {std::move(intact), share};
}

FeasibleForcePoint point_at(const FeasibleForceRequest& request, const DigitAtPosture& at) {
  FeasibleForcePoint point;
  point.q = at.q;
  point.axes = force_axes(at, request.frame);
  point.tip = at.tip;
  point.condition = at.condition;
  point.plane_normal = at.plane_normal;
  point.alike = muscles_alike(at.statics.R);
  if (request.direction) {
    point.largest = max_tip_force(at.statics, point.axes.to_world * *request.direction,
                                  {request.tolerance, true});
    point.change = change_of(at, *point.largest, request.frame);
  }
  if (!request.direction || request.whole_set) point.whole = whole_set(at.statics, point.axes);
  return point;
}

}  // namespace

FeasibleForceAnswer ask_feasible_force(const FeasibleForceRequest& request,
                                       const Progress& progress) {
  require(request.tolerance >= 0 && request.tolerance < kPi / 2,
          "wanted a tolerance of 0 deg to below 90 deg, got {:.6g} deg",
          request.tolerance / kDegree);
  const DigitCase digit = build_digit(request.digit, TendonOptions().hood);
  FeasibleForceAnswer answer;
  answer.about = sweep_of(digit);
  answer.direction = request.direction;
  answer.tolerance = request.tolerance;
  answer.without = paralysed_muscles(request.without, digit.subject, answer.about);

  const auto ask = [&](const Eigen::VectorXd& q) {
    const DigitAtPosture intact = digit_at(digit, q);
    require_limits(intact.statics, request.digit.subject);
    const DigitAtPosture at = without_muscles(intact, answer.without);
    answer.max_tension = at.statics.max_tension;
    FeasibleForcePoint point = point_at(request, at);
    // What the paralysed muscles gave.
    if (point.largest && !answer.without.empty())
      point.loss = loss_of(*point.largest,
                           max_tip_force(intact.statics, point.axes.to_world * *request.direction,
                                         {request.tolerance}));
    answer.points.push_back(std::move(point));
    return at.warnings;
  };
  ask_postures(answer.about, ask, kept_in(answer.points), progress);
  return answer;
}

}  // namespace thenar
