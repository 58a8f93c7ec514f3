#pragma once

/// Tendons of one digit whose extensor mechanism is a floating net.

#include <memory>
#include <mutex>
#include <vector>

#include "tendons/digit_tendons.h"
#include "tendons/net/build_net.h"
#include "tendons/net/solve_net.h"

namespace thenar {

/// Solvers of one net that threads share, as building one costs more than solving with it. They
/// hold nothing that changes an answer.
class NetSolverPool {
 public:
  [[nodiscard]] NetEquilibrium solve(const Net& net, const NetSolverOptions& options,
                                     const TreeState<double>& state, const NetDrive& drive,
                                     const Eigen::Matrix3Xd* start);

 private:
  std::mutex lock_;
  std::vector<std::unique_ptr<NetSolver>> idle_;
};

class NetTendons;

/// A finger with joints frozen, seen as the same finger with all of them free: it comes from the
/// straight finger to where its joints are frozen as the other does, and so finds the same rest.
struct FreeFinger {
  std::shared_ptr<const NetTendons> tendons;  // with all joints free; null: they are
  std::vector<PostureAngle> angles;           // of its coordinates, by those of the frozen finger
  std::vector<int> muscles;                   // of the frozen finger, or -1; of each of its own

  [[nodiscard]] Eigen::VectorXd posture(const Eigen::VectorXd& q) const;
  [[nodiscard]] Eigen::VectorXd tensions(const Eigen::VectorXd& t) const;
};

/// Muscles of the net pull it where it leaves their own paths, with their share of the tension:
///   tau = tau_net(q, D t) + R_own' diag(to_net) t + R' diag(1 - to_net) t,
/// D (pulls, muscles) the shares, R_own the moment arms of the paths from the net to the origins, R
/// those of whole tendons: of the share that inserts on bone, and of all muscles that do not pull
/// the net. Only tau_net is not linear in t.
class NetTendons : public DigitTendons {
 public:
  /// @param linear  all tendons, separate; its rung of paths is that of whole tendons
  /// @param free    if joints are frozen: the finger in which they are not
  NetTendons(std::shared_ptr<const DigitTendons> linear, BuiltNet net,
             const NetSolverOptions& options = {}, FreeFinger free = {});

  [[nodiscard]] const TendonDigit& digit() const override { return digit_; }
  [[nodiscard]] const BuiltNet& net() const { return net_; }

  /// The finger in which no joint is frozen; without tendons if this is that finger.
  [[nodiscard]] const FreeFinger& free_finger() const { return free_; }

  /// All tendons as separate ones, without the net.
  [[nodiscard]] const DigitTendons& linear() const { return *linear_; }

  /// `warning` says what is wrong with the paths outside of the net, and why a hood is not to be
  /// trusted: not balanced, unstable, collapsed into an exit, or with a band inside bone. `R` has
  /// the share of the net wherever the net is differentiable, see why_not_differentiable();
  /// elsewhere `warning` says so.
  TendonTorque evaluate(const Eigen::VectorXd& q, const Eigen::VectorXd& t,
                        const Eigen::Matrix3Xd& start) const override;

  /// Computes the slopes of torque by implicit differentiation of the net and derivatives() of what
  /// runs outside of it; by differences where one of them is not differentiable.
  [[nodiscard]] Eigen::MatrixXd torque_by_posture(const Eigen::VectorXd& q,
                                                  const Eigen::VectorXd& t,
                                                  const TendonTorque& at) const override;

  /// Compliance of the net by implicit differentiation; 0 where it is not differentiable.
  [[nodiscard]] Eigen::MatrixXd compliance(const Eigen::VectorXd& q, const Eigen::VectorXd& t,
                                           const TendonTorque& at) const override;

  [[nodiscard]] Eigen::VectorXd lengths(const Eigen::VectorXd& q, const Eigen::VectorXd& t,
                                        const TendonTorque& at) const override;

  [[nodiscard]] std::unique_ptr<TendonFollower> follower() const override;

  [[nodiscard]] std::unique_ptr<TendonFollower> follower_on_tendons(
      const TendonEnds& ends) const override;

  /// A copy with Net::blend.
  [[nodiscard]] std::unique_ptr<DigitTendons> smoothed(double strain) const override;

  /// Returns the torque at a known equilibrium of the net.
  [[nodiscard]] TendonTorque torque_at_rest(const Eigen::VectorXd& q, const Eigen::VectorXd& t,
                                            NetEquilibrium rest) const;

  /// Returns the torque at a known equilibrium without the net's share of moment arms.
  [[nodiscard]] TendonTorque torque_of_rest(const Eigen::VectorXd& q, const Eigen::VectorXd& t,
                                            NetEquilibrium rest) const;

  /// Equilibrium of the net, for pictures and tensions of bands. Arguments as of evaluate().
  [[nodiscard]] NetEquilibrium rest(const Eigen::VectorXd& q, const Eigen::VectorXd& t,
                                    const Eigen::Matrix3Xd& start) const;
  [[nodiscard]] NetEquilibrium rest(const Eigen::VectorXd& q, const NetDrive& drive,
                                    const Eigen::Matrix3Xd& start) const;

  /// Joint torque of all tendons, with the net at `rest` [N m] (coordinates).
  [[nodiscard]] Eigen::VectorXd torque(const Eigen::VectorXd& q, const Eigen::VectorXd& t,
                                       const NetEquilibrium& rest) const;

  /// Tension of each muscle of the net [N] (pulls).
  [[nodiscard]] Eigen::VectorXd drive(const Eigen::VectorXd& t) const;

  /// D (pulls, muscles) [1].
  [[nodiscard]] const Eigen::MatrixXd& shares() const { return shares_; }

  /// Torque, arms and status of all tendons outside of the net.
  [[nodiscard]] TendonTorque torque_outside(const Eigen::VectorXd& q,
                                            const Eigen::VectorXd& t) const;

  /// Lengths of what runs outside of the net, up to a constant [m] (muscles).
  [[nodiscard]] Eigen::VectorXd lengths_outside(const Eigen::VectorXd& q) const;

  /// Derivatives of tendons outside of the net, with the lengths of the muscles outside of the net.
  [[nodiscard]] TendonDerivatives derivatives_outside(const Eigen::VectorXd& q,
                                                      const Eigen::VectorXd& t) const;

  /// d tau / d q of the tendons outside of the net at these tensions, of whole
  /// tendons as DigitTendons::torque_by_posture() finds it [N m/rad] (coordinates, coordinates).
  [[nodiscard]] Eigen::MatrixXd torque_by_posture_outside(const Eigen::VectorXd& q,
                                                          const Eigen::VectorXd& t) const;

 private:
  /// Share of each muscle that runs as one tendon, past the net [1] (muscles).
  [[nodiscard]] Eigen::VectorXd whole_shares() const;

  /// d tau / d q of the muscles' own paths from their exits [N m/rad] (coordinates, coordinates).
  [[nodiscard]] Eigen::MatrixXd own_path_slopes(const TreeState<double>& state,
                                                const Eigen::VectorXd& t) const;

  /// Torque and moment arms of all tendons outside of the net, with their warning.
  [[nodiscard]] TendonTorque torque_outside(const Eigen::VectorXd& q, const Eigen::VectorXd& t,
                                            const TreeState<double>& state) const;

  /// Equilibrium at `at`: that stored in it, otherwise one searched from its nodes.
  [[nodiscard]] std::shared_ptr<const NetEquilibrium> rest_of(const TendonTorque& at,
                                                              const Eigen::VectorXd& q,
                                                              const Eigen::VectorXd& t) const;

  std::shared_ptr<const DigitTendons> linear_;
  BuiltNet net_;
  NetSolverOptions options_;
  FreeFinger free_;
  mutable NetSolverPool solvers_;
  TendonDigit digit_;
  Eigen::MatrixXd shares_;  // D (pulls, muscles)
};

/// Length of the bands that each muscle of the net pulls [m] (muscles of the net).
[[nodiscard]] Eigen::VectorXd muscle_band_length(const Net& net, const NetEquilibrium& rest);

/// Sum of the tensions in the bands of each slip [N].
[[nodiscard]] SlipTension slip_tension(const BuiltNet& net, const NetEquilibrium& rest);

/// Names the bands that have drawn their knots into their exits; empty: none.
[[nodiscard]] std::string drawn_in(const Net& net, const std::vector<int>& bands);

/// Adds to the warning of a torque; nothing if there is no more.
void add_warning(const std::string& more, TendonTorque& pull);

/// Returns the reliability of an equilibrium.
[[nodiscard]] TendonStatus net_status(const Net& net, const TreeState<double>& state,
                                      const NetEquilibrium& rest);

/// Says in words why an equilibrium is less reliable; may be empty.
[[nodiscard]] std::string net_warning(const Net& net, const TreeState<double>& state,
                                      const NetEquilibrium& rest);

}  // namespace thenar
