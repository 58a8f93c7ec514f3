#pragma once

/// A net in motion, found at any state by way of the one that was accepted last.

#include <memory>

#include "tendons/net/net_continuation.h"

namespace thenar {

/// Returns the options with which a net is followed in one step of a motion.
[[nodiscard]] NetContinuationOptions follower_options();

/// Follows a net from its last accepted state, from which knots move with  x + dx/dq dq + dx/dp dp,
/// p the load. If a knot is found further than NetContinuationOptions::stray from this prediction,
/// the net is followed in shorter steps; a knot that still strays has snapped. So the net has a
/// memory, and its equilibrium does not depend on trials.
class NetFollower : public TendonFollower {
 public:
  /// @param tendons  must outlive it
  explicit NetFollower(const NetTendons& tendons,
                       const NetContinuationOptions& options = follower_options());

  /// Follows from a rest under muscles on tendons, whose ends are the loads.
  NetFollower(std::unique_ptr<PullByTendon> pull, PostureAndLoad here, const NetEquilibrium& rest);

  TendonTorque at(const Eigen::VectorXd& q, const Eigen::VectorXd& load) override;
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
  PostureAndLoad here_;                   // accepted
  NetEquilibrium rest_;                   // there
  Eigen::MatrixXd by_posture_, by_load_;  // of all nodes there, stacked; empty: no slopes
  PostureAndLoad asked_;                  // last trial
  NetContinuation reached_;               // there
};

}  // namespace thenar
