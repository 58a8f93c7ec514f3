#include "api/posture.h"

#include <algorithm>

#include "apps/options.h"
#include "report/table.h"
#include "base/error.h"

namespace thenar {
namespace {

Eigen::VectorXd parse_plain_angles(const std::vector<std::string>& joints,
                                   const std::vector<std::string>& texts) {
  require(texts.size() == joints.size(), "wanted {} angles [deg], of {}, got {}", joints.size(),
          listed(joints), texts.size());
  Eigen::VectorXd q(static_cast<Eigen::Index>(texts.size()));
  for (std::size_t i = 0; i < texts.size(); ++i)
    q[static_cast<Eigen::Index>(i)] = kDegree * parse_number(texts[i], "an angle [deg]");
  return q;
}

}  // namespace

Eigen::VectorXd parse_posture(const Skeleton& skeleton, const std::vector<std::string>& texts) {
  const auto& joints = skeleton.coordinate_names;
  const bool named = texts.empty() || std::any_of(texts.begin(), texts.end(), [](const auto& text) {
                       return text.find('=') != std::string::npos;
                     });
  if (!named) return parse_plain_angles(joints, texts);
  return kDegree * in_order(parse_named_numbers(texts, "JOINT=degrees"), joints, "free joint");
}

std::map<std::string, double> parse_frozen(const Subject& subject,
                                           const std::vector<std::string>& texts) {
  std::map<std::string, double> frozen = parse_named_numbers(texts, "JOINT=degrees");
  std::vector<std::string> names;
  for (const JointAxis& joint : subject.joints) names.push_back(joint.name);
  (void)in_order(frozen, names, "joint");  // refuses unknown names
  for (const JointAxis& joint : subject.joints) {
    const auto angle = frozen.find(joint.name);
    if (angle == frozen.end()) continue;
    const double lower = joint.lower / kDegree, upper = joint.upper / kDegree;
    require(angle->second >= lower && angle->second <= upper,
            "joint '{}' can be frozen at {:.4g} .. {:.4g} deg, got {:.4g} deg", joint.name, lower,
            upper, angle->second);
    angle->second = std::clamp(angle->second * kDegree, joint.lower, joint.upper);
  }
  return frozen;
}

void warn_of_limits(const Skeleton& skeleton, const Eigen::VectorXd& q) {
  constexpr double kSameAngle = 1e-9;  // [rad]
  for (int i = 0; i < skeleton.coordinates(); ++i) {
    const CoordinateLimits& limits = skeleton.limits[static_cast<std::size_t>(i)];
    if (q[i] >= limits.lower - kSameAngle && q[i] <= limits.upper + kSameAngle) continue;
    fmt::print(stderr,
               "thenar: warning: joint '{}' at {:.4g} deg is outside {:.4g} .. {:.4g} deg\n",
               skeleton.coordinate_names[static_cast<std::size_t>(i)], q[i] / kDegree,
               limits.lower / kDegree, limits.upper / kDegree);
  }
}

}  // namespace thenar
