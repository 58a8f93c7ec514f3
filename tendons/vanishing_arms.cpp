#include "tendons/vanishing_arms.h"

#include <memory>

#include "base/units.h"
#include "tendons/name_conventions.h"

namespace thenar {

std::vector<VanishingArm> vanishing_arms(const DigitTendons& tendons, const Eigen::VectorXd& q) {
  constexpr int kRangePlaces = 13;    // Angles on a joint's range
  constexpr double kLeastArm = 3e-3;  // Flexors whose largest arm is smaller are left out [m/rad]
  constexpr double kArmShare = 0.25;  // An arm below this share of its largest has vanished [1]
  std::vector<VanishingArm> found;
  const TendonDigit& digit = tendons.digit();
  if (digit.fidelity.path < Path::kViaPoint) return found;
  // Arms do not depend on tension.
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
    // Flexion joints with a range.
    const std::string& joint = digit.names.coordinates[j];
    const auto& limit = digit.skeleton.limits[j];
    if (!is_flexion_joint(joint) || limit.upper - limit.lower > 2 * kPi - 1e-9) continue;
    // Largest arms over the joint's range.
    Eigen::VectorXd max_arm = here.col(j);
    for (int k = 0; k < kRangePlaces; ++k) {
      Eigen::VectorXd there = q;
      there[j] = limit.lower + k * (limit.upper - limit.lower) / (kRangePlaces - 1);
      max_arm = max_arm.cwiseMax(arms_at(there).col(j));
    }
    // Long flexors whose arm is a small part of that.
    for (Eigen::Index m = 0; m < max_arm.size(); ++m) {
      const std::string& muscle = digit.names.muscles[m];
      if (is_long_flexor(muscle) && max_arm[m] > kLeastArm && here(m, j) < kArmShare * max_arm[m])
        found.push_back({muscle, joint, here(m, j), max_arm[m]});
    }
  }
  return found;
}

std::vector<ReversedArm> reversed_arms(const TendonDigit& digit, const Eigen::MatrixXd& R) {
  constexpr double kAcrossArm = 5e-4;  // Largest arm of a tendon that runs across its joint [m/rad]
  std::vector<ReversedArm> found;
  for (Eigen::Index m = 0; m < digit.actions.rows(); ++m)
    for (Eigen::Index j = 0; j < digit.actions.cols(); ++j)
      if (digit.actions(m, j) * R(m, j) < -kAcrossArm)
        found.push_back({digit.names.muscles[m], digit.names.coordinates[j], R(m, j)});
  return found;
}

}  // namespace thenar
