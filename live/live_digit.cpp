#include "live/live_digit.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "api/moment_arms.h"
#include "base/error.h"
#include "base/lists.h"
#include "base/nearest_name.h"
#include "base/numbers.h"
#include "base/units.h"
#include "tendons/net/build_tendons.h"
#include "tendons/net/net_continuation.h"
#include "tendons/net/net_derivatives.h"

namespace thenar {
namespace {

constexpr double kSlackTension = 1e-6;  // tension below which a muscle of a net is slack [N]

/// Builds a digit with the requested hood or net, or else with a net if the digit can have one.
DigitCase open_digit(const DigitRequest& request, std::vector<std::string>& warnings) {
  // Build the hood or net of the request.
  require(request.vary.empty() && request.map.empty(),
          "wanted a digit to move, got a sweep or map");
  if (request.hood || !request.net.empty()) return build_digit(request, Hood::kFractions);
  // Without either, try a net, and fall back to fixed fractions with a warning.
  try {
    return build_digit(request, Hood::kFloatingNet);
  } catch (const InputError& error) {
    DigitCase fractions = build_digit(request, Hood::kFractions);
    warnings.push_back(std::string("tendons without a net: ") + error.what());
    return fractions;
  }
}

/// Clamps a posture to the limits, and adds the names of the clamped coordinates to `limited`.
Eigen::VectorXd clamped_to_limits(const Skeleton& skeleton, Eigen::VectorXd q,
                                  std::vector<std::string>& limited) {
  for (int i = 0; i < skeleton.coordinates(); ++i) {
    const CoordinateLimits& limits = skeleton.limits[i];
    const double inside = std::clamp(q[i], limits.lower, limits.upper);
    if (inside != q[i]) limited.push_back(skeleton.coordinate_names[i]);
    q[i] = inside;
  }
  return q;
}

/// Returns warnings about requested model features that the subject has no data for.
std::vector<std::string> lower_rungs(const DigitRequest& request, const Fidelity& built) {
  std::vector<std::string> all;
  if (request.path && built.path != *request.path && built.path == Path::kConstant)
    all.emplace_back("the subject has constant moment arms in place of tendon paths");
  if (request.hood == Hood::kFractions && built.hood == Hood::kSeparate)
    all.emplace_back("the subject has no hood for this digit: its tendons are separate");
  return all;
}

/// Adds the warning of the tendon solver, if there is one.
void add_solver_warning(const DigitPoint& point, std::vector<std::string>& warnings) {
  if (!point.pull.warning.empty())
    warnings.push_back((is_trusted(point.pull.status) ? "" : "not to be trusted: ") +
                       point.pull.warning);
}

}  // namespace

LiveDigit::LiveDigit(const DigitRequest& request) {
  // Build the digit, its muscles and its picture.
  case_ = open_digit(request, warnings_);
  require(case_.map.empty(), "digit '{}' of '{}' has no bones, only tip map '{}': ask tip-force",
          case_.digit, case_.subject.name, case_.map);
  const TendonDigit& digit = case_.bones();
  append_all(warnings_, lower_rungs(request, digit.fidelity));
  muscles_ = std::make_unique<ExcitedMuscles>(case_.subject, case_.tendons);
  build_shape();
  // Solve the initial posture without muscle tensions.
  std::vector<std::string> limited;
  const Eigen::VectorXd q = clamped_to_limits(digit.skeleton, case_.grid.postures.front(), limited);
  if (!limited.empty()) warnings_.push_back("joints begin at their limits: " + listed(limited));
  const auto muscles = static_cast<Eigen::Index>(digit.names.muscles.size());
  solve(q, Eigen::VectorXd::Constant(muscles, kNaN), Eigen::VectorXd::Zero(muscles));
}

void LiveDigit::build_shape() {
  picture_ = std::make_unique<DigitPicture>(case_.subject, case_.digit, case_.tendons,
                                            case_.grid.postures.front());
  append_all(warnings_, picture_->warnings());
  shape_ = picture_->shape();
  shape_.arrows.push_back({"tip force", LiveArrowKind::kForce});
}

Eigen::VectorXd LiveDigit::limited_posture(const std::map<std::string, double>& posture,
                                           std::vector<std::string>& limited) const {
  const Skeleton& skeleton = case_.bones().skeleton;
  // Joints that are not named keep their angles.
  Eigen::VectorXd q = state_.point.q;
  for (const auto& [name, angle] : posture) {
    require(std::isfinite(angle), "wanted an angle of '{}' [rad], got {}", name, angle);
    q[index_of_name(name, skeleton.coordinate_names, "free joint")] = angle;
  }
  return clamped_to_limits(skeleton, q, limited);
}

Eigen::VectorXd LiveDigit::merged_excitations(const DigitInputs& inputs) const {
  const std::vector<std::string>& muscles = case_.bones().names.muscles;
  // A muscle has either a tension or an excitation; setting one clears the other.
  Eigen::VectorXd excitation = state_.excitation;
  for (const auto& [name, tension] : inputs.tension)
    excitation[index_of_name(name, muscles, "muscle")] = kNaN;
  for (const auto& [name, value] : inputs.excitation) {
    require(inputs.tension.count(name) == 0, "wanted a tension or an excitation of '{}', got both",
            name);
    require(value >= 0 && value <= 1, "wanted an excitation of '{}' from 0 to 1, got {}", name,
            value);
    excitation[index_of_name(name, muscles, "muscle")] = value;
  }
  return excitation;
}

std::vector<std::string> LiveDigit::set(const DigitInputs& inputs) {
  std::vector<std::string> limited;
  const Eigen::VectorXd q = limited_posture(inputs.posture, limited);
  const Eigen::VectorXd excitation = merged_excitations(inputs);
  // Take the named tensions, and keep the others.
  const std::vector<std::string>& muscles = case_.bones().names.muscles;
  const Eigen::VectorXd named = tensions(case_, inputs.tension);
  Eigen::VectorXd t = state_.tension;
  for (Eigen::Index m = 0; m < t.size(); ++m)
    if (inputs.tension.count(muscles[m]) > 0) t[m] = named[m];
  solve(q, excitation, t);
  ++changes_;
  return limited;
}

void LiveDigit::solve(const Eigen::VectorXd& q, const Eigen::VectorXd& excitation,
                      const Eigen::VectorXd& t) {
  DigitState next;
  next.excitation = excitation;
  next.tension = muscles_->tensions(excitation, t, q);
  // Recompute the results that depend on tensions alone only if tensions have changed.
  std::optional<TensionBaseline> new_baseline;
  if (baseline_.tension.size() == 0 || baseline_.tension != next.tension)
    new_baseline = baseline_at(next.tension);
  const TensionBaseline& baseline = new_baseline ? *new_baseline : baseline_;
  // Solve the posture; lengths are relative to those with all joints at 0.
  next.point = point_at(q, baseline);
  next.arms = arms_at(next.point, next.tension);
  next.length = lengths_at(next.point, next.tension) - baseline.zero_length;
  // Collect the warnings about this posture and these tensions.
  next.warnings = muscles_->warnings(excitation);
  add_solver_warning(next.point, next.warnings);
  const TendonDigit& bones = case_.bones();
  append_all(next.warnings,
             overload_warnings(bones.names.muscles, bones.max_tension, next.tension));
  const DigitTendons& linear = case_.net != nullptr ? case_.net->linear() : *case_.tendons;
  append_all(next.warnings, reversal_warnings(linear, {{}, 1, {q}, {}}));
  if (bones.fidelity.path != Path::kFitted) append_all(next.warnings, collapse_warnings(linear, q));
  // Commit the results; nothing below throws.
  state_ = std::move(next);
  if (new_baseline) baseline_ = std::move(*new_baseline);
}

LiveDigit::TensionBaseline LiveDigit::baseline_at(const Eigen::VectorXd& t) const {
  TensionBaseline found{t, {}, {}};
  if (case_.net != nullptr)
    found.straight_rest = case_.net->rest(case_.net->net().frame.straight, t, {});
  const Eigen::Index joints = case_.bones().skeleton.coordinates();
  found.zero_length = lengths_at(point_at(Eigen::VectorXd::Zero(joints), found), t);
  return found;
}

DigitPoint LiveDigit::point_at(const Eigen::VectorXd& q, const TensionBaseline& baseline) const {
  const Eigen::VectorXd& t = baseline.tension;
  if (case_.net == nullptr) return std::move(sweep_digit(*case_.tendons, {q}, t).front());
  // Follow the net to the posture as sweep_digit() does, from the cached straight equilibrium.
  const NetTendons& net = *case_.net;
  DigitPoint point;
  point.q = q;
  point.rest =
      net.free_finger().tendons
          ? follow_from_straight(net, q, t).rest
          : follow_net(net, baseline.straight_rest, {net.net().frame.straight, t}, {q, t}).rest;
  point.pull = net.torque_at_equilibrium(q, t, point.rest);
  point.tip = tip_force(tip_statics(net.digit(), q, t, point.pull), t);
  return point;
}

Eigen::MatrixXd LiveDigit::arms_at(const DigitPoint& point, const Eigen::VectorXd& t) const {
  // Moment arms of an unreliable solution are unknown.
  Eigen::MatrixXd arms = point.pull.R;
  if (!is_trusted(point.pull.status)) return arms.setConstant(kNaN);
  if (case_.net == nullptr) return arms;
  // The lines of a slack muscle of a net are undetermined, so it has no moment arm.
  const bool known = why_not_differentiable(case_.net->net().net, point.rest).empty();
  for (const NetMuscle& muscle : case_.net->net().muscles)
    if (!known || t[muscle.muscle] < kSlackTension) arms.row(muscle.muscle).setConstant(kNaN);
  return arms;
}

Eigen::VectorXd LiveDigit::lengths_at(const DigitPoint& point, const Eigen::VectorXd& t) const {
  if (!is_trusted(point.pull.status)) return Eigen::VectorXd::Constant(t.size(), kNaN);
  Eigen::VectorXd lengths = case_.tendons->lengths(point.q, t, point.pull);
  if (case_.net == nullptr) return lengths;
  // The lines of a slack muscle are undetermined.
  for (const NetMuscle& muscle : case_.net->net().muscles)
    if (t[muscle.muscle] < kSlackTension) lengths[muscle.muscle] = kNaN;
  return lengths;
}

DigitCurves LiveDigit::sweep(const std::string& joint, int count, const Progress& progress) const {
  // Check the request; the upper bound on postures limits the computing time.
  require(count >= 2 && count <= 1000, "wanted 2 to 1000 postures, got {}", count);
  const Skeleton& skeleton = case_.bones().skeleton;
  const std::size_t i = index_of_name(joint, skeleton.coordinate_names, "free joint");
  const CoordinateLimits& limits = skeleton.limits[i];
  require(std::isfinite(limits.lower) && limits.lower < limits.upper, "joint '{}' has no range",
          joint);
  // Build the grid over the range of the joint, with the other joints in their current posture.
  PostureRequest posture;
  posture.in_order.assign(state_.point.q.begin(), state_.point.q.end());
  const double step = (limits.upper - limits.lower) / (count - 1);
  const PostureGrid grid =
      posture_grid(skeleton, posture, {{joint, limits.lower, limits.upper, step}});
  if (case_.net != nullptr) return net_curves(joint, grid, progress);
  DigitCase varied = case_;
  varied.grid = grid;
  const MomentArmResult answer = compute_moment_arms(varied, progress);
  // Copy one column for each posture; postures without a solution stay NaN.
  const auto muscles = static_cast<Eigen::Index>(answer.muscles.size());
  const auto postures = static_cast<Eigen::Index>(answer.points.size());
  DigitCurves curves{joint, Eigen::VectorXd(postures),
                     Eigen::MatrixXd::Constant(muscles, postures, kNaN),
                     Eigen::MatrixXd::Constant(muscles, postures, kNaN), answer.outcome.warnings};
  for (Eigen::Index k = 0; k < postures; ++k) {
    const MomentArmPoint& point = answer.points[k];
    curves.angle[k] = point.q[i];
    if (!point.message.empty()) continue;
    curves.arms.col(k) = point.arms.col(i);
    curves.lengths.col(k) = point.length_change;
  }
  return curves;
}

std::string LiveDigit::reliability_warning(const DigitPoint& point) const {
  if (!point.pull.warning.empty()) return point.pull.warning;
  if (case_.bones().fidelity.path == Path::kFitted) return "";
  const std::vector<std::string> warnings = collapse_warnings(case_.net->linear(), point.q);
  return warnings.empty() ? "" : warnings.front();
}

DigitCurves LiveDigit::net_curves(const std::string& joint, const PostureGrid& grid,
                                  const Progress& progress) const {
  const Eigen::VectorXd& t = state_.tension;
  const std::vector<DigitPoint> points = sweep_digit(*case_.tendons, grid.postures, t, progress);
  const auto postures = static_cast<Eigen::Index>(points.size());
  DigitCurves curves{joint, Eigen::VectorXd(postures),
                     Eigen::MatrixXd::Constant(t.size(), postures, kNaN),
                     Eigen::MatrixXd::Constant(t.size(), postures, kNaN), grid.warnings};
  const int varied = grid.varied.front();
  // Copy one column for each posture; unreliable ones stay NaN, and the first warning is reported.
  bool has_warned = false;
  for (Eigen::Index k = 0; k < postures; ++k) {
    const DigitPoint& point = points[k];
    curves.angle[k] = point.q[varied];
    if (!has_warned) {
      const std::string warning = reliability_warning(point);
      has_warned = !warning.empty();
      if (has_warned)
        curves.warnings.push_back(fmt::format("first doubt over the sweep, at {:.4g} deg: {}",
                                              degrees(curves.angle[k]), warning));
    }
    if (!is_trusted(point.pull.status)) continue;
    curves.arms.col(k) = arms_at(point, t).col(varied);
    curves.lengths.col(k) = lengths_at(point, t) - baseline_.zero_length;
  }
  return curves;
}

LiveInstant LiveDigit::instant() const {
  const TendonModel<double>& model = case_.bones().model;
  const DigitPoint& point = state_.point;
  // Draw the digit.
  LiveInstant instant = picture_->instant(point.q, state_.tension, point.rest);
  // Append the arrow of the tip force; an unreliable force has zero length.
  const Eigen::Vector3d tip = moved(pose_tree(model.tree, point.q), model.tip_link, model.tip);
  LiveVector force{subject_pose() * tip, {0, 0, 0}};
  if (is_trusted(point.pull.status)) force.vector = subject_pose().R * point.tip.f_W;
  instant.arrows.push_back(force);
  return instant;
}

}  // namespace thenar
