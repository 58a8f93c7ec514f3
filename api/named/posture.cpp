#include "api/named/posture.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "base/lists.h"
#include "base/nearest_name.h"
#include "base/units.h"

namespace thenar {
namespace {

constexpr double kMaxAngle = 360;  // [deg]

/// [rad] in one unit of the request.
double unit_of(const PostureRequest& request) {
  return request.unit == PostureUnit::kTyped ? kDegree : 1;
}

/// [deg] in one unit of the request.
double degrees_of(const PostureRequest& request) {
  return request.unit == PostureUnit::kTyped ? 1 : 1 / kDegree;
}

/// One joint and its angles.
struct AngleRange {
  int joint;
  std::vector<double> angles;  // [rad]
};

/// @param request  whose unit it has
AngleRange range_of(const Skeleton& skeleton, const Vary& vary, const PostureRequest& request) {
  const auto joint =
      static_cast<int>(index_of_name(vary.joint, skeleton.coordinate_names, "free joint", "vary"));
  const double unit = degrees_of(request);
  AngleRange range{joint, {}};
  for (const double angle :
       steps_of({vary.joint, unit * vary.from, unit * vary.to, unit * vary.step}, " deg"))
    range.angles.push_back(kDegree * angle);
  return range;
}

/// Returns the angles if a joint can have them; others are in a wrong unit.
/// @param field  field of the request that has the angles
const Eigen::VectorXd& checked_angles(const char* field, const Eigen::VectorXd& q,
                                      const std::vector<std::string>& joints) {
  for (Eigen::Index i = 0; i < q.size(); ++i)
    require_field(field, std::abs(q[i]) <= (kMaxAngle + 1e-9) * kDegree,
                  "wanted an angle of '{}' between -{} and {} deg, got {:.6g} deg",
                  joints[static_cast<std::size_t>(i)], kMaxAngle, kMaxAngle, q[i] / kDegree);
  return q;
}

}  // namespace

std::vector<double> steps_of(const Vary& vary, const std::string& unit) {
  const auto& [joint, from, to, step] = vary;
  require_field("vary", step != 0 && (to - from) / step >= 0,
                "steps of {}{} do not lead from {} to {}{}", step, unit, from, to, unit);
  // The end is met where rounding alone would miss it.
  const double count = std::floor((to - from) / step * (1 + 1e-12) + 1e-9);
  require_field("vary", count < kMaxPostures, "{}{} is too small a step from {} to {}{}", step,
                unit, from, to, unit);
  // Multiply rather than add up, so that rounding does not grow with the number of steps.
  std::vector<double> values;
  for (int k = 0; k <= static_cast<int>(count); ++k) values.push_back(from + k * step);
  return values;
}

Eigen::VectorXd in_order(const std::map<std::string, double>& named,
                         const std::vector<std::string>& names, const std::string& kind,
                         const std::string& field) {
  Eigen::VectorXd values = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(names.size()));
  for (const auto& [name, value] : named)
    values[static_cast<Eigen::Index>(index_of_name(name, names, kind, field))] = value;
  return values;
}

Eigen::VectorXd posture_of(const Skeleton& skeleton, const PostureRequest& request) {
  // Named angles leave all others at zero; plain numbers state every joint.
  const std::vector<std::string>& joints = skeleton.coordinate_names;
  require_field("posture", request.named.empty() || request.in_order.empty(),
                "wanted angles by name or in the order of the joints, got both");
  if (request.in_order.empty())
    return checked_angles(
        "posture", unit_of(request) * in_order(request.named, joints, "free joint", "posture"),
        joints);
  require_field("posture", request.in_order.size() == joints.size(),
                "wanted {} angles [{}], of {}, got {}", joints.size(),
                request.unit == PostureUnit::kTyped ? "deg" : "rad", listed(joints),
                request.in_order.size());
  const Eigen::Map<const Eigen::VectorXd> angles(request.in_order.data(),
                                                 static_cast<Eigen::Index>(joints.size()));
  return checked_angles("posture", unit_of(request) * angles, joints);
}

PostureGrid posture_grid(const Skeleton& skeleton, const PostureRequest& request,
                         const std::vector<Vary>& vary) {
  PostureGrid grid;
  // Start with the base posture, and let one joint after the other vary; the last varies fastest.
  grid.postures = {posture_of(skeleton, request)};
  for (const Vary& each : vary) {
    const AngleRange range = range_of(skeleton, each, request);
    require_field("vary", !contains(grid.varied, range.joint), "joint '{}' varies twice",
                  each.joint);
    require_field("vary", grid.postures.size() * range.angles.size() <= kMaxPostures,
                  "more than {} postures", kMaxPostures);
    grid.varied.push_back(range.joint);
    grid.row = range.angles.size();

    // Every posture so far, at every angle of this joint.
    std::vector<Eigen::VectorXd> postures;
    for (const Eigen::VectorXd& posture : grid.postures)
      for (const double angle : range.angles) {
        postures.push_back(posture);
        postures.back()[range.joint] = angle;
      }
    grid.postures = std::move(postures);
  }

  // Fill in the values between the first and the last.
  (void)checked_angles("vary", grid.postures.front(), skeleton.coordinate_names);
  (void)checked_angles("vary", grid.postures.back(), skeleton.coordinate_names);
  // Warn once of each joint that leaves its range at either end of the sweep.
  grid.warnings = limit_warnings(skeleton, grid.postures.front());
  if (grid.postures.size() > 1)
    append_new(grid.warnings, limit_warnings(skeleton, grid.postures.back()));
  return grid;
}

std::vector<std::string> limit_warnings(const Skeleton& skeleton, const Eigen::VectorXd& q) {
  constexpr double kSameAngle = 1e-9;  // [rad]
  std::vector<std::string> warnings;
  // Typed limits and typed angles may differ by rounding in radians.
  for (int i = 0; i < skeleton.coordinates(); ++i) {
    const CoordinateLimits& limits = skeleton.limits[static_cast<std::size_t>(i)];
    if (q[i] >= limits.lower - kSameAngle && q[i] <= limits.upper + kSameAngle) continue;
    warnings.push_back(fmt::format("joint '{}' at {:.4g} deg is outside {:.4g} .. {:.4g} deg",
                                   skeleton.coordinate_names[static_cast<std::size_t>(i)],
                                   q[i] / kDegree, limits.lower / kDegree, limits.upper / kDegree));
  }
  return warnings;
}

std::map<std::string, double> frozen_joints(const Subject& subject, const PostureRequest& request) {
  require_field("frozen", request.in_order.empty(), "wanted JOINT=degrees, got plain numbers");
  // Any joint of the subject can be frozen, also those of other digits.
  const std::vector<std::string> names = names_of(subject.joints);
  std::map<std::string, double> frozen;
  for (const auto& [name, value] : request.named) {
    const JointAxis& joint = subject.joints[index_of_name(name, names, "joint", "frozen")];
    // Compared in degrees: a limit that is typed is not outside of itself by rounding.
    const double asked = degrees_of(request) * value;
    const double lower = joint.lower / kDegree, upper = joint.upper / kDegree;
    require_field("frozen", asked >= lower && asked <= upper,
                  "joint '{}' can be frozen at {:.4g} .. {:.4g} deg, got {:.4g} deg", joint.name,
                  lower, upper, asked);
    frozen[name] = std::clamp(unit_of(request) * value, joint.lower, joint.upper);
  }
  return frozen;
}

}  // namespace thenar
