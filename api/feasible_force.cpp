#include "api/feasible_force.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/error.h"
#include "base/lists.h"
#include "base/nearest_name.h"
#include "base/units.h"
#include "hand/tip_manipulability.h"
#include "tendons/forces/pinch_statics.h"

namespace thenar {
namespace {

ForceAxes force_axes(const DigitAtPosture& at, DirectionFrame frame) {
  if (!at.map.empty()) {
    require_field("frame", frame == DirectionFrame::kWorld,
                  "tip map '{}' knows only its own x, y, z, got axes of the tip", at.map);
    return {"map", {"x", "y", "z"}, Eigen::Matrix3d::Identity()};
  }
  if (frame == DirectionFrame::kWorld) return {};
  return {"tip", {"proximal", "dorsal", "radial"}, *at.tip_axes};
}

void require_limits(const TipStatics& statics, const std::string& subject) {
  const std::vector<std::string> unknown = unlimited_muscles(statics);
  require_field(
      "subject", unknown.empty(),
      "feasible forces need the largest force of every muscle; unknown: {}. Give each [[muscle]] "
      "max_force_N, or pcsa_cm2 and specific_tension_N_cm2, in {}",
      listed(unknown), subject);
}

/// The wrist, and joints at the end of their range, by index.
struct HeldJoints {
  std::vector<int> wrist;           // coordinates that digits share
  std::vector<std::string> others;  // muscles that cross it on their way to other digits
  std::vector<JointStop> stops;     // in the order of the names
};

/// Returns the options of the tip load at one posture, in the axes of the request.
TipLoadOptions options_of(const FeasibleForceRequest& request, const HeldJoints& held,
                          const ForceAxes& axes) {
  return {request.load,  request.tolerance, request.max_other,
          axes.to_world, /*prices=*/true,   held.stops};
}

/// A map knows moments about some axes only: the others are not zero but unknown.
void require_moments(const FeasibleForceRequest& request, const DigitAtPosture& at) {
  if (at.map.empty() || (request.load == TipLoad::kForce && request.max_other == 0)) return;
  require_field(request.load == TipLoad::kForce ? "moments" : "load", has_rotation(at.statics),
                "tip map '{}' of '{}' has no moments", at.map, at.subject);
  // A row of zeros in W marks an axis about which the map was not measured.
  const Eigen::VectorXd known = at.statics.W.cwiseAbs().rowwise().sum();
  if (request.load == TipLoad::kForce) return;
  // Leave out the rows of a moment that is zero by request; tolerances and whole sets use all
  // three.
  const Eigen::Vector3d wanted = request.direction.value_or(Eigen::Vector3d::Ones());
  for (int k = 0; k < 3; ++k)
    require_field("direction",
                  known(k) > 0 || (wanted(k) == 0 && !request.whole_set && request.tolerance == 0),
                  "tip map '{}' of '{}' has no row t{}: it knows moments about{}{}{} alone", at.map,
                  at.subject, "xyz"[k], known(0) > 0 ? " x" : "", known(1) > 0 ? " y" : "",
                  known(2) > 0 ? " z" : "");
}

/// Derivative of the largest load by each joint; empty unless there is such a load of bones.
Eigen::VectorXd change_of(const DigitAtPosture& at, const MaxTipLoad& found,
                          const FeasibleForceRequest& request) {
  if (found.largest.status != Status::kSolved ||
      found.largest.component < no_tip_load(request.load) || !at.map.empty())
    return {};
  return max_tip_load_gradient(at.statics, at.slopes, found, request.load, request.frame);
}

WholeForceSet whole_set(const TipStatics& statics, const TipLoadOptions& options) {
  WholeForceSet whole{feasible_load_set(statics, options), {}};
  TipLoadOptions along = options;
  along.tolerance = 0;
  along.prices = false;
  for (int k = 0; k < 6; ++k)
    whole.along.push_back(
        max_tip_load(statics, (k % 2 == 0 ? 1 : -1) * options.axes.col(k / 2), along).largest);
  return whole;
}

/// Groups of muscles, by index, whose rows of R are the same and not zero.
std::vector<std::vector<int>> muscles_alike(const Eigen::MatrixXd& R) {
  constexpr double kArmRounding = 1e-12;  // Rounding of moment arms, over the largest [1]
  // Equal rows of R make muscles interchangeable: only the sum of their tensions is determined.
  const double same = kArmRounding * R.cwiseAbs().maxCoeff();
  std::vector<std::vector<int>> groups;
  std::vector<bool> grouped(static_cast<std::size_t>(R.rows()), false);
  for (int i = 0; i < R.rows(); ++i) {
    // Skip muscles of a group that is known, and muscles that cross no joint.
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

/// Muscles of the digit that are paralysed or weak; warns of those that do not cross it.
void keep_weak_muscles(const FeasibleForceRequest& request, const Subject& subject,
                       FeasibleForceResult& answer) {
  // Every name is one of the subject's.
  const std::vector<std::string> known = names_of(subject.muscles);
  std::vector<std::string> wanted = request.without, beside;
  // A weak muscle keeps some of its tension; a paralysed one has none.
  for (const auto& [name, limit] : request.weakened) {
    require_field("weakened", limit >= 0, "wanted a tension >= 0 of the weak '{}', got {} N", name,
                  limit);
    wanted.push_back(name);
  }
  const std::vector<std::string>& own = answer.muscles;
  for (const std::string& name : wanted) {
    (void)index_of_name(name, known, "muscle",
                        contains(request.without, name) ? "without" : "weakened");
    if (!contains(own, name)) beside.push_back(name);
  }
  if (!beside.empty())
    answer.outcome.warnings.push_back(
        fmt::format("their paralysis changes nothing, as they cross no free joint of the digit: {}",
                    listed(beside)));
  // Those of the digit, in its order.
  for (const std::string& muscle : own) {
    if (contains(request.without, muscle)) answer.without.push_back(muscle);
    const auto weak = request.weakened.find(muscle);
    if (weak != request.weakened.end()) answer.weakened.insert(*weak);
  }
}

/// The digit with some of its muscles paralysed or weak.
DigitAtPosture with_weak_muscles(DigitAtPosture at, const FeasibleForceResult& answer) {
  for (std::size_t i = 0; i < at.statics.muscles.size(); ++i) {
    const std::string& muscle = at.statics.muscles[i];
    double& most = at.statics.max_tension[static_cast<Eigen::Index>(i)];
    const auto weak = answer.weakened.find(muscle);
    if (weak != answer.weakened.end()) most = std::min(most, weak->second);
    if (contains(answer.without, muscle)) most = 0;
  }
  return at;
}

/// @param none  loads below this are none [N] or [N m]
ParalysisLoss loss_of(const MaxTipForce& left, MaxTipForce intact, double none) {
  // A posture in which nothing balances makes no load.
  const auto size = [](const MaxTipForce& load) {
    if (load.status == Status::kInfeasible) return 0.0;
    return load.status == Status::kSolved ? load.component : kNaN;
  };
  const double all = size(intact);
  const double share = all < none ? kNaN : 1 - size(left) / all;
  return {std::move(intact), share};
}

/// Muscles that cross joints of other digits but none of this digit's own.
std::vector<std::string> muscles_of_others(const DigitCase& digit) {
  std::vector<std::string> own, others;
  // Sort the muscles of every digit into those that cross this one and those that do not.
  for (const Digit& each : digit.subject.digits) {
    const std::vector<std::string> crossing =
        build_tendon_digit(digit.subject, each.name).names.muscles;
    std::vector<std::string>& list = each.name == digit.digit ? own : others;
    append_all(list, crossing);
  }
  // Those of them that cross the wrist, in the digit's order.
  std::vector<std::string> left_out;
  for (const std::string& muscle : digit.bones().names.muscles)
    if (!contains(own, muscle) && contains(others, muscle)) left_out.push_back(muscle);
  return left_out;
}

/// The wrist and stops of a request; warns of muscles that are left out.
HeldJoints held_joints(const FeasibleForceRequest& request, const DigitCase& digit,
                       std::vector<std::string>& warnings) {
  HeldJoints held;
  const bool held_wrist = request.wrist == WristLoad::kHeld;
  // A held wrist resists any torque, so it is not part of the balance.
  if (held_wrist && request.stops.empty()) return held;
  require_field(held_wrist ? "stops" : "wrist", digit.map.empty(),
                "tip map '{}' knows no joints: it has neither a wrist nor stops", digit.map);
  // Add each stop as a one-sided reaction; its sign selects the end of the range.
  const std::vector<std::string>& joints = digit.bones().names.coordinates;
  for (const auto& [joint, most] : request.stops) {
    const std::size_t i = index_of_name(joint, joints, "free joint", "stops");
    require_field("stops", std::abs(most) > 0, "wanted a torque of the stop of '{}', got {} N m",
                  joint, most);
    held.stops.push_back({static_cast<int>(i), most});
  }
  if (held_wrist) return held;
  // Find the wrist: the free joints that are proximal to more than one digit.
  for (const std::string& joint : shared_joints(digit.subject))
    if (const int i = place_in(joints, joint); i >= 0) held.wrist.push_back(i);
  require_field("wrist", !held.wrist.empty(),
                "subject '{}' has no wrist joint: no free joint is shared by its digits",
                digit.subject.name);
  // Muscles of other digits that cross the wrist would need a balance at joints outside of this
  // model.
  held.others = muscles_of_others(digit);
  if (!held.others.empty())
    warnings.push_back(fmt::format(
        "left out, as they would have to balance joints of other digits: {}", listed(held.others)));
  return held;
}

/// The names that are not among `left_out`, in their order.
std::vector<std::string> kept_names(const std::vector<std::string>& names,
                                    const std::vector<std::string>& left_out) {
  std::vector<std::string> kept = names;
  erase_where(kept, [&](const std::string& name) { return contains(left_out, name); });
  return kept;
}

/// The digit without some of its muscles.
DigitAtPosture without_muscles(DigitAtPosture at, const std::vector<std::string>& left_out) {
  if (left_out.empty()) return at;
  TipStatics& statics = at.statics;
  // Keep the order of the digit's own list, which all tables follow.
  const std::vector<std::string> all = statics.muscles;
  statics.muscles = kept_names(all, left_out);
  // Their rows of every table.
  const std::vector<Eigen::Index> rows =
      transformed(statics.muscles, [&](const std::string& muscle) {
        return std::find(all.begin(), all.end(), muscle) - all.begin();
      });
  statics.max_tension = Eigen::VectorXd(statics.max_tension(rows));
  statics.R = Eigen::MatrixXd(statics.R(rows, Eigen::all));
  for (StaticsDerivative& slope : at.slopes) slope.R = Eigen::MatrixXd(slope.R(rows, Eigen::all));
  return at;
}

/// Builds the digit with the requested wrist. The effect of ligaments at a stop is the stop's
/// torque: the passive moment there is a part of it, and does not come on top.
DigitAtPosture with_wrist(DigitAtPosture whole, const HeldJoints& held, WristLoad load) {
  DigitAtPosture at = without_muscles(std::move(whole), held.others);
  TipStatics& statics = at.statics;
  for (const JointStop& stop : held.stops) {
    statics.tau_0[stop.coordinate] = 0;
    for (StaticsDerivative& slope : at.slopes) slope.tau_0[stop.coordinate] = 0;
  }
  // In a pinch no load of the tip reaches the wrist, which has to balance the tendons alone.
  if (load != WristLoad::kPinch) return at;
  statics = without_load_on(std::move(statics), held.wrist);
  at.slopes = without_load_on(std::move(at.slopes), held.wrist);
  // Condition and plane change with the joints that are left.
  at.condition = tip_manipulability(statics.J, statics.W).condition;
  at.plane_normal = plane_normal(statics.J, statics.W);
  return at;
}

/// Warns of stops of joints that are not at the end of their range.
void warn_of_stops(const HeldJoints& held, const DigitCase& digit, DigitAtPosture& at) {
  constexpr double kAtTheEnd = 1 * kDegree;
  for (const JointStop& stop : held.stops) {
    const CoordinateLimits& range =
        digit.bones().skeleton.limits[static_cast<std::size_t>(stop.coordinate)];
    // A positive torque flexes: that stop acts at the end of extension, the lower one.
    const double end = stop.max_torque > 0 ? range.lower : range.upper, now = at.q[stop.coordinate];
    const bool turns = range.upper - range.lower >= 2 * kPi - kAtTheEnd;  // no range is known
    if (!turns && std::abs(now - end) > kAtTheEnd)
      at.warnings.push_back(fmt::format(
          "the stop of {} is asked for at {:.4g} deg, its range ends at {:.4g} deg",
          at.rows[static_cast<std::size_t>(stop.coordinate)], now / kDegree, end / kDegree));
  }
}

std::vector<StopTorque> stop_answers(const HeldJoints& held, const DigitAtPosture& at,
                                     const MaxTipLoad& found) {
  std::vector<StopTorque> answers;
  // Shares of stops are defined only at an optimum.
  if (found.largest.status != Status::kSolved) return answers;
  for (std::size_t k = 0; k < held.stops.size(); ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    answers.push_back({at.rows[static_cast<std::size_t>(held.stops[k].coordinate)],
                       found.stop_torque[i], held.stops[k].max_torque,
                       found.stop_price.size() > 0 ? found.stop_price[i] : kNaN});
  }
  return answers;
}

FeasibleForcePoint point_at(const FeasibleForceRequest& request, const HeldJoints& held,
                            const DigitAtPosture& at) {
  FeasibleForcePoint point;
  // Describe the tip: place, axes, manipulability and the plane of flexion.
  point.q = at.q;
  point.load = request.load;
  point.axes = force_axes(at, request.frame);
  point.tip = at.tip;
  point.condition = at.condition;
  point.plane_normal = at.plane_normal;
  point.alike = muscles_alike(at.statics.R);
  // A map may lack the moments that the question needs.
  require_moments(request, at);
  const TipLoadOptions options = options_of(request, held, point.axes);
  if (request.direction) {
    // Solve the linear program for the largest load in the requested direction.
    const MaxTipLoad found = in_field("direction", [&] {
      return max_tip_load(at.statics, point.axes.to_world * *request.direction, options);
    });
    point.largest = found.largest;
    point.other = found.other;
    point.stops = stop_answers(held, at, found);
    point.change = change_of(at, found, request);
  }
  // Compute the whole convex set if there is no direction.
  if (!request.direction || request.whole_set) point.whole = whole_set(at.statics, options);
  return point;
}

}  // namespace

double no_tip_load(TipLoad load) { return load == TipLoad::kForce ? kNoTipForce : kNoTipMoment; }

FeasibleForceResult compute_feasible_force(const FeasibleForceRequest& request,
                                           const Progress& progress) {
  // Refuse settings that no load could satisfy.
  require_field("tolerance", request.tolerance >= 0 && request.tolerance < kPi / 2,
                "wanted a tolerance of 0 deg to below 90 deg, got {:.6g} deg",
                request.tolerance / kDegree);
  require_field(request.load == TipLoad::kForce ? "moments" : "forces", request.max_other >= 0,
                "wanted {} of at least 0 {}, got {:.6g}",
                request.load == TipLoad::kForce ? "moments" : "forces",
                request.load == TipLoad::kForce ? "N m" : "N", request.max_other);
  // A held wrist is welded, which takes its joints out of the posture as well.
  DigitRequest asked = request.digit;
  asked.wrist = request.wrist == WristLoad::kHeld ? WristMode::kWelded : WristMode::kFree;
  const DigitCase digit = build_digit(asked, TendonOptions().hood);
  FeasibleForceResult answer{begin_digit_result(digit), request, {}, {}, {}, {}};
  // Remove muscles of other digits, then weaken the requested ones.
  const HeldJoints held = held_joints(request, digit, answer.outcome.warnings);
  answer.muscles = kept_names(answer.muscles, held.others);
  keep_weak_muscles(request, digit.subject, answer);
  const bool weak = !answer.without.empty() || !answer.weakened.empty();

  const auto compute = [&](const Eigen::VectorXd& q) {
    DigitAtPosture intact = with_wrist(digit_at(digit, q), held, request.wrist);
    warn_of_stops(held, digit, intact);
    require_limits(intact.statics, request.digit.subject);
    const DigitAtPosture at = with_weak_muscles(intact, answer);
    answer.max_tension = at.statics.max_tension;
    FeasibleForcePoint point = point_at(request, held, at);
    // Compare with the load that the digit makes with all muscles intact.
    if (point.largest && weak) {
      TipLoadOptions options = options_of(request, held, point.axes);
      options.prices = false;
      MaxTipLoad all =
          max_tip_load(intact.statics, point.axes.to_world * *request.direction, options);
      point.loss = loss_of(*point.largest, std::move(all.largest), no_tip_load(request.load));
    }
    answer.points.push_back(std::move(point));
    return at.warnings;
  };
  compute_postures(answer, compute, failure_recorder(answer.points), progress);
  return answer;
}

}  // namespace thenar
