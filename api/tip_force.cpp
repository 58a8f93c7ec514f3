#include "api/tip_force.h"

#include <utility>

#include "base/error.h"
#include "tendons/forces/posture_sensitivity.h"
#include "tendons/forces/tip_force.h"

namespace thenar {
namespace {

constexpr double kMaxHoldLength = 1;  // [m]

/// A tip on a point; also a tip map, whose residual are moments.
void pin(const DigitAtPosture& at, const Eigen::VectorXd& t, TipForcePoint& point) {
  const TipForce result = tip_force(at.statics, t);
  point.force = result.f_W;
  point.residual = result.tau_residual;
  point.condition = result.condition;
  point.singular = result.singular();
  if (at.map.empty()) point.change = tip_force_jacobian(at.statics, at.slopes, t).colwise().norm();
}

/// A tip in a clamp.
void clamp_tip(const DigitAtPosture& at, const Eigen::VectorXd& t, double length,
               TipForcePoint& point) {
  const TipWrench result = tip_wrench(at.statics, t, {length});
  point.force = result.f_W;
  point.moment = result.m_W;
  point.residual = result.tau_residual;
  point.condition = result.condition;
  point.minimum_norm = result.minimum_norm;
  point.change =
      tip_wrench_jacobian(at.statics, at.slopes, t, {length}).bottomRows<3>().colwise().norm();
}

}  // namespace

TipForceResult compute_tip_force(const TipForceRequest& request, const Progress& progress) {
  // A rigid hold weighs moments by a length, which must be that of a hand.
  require_field("hold_length", request.hold_length > 0 && request.hold_length <= kMaxHoldLength,
                "wanted a hold length above 0, up to {:.4g} mm, got {:.6g} mm",
                1e3 * kMaxHoldLength, 1e3 * request.hold_length);
  const DigitCase digit = build_digit(request.digit, TendonOptions().hood);
  require_field("hold", digit.map.empty() || request.hold == TipConstraint::kPinned,
                "tip map '{}' gives forces whatever the hold, got a rigid one", digit.map);
  TipForceResult answer{begin_digit_result(digit), request, tensions(digit, request.tension), {}};
  // Warn of tensions beyond the muscles' largest forces.
  const Eigen::VectorXd limits =
      digit.map.empty() ? digit.bones().max_tension : digit_at(digit, {}).statics.max_tension;
  answer.outcome.warn(overload_warnings(answer.muscles, limits, answer.tension));

  const auto compute = [&](const Eigen::VectorXd& q) {
    // Solve J' f = R' t + tau_0 at each posture, with moments if the hold is rigid.
    const DigitAtPosture at = digit_at(digit, q);
    TipForcePoint point;
    point.q = q;
    point.tip_axes = at.tip_axes;
    point.tip = at.tip;
    point.planar = at.plane_normal.has_value();
    request.hold == TipConstraint::kRigid
        ? clamp_tip(at, answer.tension, request.hold_length, point)
        : pin(at, answer.tension, point);
    answer.points.push_back(std::move(point));
    return at.warnings;
  };
  compute_postures(answer, compute, failure_recorder(answer.points), progress);
  return answer;
}

}  // namespace thenar
