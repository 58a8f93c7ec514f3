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
#include "tendons/net/digit_sweep.h"
#include "tendons/net/net_continuation.h"
#include "tendons/net/net_derivatives.h"

namespace thenar {
namespace {

constexpr double kNoTension = 1e-6;  // below it a muscle of a net is slack [N]

/// Opens a digit on the rungs that are asked for, or else with a net where the digit can carry one.
DigitCase open_digit(const DigitRequest& request, std::vector<std::string>& warnings) {
  // Try the net first if nobody asks for a rung, and fall back to fractions of the hood.
  require(request.vary.empty() && request.map.empty(),
          "wanted a digit to move, got a sweep or map");
  if (request.hood || !request.net.empty()) return build_digit(request, Hood::kFractions);
  try {
    return build_digit(request, Hood::kFloatingNet);
  } catch (const InputError& error) {
    DigitCase at = build_digit(request, Hood::kFractions);
    warnings.push_back(std::string("tendons without a net: ") + error.what());
    return at;
  }
}

Eigen::VectorXd rounded_to_limits(const Skeleton& skeleton, Eigen::VectorXd q,
                                  std::vector<std::string>& limited) {
  // Clamp each coordinate and report those that would have left their range.
  for (int i = 0; i < skeleton.coordinates(); ++i) {
    const CoordinateLimits& limits = skeleton.limits[i];
    const double inside = std::clamp(q[i], limits.lower, limits.upper);
    if (inside != q[i]) limited.push_back(skeleton.coordinate_names[i]);
    q[i] = inside;
  }
  return q;
}

/// Rungs that were asked for and that the subject has nothing for.
std::vector<std::string> lower_rungs(const DigitRequest& request, const Fidelity& built) {
  std::vector<std::string> all;
  if (request.path && built.path != *request.path && built.path == Path::kConstant)
    all.emplace_back("the subject has constant moment arms in place of tendon paths");
  if (request.hood == Hood::kFractions && built.hood == Hood::kSeparate)
    all.emplace_back("the subject has no hood for this digit: its tendons are separate");
  return all;
}

/// Adds a warning if the tendons' solution is not to be trusted, or the net rests with a doubt.
void add_doubts(const DigitPoint& point, std::vector<std::string>& warnings) {
  if (!point.pull.warning.empty())
    warnings.push_back((trusted(point.pull.status) ? "" : "not to be trusted: ") +
                       point.pull.warning);
}

}  // namespace

LiveDigit::LiveDigit(const DigitRequest& request) {
  case_ = open_digit(request, warnings_);
  require(case_.map.empty(), "digit '{}' of '{}' has no bones, only tip map '{}': ask tip-force",
          case_.digit, case_.subject.name, case_.map);
  const TendonDigit& digit = case_.bones();
  append_all(warnings_, lower_rungs(request, digit.fidelity));
  muscles_ = std::make_unique<ExcitedMuscles>(case_.subject, case_.tendons);
  build_shape();
  // No muscle pulls at first.
  std::vector<std::string> limited;
  const Eigen::VectorXd q = rounded_to_limits(digit.skeleton, case_.grid.postures.front(), limited);
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

Eigen::VectorXd LiveDigit::with_angles(const std::map<std::string, double>& posture,
                                       std::vector<std::string>& limited) const {
  const Skeleton& skeleton = case_.bones().skeleton;
  // Joints that are not named stay where they are.
  Eigen::VectorXd q = now_.point.q;
  for (const auto& [name, angle] : posture) {
    require(std::isfinite(angle), "wanted an angle of '{}' [rad], got {}", name, angle);
    q[index_of_name(name, skeleton.coordinate_names, "free joint")] = angle;
  }
  return rounded_to_limits(skeleton, q, limited);
}

Eigen::VectorXd LiveDigit::with_excitations(const DigitInputs& inputs) const {
  const std::vector<std::string>& muscles = case_.bones().names.muscles;
  // A muscle has either a tension or an excitation; naming one takes the other away.
  Eigen::VectorXd excitation = now_.excitation;
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
  const Eigen::VectorXd q = with_angles(inputs.posture, limited);
  const Eigen::VectorXd excitation = with_excitations(inputs);
  // Tensions that are named, or else those of before.
  const std::vector<std::string>& muscles = case_.bones().names.muscles;
  const Eigen::VectorXd named = tensions(case_, inputs.tension);
  Eigen::VectorXd t = now_.tension;
  for (Eigen::Index m = 0; m < t.size(); ++m)
    if (inputs.tension.count(muscles[m]) > 0) t[m] = named[m];
  solve(q, excitation, t);
  ++changes_;
  return limited;
}

void LiveDigit::solve(const Eigen::VectorXd& q, const Eigen::VectorXd& excitation,
                      const Eigen::VectorXd& t) {
  DigitNow now;
  now.excitation = excitation;
  now.tension = muscles_->tensions(excitation, t, q);
  // Solve again for the straight finger and zero angles only if tensions have changed.
  std::optional<UnderTension> anew;
  if (under_.tension.size() == 0 || under_.tension != now.tension) anew = under(now.tension);
  const UnderTension& under = anew ? *anew : under_;
  // Lengths are changes from those with all joints at zero, under the same tensions.
  now.point = point_at(q, under);
  now.arms = arms_at(now.point, now.tension);
  now.length = lengths_at(now.point, now.tension) - under.zero_length;
  // Doubts about this posture.
  now.warnings = muscles_->warnings(excitation);
  add_doubts(now.point, now.warnings);
  const TendonDigit& bones = case_.bones();
  append_all(now.warnings, overload_warnings(bones.names.muscles, bones.max_tension, now.tension));
  append_all(now.warnings,
             reversal_warnings(case_.net != nullptr ? case_.net->linear() : *case_.tendons,
                               {{}, 1, {q}, {}}));
  if (case_.bones().fidelity.path != Path::kFitted) {
    const DigitTendons& linear = case_.net != nullptr ? case_.net->linear() : *case_.tendons;
    append_all(now.warnings, collapse_warnings(linear, q));
  }
  // Nothing above may fail any more: until here the answer before stays whole.
  now_ = std::move(now);
  if (anew) under_ = std::move(*anew);
}

LiveDigit::UnderTension LiveDigit::under(const Eigen::VectorXd& t) const {
  UnderTension found{t, {}, {}};
  if (case_.net != nullptr)
    found.straight_rest = case_.net->rest(case_.net->net().frame.straight, t, {});
  const Eigen::Index joints = case_.bones().skeleton.coordinates();
  found.zero_length = lengths_at(point_at(Eigen::VectorXd::Zero(joints), found), t);
  return found;
}

DigitPoint LiveDigit::point_at(const Eigen::VectorXd& q, const UnderTension& under) const {
  const Eigen::VectorXd& t = under.tension;
  if (case_.net == nullptr) return std::move(sweep_digit(*case_.tendons, {q}, t).front());
  // As sweep_digit() does, from a straight finger that is at rest already.
  const NetTendons& net = *case_.net;
  DigitPoint point;
  point.q = q;
  point.rest =
      net.free_finger().tendons
          ? follow_from_straight(net, q, t).rest
          : follow_net(net, under.straight_rest, {net.net().frame.straight, t}, {q, t}).rest;
  point.pull = net.torque_at_equilibrium(q, t, point.rest);
  point.tip = tip_force(tip_statics(net.digit(), q, t, point.pull), t);
  return point;
}

Eigen::MatrixXd LiveDigit::arms_at(const DigitPoint& point, const Eigen::VectorXd& t) const {
  // Show no moment arm where the path is not to be trusted.
  Eigen::MatrixXd arms = point.pull.R;
  if (!trusted(point.pull.status)) return arms.setConstant(kNaN);
  if (case_.net == nullptr) return arms;
  // A slack muscle of a net has no arm: where its lines lie, nothing decides.
  const bool known = why_not_differentiable(case_.net->net().net, point.rest).empty();
  for (const NetMuscle& muscle : case_.net->net().muscles)
    if (!known || t[muscle.muscle] < kNoTension) arms.row(muscle.muscle).setConstant(kNaN);
  return arms;
}

Eigen::VectorXd LiveDigit::lengths_at(const DigitPoint& point, const Eigen::VectorXd& t) const {
  if (!trusted(point.pull.status)) return Eigen::VectorXd::Constant(t.size(), kNaN);
  if (case_.net == nullptr) return case_.tendons->lengths(point.q, t, point.pull);
  Eigen::VectorXd lengths = case_.tendons->lengths(point.q, t, point.pull);
  // Nothing decides where the knots of a slack muscle are.
  for (const NetMuscle& muscle : case_.net->net().muscles)
    if (t[muscle.muscle] < kNoTension) lengths[muscle.muscle] = kNaN;
  return lengths;
}

DigitCurves LiveDigit::sweep(const std::string& joint, int count, const Progress& progress) const {
  // A curve needs two postures at least; the upper bound keeps the request short.
  require(count >= 2 && count <= 1000, "wanted 2 to 1000 postures, got {}", count);
  const Skeleton& skeleton = case_.bones().skeleton;
  const std::size_t i = index_of_name(joint, skeleton.coordinate_names, "free joint");
  const CoordinateLimits& limits = skeleton.limits[i];
  require(std::isfinite(limits.lower) && limits.lower < limits.upper, "joint '{}' has no range",
          joint);
  // The whole range, the other joints as they stand.
  PostureRequest posture;
  posture.in_order.assign(now_.point.q.begin(), now_.point.q.end());
  const double step = (limits.upper - limits.lower) / (count - 1);
  const PostureGrid grid =
      posture_grid(skeleton, posture, {{joint, limits.lower, limits.upper, step}});
  if (case_.net != nullptr) return net_curves(joint, grid, progress);
  DigitCase varied = case_;
  varied.grid = grid;
  const MomentArmResult answer = compute_moment_arms(varied, progress);
  // One column a posture.
  const auto muscles = static_cast<Eigen::Index>(answer.muscles.size());
  const auto postures = static_cast<Eigen::Index>(answer.points.size());
  DigitCurves curves{joint, Eigen::VectorXd(postures),
                     Eigen::MatrixXd::Constant(muscles, postures, kNaN),
                     Eigen::MatrixXd::Constant(muscles, postures, kNaN), answer.outcome.warnings};
  for (Eigen::Index k = 0; k < postures; ++k) {
    const MomentArmPoint& point = answer.points[k];
    curves.angle[k] = point.q[i];
    if (!point.failure.empty()) continue;
    curves.arms.col(k) = point.arms.col(static_cast<Eigen::Index>(i));
    curves.lengths.col(k) = point.length_change;
  }
  return curves;
}

std::string LiveDigit::doubt_at(const DigitPoint& point) const {
  if (!point.pull.warning.empty()) return point.pull.warning;
  if (case_.bones().fidelity.path == Path::kFitted) return "";
  const std::vector<std::string> doubts = collapse_warnings(case_.net->linear(), point.q);
  return doubts.empty() ? "" : doubts.front();
}

DigitCurves LiveDigit::net_curves(const std::string& joint, const PostureGrid& grid,
                                  const Progress& progress) const {
  const Eigen::VectorXd& t = now_.tension;
  const std::vector<DigitPoint> points = sweep_digit(*case_.tendons, grid.postures, t, progress);
  const auto postures = static_cast<Eigen::Index>(points.size());
  DigitCurves curves{joint, Eigen::VectorXd(postures),
                     Eigen::MatrixXd::Constant(t.size(), postures, kNaN),
                     Eigen::MatrixXd::Constant(t.size(), postures, kNaN), grid.warnings};
  const int varied = grid.varied.front();
  bool doubtful = false;
  // Postures of the sweep; those that are not trusted leave gaps, and the first doubt is told.
  for (Eigen::Index k = 0; k < postures; ++k) {
    const DigitPoint& point = points[k];
    curves.angle[k] = point.q[varied];
    if (!doubtful) {
      const std::string doubt = doubt_at(point);
      doubtful = !doubt.empty();
      if (doubtful)
        curves.warnings.push_back(fmt::format("first doubt over the sweep, at {:.4g} deg: {}",
                                              degrees(curves.angle[k]), doubt));
    }
    if (!trusted(point.pull.status)) continue;
    curves.arms.col(k) = arms_at(point, t).col(varied);
    curves.lengths.col(k) = lengths_at(point, t) - under_.zero_length;
  }
  return curves;
}

LiveInstant LiveDigit::instant() const {
  const TendonModel<double>& model = case_.bones().model;
  const DigitPoint& point = now_.point;
  // The picture knows the digit, and the force of the tip is the last arrow.
  LiveInstant instant = picture_->instant(point.q, now_.tension, point.rest);
  // A force that is not to be trusted is not drawn.
  const Eigen::Vector3d tip = moved(pose_tree(model.tree, point.q), model.tip_link, model.tip);
  LiveVector force{placed() * tip, {0, 0, 0}};
  if (trusted(point.pull.status)) force.vector = placed().R * point.tip.f_W;
  instant.arrows.push_back(force);
  return instant;
}

}  // namespace thenar
