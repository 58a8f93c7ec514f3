#pragma once

/// Tendons of one digit, or of several digits that share a muscle, as one group.

#include <memory>
#include <string>
#include <vector>

#include "tendons/linear_tendons.h"

namespace thenar {

/// Torque of a group: the sum of the TendonTorque of its digits.
struct [[nodiscard]] GroupTorque {
  Eigen::VectorXd tau;               // joint torque [N m] (coordinates)
  Eigen::MatrixXd R;                 // d tau / d tension, transposed [m/rad] (muscles, coordinates)
  std::vector<TendonTorque> digits;  // torque of each digit
  TendonStatus status = TendonStatus::kValid;  // worst status of the digits
  std::string warning;                         // first warning of a digit; may be empty
};

/// Nodes of the nets of all digits for a warm start [m]; empty: start from the straight finger.
using GroupNodes = std::vector<Eigen::Matrix3Xd>;

/// Writes the entries of `from` at the indices to `out`, which allocates only if it grows.
void gather(const Eigen::VectorXd& from, const std::vector<int>& indices, Eigen::VectorXd& out);
/// Adds the entries of a matrix to the given rows and columns of `out`.
void scatter(const Eigen::MatrixXd& added, const std::vector<int>& rows,
             const std::vector<int>& columns, Eigen::MatrixXd& out);

/// Groups the digits that must be solved together: a digit with an excited muscle joins all digits
/// that share a muscle with it; these then contract too, and join further digits. Every other digit
/// is a group of its own.
/// @param muscles  names of the muscles of each digit that have no given tension (digits)
/// @param excited  flag of each digit: one of its muscles is excited (digits)
/// @return indices of the digits of each group, rising; groups ordered by their first digit
///         (groups)
[[nodiscard]] std::vector<std::vector<int>> contracting_groups(
    const std::vector<std::vector<std::string>>& muscles, const std::vector<bool>& excited);

/// Slopes of the moment arms of a group without nets, which give its stiffness at any tensions.
struct GroupSlopes {
  bool exist = false;             // false: a digit or a path is not differentiable at the posture
  std::vector<ArmSlopes> digits;  // slopes of each digit
};

/// Tendons of some digits of a hand. A muscle that several digits share counts once; its moment
/// arms and lengths are summed over the digits.
class TendonGroup {
 public:
  explicit TendonGroup(std::vector<std::shared_ptr<const DigitTendons>> digits);

  /// Returns the names of the joints, each once, in the order of the digits.
  [[nodiscard]] const std::vector<std::string>& coordinates() const { return coordinates_; }
  /// Returns the names of the muscles, each once, in the order of the digits.
  [[nodiscard]] const std::vector<std::string>& muscles() const { return muscles_; }
  /// Returns true if a digit has a floating tendon net.
  [[nodiscard]] bool has_net() const { return has_net_; }
  /// Returns true if sheath friction reduces R, so that R is not the derivative of the lengths.
  [[nodiscard]] bool has_friction() const { return has_friction_; }

  /// Returns a copy whose net bands become taut smoothly, see DigitTendons::smoothed().
  /// @param strain  strain over which a band becomes taut [1]
  [[nodiscard]] TendonGroup smoothed(double strain) const;

  /// Sums the functions of DigitTendons of the same names over all digits.
  /// @param q      posture [rad] (coordinates)
  /// @param t      tensions [N] (muscles)
  /// @param start  nodes of nets for a warm start; may be empty
  /// @param at     result of evaluate() at q and t
  [[nodiscard]] GroupTorque evaluate(const Eigen::VectorXd& q, const Eigen::VectorXd& t,
                                     const GroupNodes& start) const;
  [[nodiscard]] Eigen::MatrixXd torque_by_posture(const Eigen::VectorXd& q,
                                                  const Eigen::VectorXd& t,
                                                  const GroupTorque& at) const;
  [[nodiscard]] Eigen::MatrixXd compliance(const Eigen::VectorXd& q, const Eigen::VectorXd& t,
                                           const GroupTorque& at) const;
  [[nodiscard]] Eigen::VectorXd lengths(const Eigen::VectorXd& q, const Eigen::VectorXd& t,
                                        const GroupTorque& at) const;

  /// Adds the symmetric part of -d tau / d q at constant tension [N m/rad], from slopes of arms.
  /// @param indices    rows and columns of the coordinates in `out` (coordinates)
  /// @param workspace  vector whose memory is reused
  void add_stiffness(const GroupSlopes& slopes, const Eigen::VectorXd& t,
                     const std::vector<int>& indices, Eigen::VectorXd& workspace,
                     Eigen::MatrixXd& out) const;

  /// Computes the lengthening of each muscle from the reference posture at tensions of 1 N [m],
  /// with the first warning of a digit.
  [[nodiscard]] Excursion excursion(const Eigen::VectorXd& q) const;

  /// Tendons of one digit, and the indices of its coordinates and muscles in the group.
  struct Digit {
    std::shared_ptr<const DigitTendons> tendons;
    std::vector<int> coordinates, muscles;
  };
  [[nodiscard]] const std::vector<Digit>& digits() const { return digits_; }

 private:
  friend class GroupArms;
  std::vector<Digit> digits_;
  std::vector<std::string> coordinates_, muscles_;
  bool has_net_ = false, has_friction_ = false;
};

/// Solver of the moment arms of a group without nets, for many postures. Its workspace is reused
/// and does not affect results; a copy has its own workspace.
class GroupArms {
 public:
  /// @param group  group without nets, which must outlive the solver
  /// @throws InputError if the group has a net.
  explicit GroupArms(const TendonGroup& group);
  GroupArms(const GroupArms& other) : GroupArms(*other.group_) {}
  GroupArms& operator=(const GroupArms&) = delete;
  ~GroupArms() = default;

  /// Computes R, warning and status of TendonGroup::evaluate(), also of each digit; other fields of
  /// `out` keep their values.
  void solve(const Eigen::VectorXd& q, GroupTorque& out);

  /// Computes the slopes of the moment arms at a posture.
  void slopes(const Eigen::VectorXd& q, GroupSlopes& out);

 private:
  const TendonGroup* group_;
  std::vector<std::unique_ptr<ArmSolver>> solvers_;  // (digits); null: evaluate() is used
  std::vector<Eigen::VectorXd> q_;                   // postures of the digits [rad] (digits)
};

}  // namespace thenar
