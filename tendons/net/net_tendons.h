#pragma once

/// Tendons of one digit whose extensor mechanism is a floating net.

#include <memory>
#include <mutex>
#include <vector>

#include "tendons/digit_tendons.h"
#include "tendons/net/build_net.h"
#include "tendons/net/solve_net.h"

namespace thenar {

/// Pool of solvers of one net, shared by threads, since building a solver costs more than using it.
/// The solvers hold no state that affects results.
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

/// Finger with frozen joints, mapped to the same finger with all of them free. Both are followed
/// from the straight finger on the same way, and so find the same equilibrium.
struct FreeFinger {
  /// Tendons of the finger with all joints free; null: no joint is frozen.
  std::shared_ptr<const NetTendons> tendons;
  /// Angle of each of its coordinates, as a function of the frozen finger's posture.
  std::vector<PostureAngle> angles;
  std::vector<int> muscles;  // index in the frozen finger of each of its muscles; -1: absent

  [[nodiscard]] Eigen::VectorXd posture(const Eigen::VectorXd& q) const;
  [[nodiscard]] Eigen::VectorXd tensions(const Eigen::VectorXd& t) const;
};

/// Digit whose muscles pull the net at their exits with their share of the tension:
///   tau = tau_net(q, D t) + R_own' diag(to_net) t + R' diag(1 - to_net) t,
/// D (pulls, muscles) the shares, R_own the moment arms of the paths from the exits to the origins,
/// R those of whole tendons: of the share that inserts on bone, and of all muscles that do not pull
/// the net. Only tau_net is not linear in t.
class NetTendons : public DigitTendons {
 public:
  /// Builds the tendons.
  /// @param linear  all tendons, separate, with the path model of whole tendons
  /// @param free    if joints are frozen: the finger in which they are not
  NetTendons(std::shared_ptr<const DigitTendons> linear, BuiltNet net,
             const NetSolverOptions& options = {}, FreeFinger free = {});

  [[nodiscard]] const TendonDigit& digit() const override { return digit_; }
  [[nodiscard]] const BuiltNet& net() const { return net_; }

  /// Returns the finger in which no joint is frozen; without tendons if this is that finger.
  [[nodiscard]] const FreeFinger& free_finger() const { return free_; }

  /// Returns all tendons as separate ones, without the net.
  [[nodiscard]] const DigitTendons& linear() const { return *linear_; }

  /// Computes the torque as DigitTendons::evaluate(). `warning` says what is wrong with the paths
  /// outside the net, and why the hood is not reliable: not balanced, unstable, collapsed into an
  /// exit, or with a band inside bone. `R` has the share of the net wherever the net is
  /// differentiable, see why_not_differentiable(); elsewhere `warning` says so.
  TendonTorque evaluate(const Eigen::VectorXd& q, const Eigen::VectorXd& t,
                        const Eigen::Matrix3Xd& start) const override;

  /// Computes the derivatives of torque by implicit differentiation of the net and derivatives() of
  /// the tendons outside it; by finite differences where one of them is not differentiable.
  [[nodiscard]] Eigen::MatrixXd torque_by_posture(const Eigen::VectorXd& q,
                                                  const Eigen::VectorXd& t,
                                                  const TendonTorque& at) const override;

  /// Computes the compliance of the net by implicit differentiation; 0 where it is not
  /// differentiable.
  [[nodiscard]] Eigen::MatrixXd compliance(const Eigen::VectorXd& q, const Eigen::VectorXd& t,
                                           const TendonTorque& at) const override;

  [[nodiscard]] Eigen::VectorXd lengths(const Eigen::VectorXd& q, const Eigen::VectorXd& t,
                                        const TendonTorque& at) const override;

  [[nodiscard]] std::unique_ptr<TendonFollower> follower() const override;

  [[nodiscard]] std::unique_ptr<TendonFollower> follower_on_tendons(
      const TendonEnds& ends) const override;

  /// Returns a copy with this Net::blend.
  [[nodiscard]] std::unique_ptr<DigitTendons> smoothed(double strain) const override;

  /// Computes the torque at a known equilibrium of the net.
  [[nodiscard]] TendonTorque torque_at_equilibrium(const Eigen::VectorXd& q,
                                                   const Eigen::VectorXd& t,
                                                   NetEquilibrium rest) const;

  /// Computes the torque at a known equilibrium, without the net's share of moment arms.
  [[nodiscard]] TendonTorque torque_without_net_arms(const Eigen::VectorXd& q,
                                                     const Eigen::VectorXd& t,
                                                     NetEquilibrium rest) const;

  /// Solves for the equilibrium of the net. Arguments as in evaluate().
  [[nodiscard]] NetEquilibrium rest(const Eigen::VectorXd& q, const Eigen::VectorXd& t,
                                    const Eigen::Matrix3Xd& start) const;
  [[nodiscard]] NetEquilibrium rest(const Eigen::VectorXd& q, const NetDrive& drive,
                                    const Eigen::Matrix3Xd& start) const;

  /// Computes the joint torque of all tendons, with the net at `rest` [N m] (coordinates).
  [[nodiscard]] Eigen::VectorXd torque(const Eigen::VectorXd& q, const Eigen::VectorXd& t,
                                       const NetEquilibrium& rest) const;

  /// Computes the tension of each muscle of the net [N] (pulls).
  [[nodiscard]] Eigen::VectorXd drive(const Eigen::VectorXd& t) const;

  /// Returns the shares D (pulls, muscles) [1].
  [[nodiscard]] const Eigen::MatrixXd& shares() const { return shares_; }

  /// Computes torque, arms and status of all tendons outside the net.
  [[nodiscard]] TendonTorque torque_outside(const Eigen::VectorXd& q,
                                            const Eigen::VectorXd& t) const;

  /// Computes the lengths of lines outside the net, up to a constant [m] (muscles).
  [[nodiscard]] Eigen::VectorXd lengths_outside(const Eigen::VectorXd& q) const;

  /// Computes the derivatives of tendons outside the net, with their lengths.
  [[nodiscard]] TendonDerivatives derivatives_outside(const Eigen::VectorXd& q,
                                                      const Eigen::VectorXd& t) const;

  /// Computes d tau / d q of the tendons outside the net at these tensions; whole tendons as in
  /// DigitTendons::torque_by_posture() [N m/rad] (coordinates, coordinates).
  [[nodiscard]] Eigen::MatrixXd torque_by_posture_outside(const Eigen::VectorXd& q,
                                                          const Eigen::VectorXd& t) const;

 private:
  /// Computes the share of each muscle that bypasses the net as one tendon [1] (muscles).
  [[nodiscard]] Eigen::VectorXd whole_shares() const;

  /// Computes d tau / d q of the muscles' own paths from their exits [N m/rad] (coordinates,
  /// coordinates).
  [[nodiscard]] Eigen::MatrixXd own_path_slopes(const TreeState<double>& state,
                                                const Eigen::VectorXd& t) const;

  /// Computes torque and moment arms of all tendons outside the net, with their warning.
  [[nodiscard]] TendonTorque torque_outside(const Eigen::VectorXd& q, const Eigen::VectorXd& t,
                                            const TreeState<double>& state) const;

  /// Returns the equilibrium stored in `at`; if there is none, solves for it from the nodes of
  /// `at`.
  [[nodiscard]] std::shared_ptr<const NetEquilibrium> equilibrium_of(
      const TendonTorque& at, const Eigen::VectorXd& q, const Eigen::VectorXd& t) const;

  std::shared_ptr<const DigitTendons> linear_;
  BuiltNet net_;
  NetSolverOptions options_;
  FreeFinger free_;
  mutable NetSolverPool solvers_;
  TendonDigit digit_;
  Eigen::MatrixXd shares_;  // D (pulls, muscles)
};

/// Computes the length of the bands that each muscle of the net pulls [m] (muscles of the net).
[[nodiscard]] Eigen::VectorXd muscle_band_length(const Net& net, const NetEquilibrium& rest);

/// Computes the sum of the tensions in the bands of each slip [N].
[[nodiscard]] SlipTension slip_tension(const BuiltNet& net, const NetEquilibrium& rest);

/// Names the bands that have drawn their nodes into their exits; empty: none.
[[nodiscard]] std::string drawn_band_names(const Net& net, const std::vector<int>& bands);

/// Appends text to the warning of a torque; empty text has no effect.
void add_warning(const std::string& more, TendonTorque& pull);

/// Returns the reliability of an equilibrium.
[[nodiscard]] TendonStatus net_status(const Net& net, const TreeState<double>& state,
                                      const NetEquilibrium& rest);

/// Describes why an equilibrium is less reliable; may be empty.
[[nodiscard]] std::string net_warning(const Net& net, const TreeState<double>& state,
                                      const NetEquilibrium& rest);

}  // namespace thenar
