#pragma once

/// Tendons of one digit, or of several digits that share a muscle, as one.

#include <memory>
#include <string>
#include <vector>

#include "tendons/linear_tendons.h"

namespace thenar {

/// Torque of a group, as of TendonTorque.
struct [[nodiscard]] GroupTorque {
  Eigen::VectorXd tau;               // [N m] (coordinates)
  Eigen::MatrixXd R;                 // d tau / d tension, transposed [m/rad] (muscles, coordinates)
  std::vector<TendonTorque> digits;  // parts
  TendonStatus status = TendonStatus::kValid;  // the worst of all digits
  std::string warning;                         // the first of a digit; may be empty
};

/// Nodes of the nets of all digits, to start from; empty: from the straight finger.
using GroupNodes = std::vector<Eigen::Matrix3Xd>;

/// Entries of a list at some places, written over `out`; without the heap once it is as long.
void gather(const Eigen::VectorXd& from, const std::vector<int>& places, Eigen::VectorXd& out);
/// Adds a matrix at some rows and columns of another.
void scatter(const Eigen::MatrixXd& added, const std::vector<int>& rows,
             const std::vector<int>& columns, Eigen::MatrixXd& out);

/// Digits that pull as one: each by itself, but those that contract with all that share a muscle
/// with them. What joins contracts as well, so that the next may join.
/// @param muscles  of each digit, without those that have a tension (digits)
/// @param excited  whether a muscle of the digit is excited (digits)
/// @return digits of each group in their order, groups by their first (groups)
[[nodiscard]] std::vector<std::vector<int>> contracting_groups(
    const std::vector<std::vector<std::string>>& muscles, const std::vector<bool>& excited);

/// Slopes of the arms of a group without nets, by which its stiffness at any tensions follows.
struct GroupSlopes {
  bool exist = false;             // false: a digit has none, or a path is not differentiable there
  std::vector<ArmSlopes> digits;  // parts
};

/// Some digits of a hand. A muscle of two digits is one muscle: its arms and lengths add up.
class TendonGroup {
 public:
  explicit TendonGroup(std::vector<std::shared_ptr<const DigitTendons>> digits);

  /// Joints and muscles, each once, in the order of the digits.
  [[nodiscard]] const std::vector<std::string>& coordinates() const { return coordinates_; }
  [[nodiscard]] const std::vector<std::string>& muscles() const { return muscles_; }
  [[nodiscard]] bool has_net() const { return has_net_; }
  /// Returns true if sheaths take part of R, so that no lengths of lines are consistent with R.
  [[nodiscard]] bool has_friction() const { return has_friction_; }

  /// A copy whose nets' bands blend from slack to taut, see DigitTendons::smoothed().
  [[nodiscard]] TendonGroup smoothed(double strain) const;

  /// Combines the functions of DigitTendons of the same names over all digits.
  /// @param q  posture [rad] (coordinates);  @param t  tensions [N] (muscles)
  [[nodiscard]] GroupTorque evaluate(const Eigen::VectorXd& q, const Eigen::VectorXd& t,
                                     const GroupNodes& start) const;
  [[nodiscard]] Eigen::MatrixXd torque_by_posture(const Eigen::VectorXd& q,
                                                  const Eigen::VectorXd& t,
                                                  const GroupTorque& at) const;
  [[nodiscard]] Eigen::MatrixXd compliance(const Eigen::VectorXd& q, const Eigen::VectorXd& t,
                                           const GroupTorque& at) const;
  [[nodiscard]] Eigen::VectorXd lengths(const Eigen::VectorXd& q, const Eigen::VectorXd& t,
                                        const GroupTorque& at) const;

  /// Adds -d tau / d q at constant tension, the symmetric part, by slopes of arms.
  /// @param places  where coordinates stand in `out` (coordinates)
  /// @param room    used again
  void add_stiffness(const GroupSlopes& slopes, const Eigen::VectorXd& t,
                     const std::vector<int>& places, Eigen::VectorXd& room,
                     Eigen::MatrixXd& out) const;

  /// Lengthening of each muscle from the reference posture, at 1 N, with the first warning of a
  /// digit.
  [[nodiscard]] Excursion excursion(const Eigen::VectorXd& q) const;

  /// One of its digits.
  struct Digit {
    std::shared_ptr<const DigitTendons> tendons;
    std::vector<int> coordinates, muscles;  // of the group
  };
  [[nodiscard]] const std::vector<Digit>& digits() const { return digits_; }

 private:
  friend class GroupArms;
  std::vector<Digit> digits_;
  std::vector<std::string> coordinates_, muscles_;
  bool has_net_ = false, has_friction_ = false;
};

/// Moment arms of a group without nets, posture after posture, with room that is used again and
/// changes no answer. A copy has room of its own.
class GroupArms {
 public:
  /// @param group  without nets; must outlive it
  explicit GroupArms(const TendonGroup& group);
  GroupArms(const GroupArms& other) : GroupArms(*other.group_) {}
  GroupArms& operator=(const GroupArms&) = delete;
  ~GroupArms() = default;

  /// Writes R, warning and status of TendonGroup::evaluate(), and of its parts, over those of
  /// `out`.
  void solve(const Eigen::VectorXd& q, GroupTorque& out);

  /// Slopes of arms at a posture, written over `out`.
  void slopes(const Eigen::VectorXd& q, GroupSlopes& out);

 private:
  const TendonGroup* group_;
  std::vector<std::unique_ptr<ArmSolver>> solvers_;  // (digits); null: evaluate() does
  std::vector<Eigen::VectorXd> q_;                   // (digits)
};

}  // namespace thenar
