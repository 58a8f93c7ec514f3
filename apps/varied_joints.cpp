#include "apps/varied_joints.h"

#include <algorithm>
#include <cmath>

#include "apps/options.h"
#include "api/posture.h"
#include "report/table.h"
#include "base/error.h"
#include "base/units.h"

namespace thenar {
namespace {

constexpr std::size_t kMostPostures = 1000000;

/// One joint and its angles.
struct AngleRange {
  int joint;
  std::vector<double> angles;  // [rad]
};

std::vector<double> parse_angles(const std::string& text) {
  const std::size_t first = text.find(':'), second = text.find(':', first + 1);
  require(first != std::string::npos && second != std::string::npos,
          "wanted from:to:step [deg], got '{}'", text);
  const double from = parse_number(text.substr(0, first), "an angle [deg]");
  const double to = parse_number(text.substr(first + 1, second - first - 1), "an angle [deg]");
  const double step = parse_number(text.substr(second + 1), "a step [deg]");
  require(step != 0 && (to - from) / step >= 0, "steps of {} deg do not lead from {} to {} deg",
          step, from, to);
  const double count = std::floor((to - from) / step * (1 + 1e-12) + 1e-9);
  require(count < kMostPostures, "{} deg is too small a step from {} to {} deg", step, from, to);
  std::vector<double> angles;
  for (int k = 0; k <= static_cast<int>(count); ++k) angles.push_back(kDegree * (from + k * step));
  return angles;
}

AngleRange parse_range(const Skeleton& skeleton, const std::string& text) {
  const std::size_t equals = text.find('=');
  require(equals != std::string::npos, "wanted JOINT=from:to:step, got '{}'", text);
  const std::string name = text.substr(0, equals);
  const auto& names = skeleton.coordinate_names;
  const auto found = std::find(names.begin(), names.end(), name);
  require(found != names.end(), "unknown free joint '{}'; there are {}", name, listed(names));
  return {static_cast<int>(found - names.begin()), parse_angles(text.substr(equals + 1))};
}

}  // namespace

VariedJoints parse_varied(const Skeleton& skeleton, const Eigen::VectorXd& q,
                          const std::vector<std::string>& texts) {
  VariedJoints varied{{}, 1, {q}};
  for (const std::string& text : texts) {
    const AngleRange range = parse_range(skeleton, text);
    require(std::count(varied.joints.begin(), varied.joints.end(), range.joint) == 0,
            "joint of '{}' varies twice", text);
    require(varied.postures.size() * range.angles.size() <= kMostPostures, "more than {} postures",
            kMostPostures);
    varied.joints.push_back(range.joint);
    varied.row = range.angles.size();
    std::vector<Eigen::VectorXd> postures;
    for (const Eigen::VectorXd& posture : varied.postures)
      for (const double angle : range.angles) {
        postures.push_back(posture);
        postures.back()[range.joint] = angle;
      }
    varied.postures = std::move(postures);
  }
  warn_of_limits(skeleton, varied.postures.front());
  warn_of_limits(skeleton, varied.postures.back());
  return varied;
}

std::string angles_in_words(const TendonCase& at, const VariedJoints& varied,
                            const Eigen::VectorXd& q) {
  std::string text;
  for (const int joint : varied.joints)
    text += fmt::format("{}={:.4g} ", at.bones().names.coordinates[static_cast<std::size_t>(joint)],
                        q[joint] / kDegree);
  return text + "deg";
}

}  // namespace thenar
