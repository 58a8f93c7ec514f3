#pragma once

/// Hand without tendons: ideal motors at its joints, for models in which muscles do not matter.

#include <vector>

#include "hand/hand.h"
#include "hand/skeleton.h"

namespace thenar {

/// Torque limits of the motor of every coordinate.
struct TorqueLimits {
  Eigen::VectorXd lower;  // smallest torques [N m] (coordinates)
  Eigen::VectorXd upper;  // largest torques [N m] (coordinates)
};

/// Closing synergy of a hand: its drives, the posture it starts from and its approach direction.
struct ClosingSynergy {
  std::vector<Drive> drives;
  PalmApproach approach;
  Eigen::VectorXd open{};  // open posture, as in HandLayout::open
};

/// Skeleton as a Hand: B = I, u = motor torques, tau_0 = passive joint torque.
class SkeletonHand final : public Hand {
 public:
  /// Builds the hand.
  /// @throws InputError if the limits have the wrong length or cross, a drive moves a coordinate
  /// that does not exist, or the open posture has the wrong length.
  SkeletonHand(Skeleton skeleton, TorqueLimits limits, std::vector<LinkSurface> surfaces = {},
               ClosingSynergy use = {});

  [[nodiscard]] const HandLayout& layout() const override { return layout_; }
  [[nodiscard]] std::vector<Pose<double>> pose(const Eigen::VectorXd& q) const override;
  [[nodiscard]] Eigen::Matrix<double, 6, Eigen::Dynamic> jacobian(
      const Eigen::VectorXd& q, int link, const Eigen::Vector3d& p) const override;
  [[nodiscard]] Actuation actuation(const Eigen::VectorXd& q) const override;
  [[nodiscard]] const std::vector<LinkSurface>& surfaces() const override { return surfaces_; }

 private:
  void require_posture(const Eigen::VectorXd& q) const;

  Skeleton skeleton_;
  TorqueLimits limits_;
  HandLayout layout_;
  std::vector<LinkSurface> surfaces_;
};

}  // namespace thenar
