#include "api/moment_arms.h"

#include "api/named/digits.h"
#include "base/error.h"

namespace thenar {
namespace {

constexpr double kNoArm = 1e-9;  // below the rounding of paths of hand size [m/rad]

/// A pull of nothing: arms of linear tendons are there without tension.
TendonTorque arms_at(const DigitTendons& tendons, const Eigen::VectorXd& q) {
  const auto muscles = static_cast<Eigen::Index>(tendons.digit().names.muscles.size());
  return tendons.evaluate(q, Eigen::VectorXd::Zero(muscles));
}

Eigen::VectorXd lengths_at(const DigitTendons& tendons, const Eigen::VectorXd& q,
                           const TendonTorque& pull) {
  return tendons.lengths(q, Eigen::VectorXd::Zero(pull.R.rows()), pull);
}

/// The straight digit, or the first posture if the paths are not to be trusted there.
Eigen::VectorXd reference_posture(const DigitTendons& tendons, DigitResult& result) {
  Eigen::VectorXd straight = Eigen::VectorXd::Zero(tendons.digit().model.coordinates);
  const TendonTorque pull = arms_at(tendons, straight);
  if (is_trusted(pull.status)) return straight;
  result.outcome.warnings.push_back("tendon paths are not to be trusted with all joints at 0 (" +
                                    pull.warning +
                                    "): length changes are those since the first posture");
  return result.grid.postures.front();
}

MomentArmPoint point_at(const DigitTendons& tendons, const Eigen::VectorXd& q,
                        const TendonTorque& pull) {
  const TendonModel<double>& model = tendons.digit().model;
  MomentArmPoint point;
  point.q = q;
  point.arms = pull.R;
  point.length_change = lengths_at(tendons, q, pull);
  point.tip = moved(pose_tree(model.tree, q), model.tip_link, model.tip);
  return point;
}

}  // namespace

MomentArmResult compute_moment_arms(const DigitRequest& request, const Progress& progress) {
  return compute_moment_arms(build_digit(request, TendonOptions().hood), progress);
}

MomentArmResult compute_moment_arms(const DigitCase& digit, const Progress& progress) {
  // Moment arms are properties of paths over bones: maps have no paths, and arms of a net change
  // with its tensions.
  require_field("digit", digit.map.empty(),
                "digit '{}' of '{}' has no bones, only tip map '{}': no moment arms", digit.digit,
                digit.subject.name, digit.map);
  require_field("hood", digit.net == nullptr,
                "moment arms of a net depend on tensions: ask tendon solve or tendon sweep");
  MomentArmResult answer{begin_digit_result(digit), {}, {}, {}};
  // Excursions count from the reference posture, so measure the tendon lengths there once.
  const DigitTendons& tendons = *digit.tendons;
  answer.reference = reference_posture(tendons, answer);
  const Eigen::VectorXd start =
      lengths_at(tendons, answer.reference, arms_at(tendons, answer.reference));

  const auto compute = [&](const Eigen::VectorXd& q) -> std::vector<std::string> {
    const TendonTorque pull = arms_at(tendons, q);
    require(is_trusted(pull.status), "tendon paths are not to be trusted here: {}", pull.warning);
    answer.points.push_back(point_at(tendons, q, pull));
    answer.points.back().length_change -= start;
    if (!pull.warning.empty()) return {pull.warning};
    return tendons.digit().fidelity.path == Path::kFitted ? std::vector<std::string>{}
                                                          : collapse_warnings(tendons, q);
  };
  compute_postures(answer, compute, failure_recorder(answer.points), progress);

  // An arm at any posture shows that the muscle crosses the joint.
  answer.crosses.setConstant(start.size(), answer.reference.size(), false);
  for (const MomentArmPoint& point : answer.points)
    if (point.message.empty())
      answer.crosses = answer.crosses.array() || (point.arms.array().abs() > kNoArm);
  return answer;
}

}  // namespace thenar
