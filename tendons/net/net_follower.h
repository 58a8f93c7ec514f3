#pragma once

/// A net in motion, found at any state by way of the one that was accepted last.

#include "tendons/net/net_continuation.h"

namespace thenar {

/// How far a net is followed in one step of a motion.
[[nodiscard]] NetContinuationOptions follower_options();

/// Where the net was accepted, knots move with  x + dx/dq dq + dx/dt dt.  Where one is found
/// further than NetContinuationOptions::stray from there, the net is followed in shorter steps:
/// what still strays has snapped. So the net has a memory, and where it rests does not depend on
/// trials.
class NetFollower : public TendonFollower {
 public:
  /// @param tendons  must outlive it
  explicit NetFollower(const NetTendons& tendons,
                       const NetContinuationOptions& options = follower_options());

  TendonTorque at(const Eigen::VectorXd& q, const Eigen::VectorXd& t) override;
  [[nodiscard]] bool snapped() const override { return known_ && !reached_.snaps.empty(); }
  NetStep accept(const Eigen::VectorXd& q, const Eigen::VectorXd& t) override;

 private:
  /// Potential of the net,  strain energy + t L,  and what it changes by:  -tau dq + L dt.
  struct Potential {
    double energy = 0;    // [J]
    Eigen::VectorXd tau;  // of the net [N m] (coordinates)
    Eigen::VectorXd L;    // of the bands that muscles pull, by muscle [m] (muscles)
  };
  [[nodiscard]] Potential potential(const PostureAndLoad& at, const NetEquilibrium& rest) const;
  [[nodiscard]] double unexplained(const PostureAndLoad& from, const NetEquilibrium& rest,
                                   const PostureAndLoad& to, const NetEquilibrium& there) const;
  void reach(const PostureAndLoad& to);
  void find_slopes();

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
