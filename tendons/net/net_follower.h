#pragma once

/// Net in motion, followed from the last accepted state.

#include <memory>

#include "tendons/net/net_continuation.h"

namespace thenar {

/// Returns the options for following a net in one step of a motion.
[[nodiscard]] NetContinuationOptions follower_options();

/// Follows a net from its last accepted state, from which nodes are predicted by  x + dx/dq dq +
/// dx/dp dp,  p the load. If a node is farther than NetContinuationOptions::stray from this
/// prediction, the net is followed in shorter steps; a node that still strays has snapped. So the
/// equilibrium depends on the accepted states only, not on trials.
class NetFollower : public TendonFollower {
 public:
  /// Follows under given tensions. @param tendons  must outlive this object
  explicit NetFollower(const NetTendons& tendons,
                       const NetContinuationOptions& options = follower_options());

  /// Follows from an equilibrium under muscles on elastic tendons, whose far ends are the loads.
  NetFollower(std::unique_ptr<PullByTendon> pull, PostureAndLoad here, const NetEquilibrium& rest);

  TendonTorque torque_at(const Eigen::VectorXd& q, const Eigen::VectorXd& load) override;
  [[nodiscard]] bool snapped() const override { return known_ && !reached_.snaps.empty(); }
  NetStep accept(const Eigen::VectorXd& q, const Eigen::VectorXd& load) override;
  [[nodiscard]] EndSlopes slopes(const Eigen::VectorXd& q, const Eigen::VectorXd& load) override;

 private:
  [[nodiscard]] double unexplained(const PostureAndLoad& from, const NetEquilibrium& rest,
                                   const PostureAndLoad& to, const NetEquilibrium& there) const;
  [[nodiscard]] NetContinuation way_to(const PostureAndLoad& to) const;
  void reach(const PostureAndLoad& to);
  void find_slopes();

  std::unique_ptr<const NetPull> pull_;
  const NetTendons& tendons_;
  NetContinuationOptions options_;
  bool known_ = false;
  PostureAndLoad here_;  // accepted state
  NetEquilibrium rest_;  // equilibrium at the accepted state
  Eigen::MatrixXd by_posture_,
      by_load_;              // derivatives of all nodes there, stacked; empty: not differentiable
  PostureAndLoad asked_;     // last trial state
  NetContinuation reached_;  // equilibrium at the trial state
};

}  // namespace thenar
