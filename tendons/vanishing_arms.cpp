#include "tendons/vanishing_arms.h"

#include <memory>

#include "base/units.h"
#include "tendons/name_conventions.h"

namespace thenar {

std::vector<VanishingArm> vanishing_arms(const DigitTendons& tendons, const Eigen::VectorXd& q) {
  constexpr int kRangeSamples = 13;  // number of sampled angles of a joint's range
  constexpr double kMinLargestArm =
      3e-3;  // smallest largest arm of a flexor that is tested [m/rad]
  constexpr double kVanishingRatio =
      0.25;  // arm over its largest one below which it has vanished [1]
  std::vector<VanishingArm> found;
  const TendonDigit& digit = tendons.digit();
  if (digit.fidelity.path < Path::kViaPoint) return found;
  // Define the arms at a posture; they do not depend on tension.
  const std::unique_ptr<ArmSolver> solver = tendons.arm_solver();
  const Eigen::VectorXd t =
      Eigen::VectorXd::Zero(static_cast<Eigen::Index>(digit.names.muscles.size()));
  TendonTorque pull;
  const auto arms_at = [&](const Eigen::VectorXd& there) -> const Eigen::MatrixXd& {
    if (solver)
      solver->solve(there, pull);
    else
      pull = tendons.evaluate(there, t);
    return pull.R;
  };
  const Eigen::MatrixXd here = arms_at(q);
  for (Eigen::Index j = 0; j < q.size(); ++j) {
    // Select flexion joints with a range.
    const std::string& joint = digit.names.coordinates[j];
    const auto& limit = digit.skeleton.limits[j];
    if (!is_flexion_joint(joint) || limit.upper - limit.lower > 2 * kPi - 1e-9) continue;
    // Find the largest arms over the joint's range.
    Eigen::VectorXd max_arm = here.col(j);
    for (int k = 0; k < kRangeSamples; ++k) {
      Eigen::VectorXd there = q;
      there[j] = limit.lower + k * (limit.upper - limit.lower) / (kRangeSamples - 1);
      max_arm = max_arm.cwiseMax(arms_at(there).col(j));
    }
    // Report long flexors whose arm is a small part of that.
    for (Eigen::Index m = 0; m < max_arm.size(); ++m) {
      const std::string& muscle = digit.names.muscles[m];
      if (is_long_flexor(muscle) && max_arm[m] > kMinLargestArm &&
          here(m, j) < kVanishingRatio * max_arm[m])
        found.push_back({muscle, joint, here(m, j), max_arm[m]});
    }
  }
  return found;
}

std::vector<ReversedArm> reversed_arms(const TendonDigit& digit, const Eigen::MatrixXd& R) {
  constexpr double kAcrossArm =
      5e-4;  // largest arm of a tendon that runs straight across its joint [m/rad]
  std::vector<ReversedArm> found;
  for (Eigen::Index m = 0; m < digit.actions.rows(); ++m)
    for (Eigen::Index j = 0; j < digit.actions.cols(); ++j)
      if (digit.actions(m, j) * R(m, j) < -kAcrossArm)
        found.push_back({digit.names.muscles[m], digit.names.coordinates[j], R(m, j)});
  return found;
}

}  // namespace thenar
