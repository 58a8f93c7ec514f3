#include "grasp/limits/contact_support.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <Eigen/QR>

#include "grasp/limits/force_set.h"
#include "grasp/limits/grasp_force.h"
#include "grasp/limits/joint_limits.h"

namespace thenar::internal {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Torques below this share of the largest torque of unit forces are rounding [1].
constexpr double kNoTorque = 1e-12;

/// Entries of a row below this share of its norm are rounding [1].
constexpr double kForceRounding = 1e-8;

/// A coordinate presses a contact if its normal lever is at least the first share of its longest
/// lever, and at least the second share of the best such ratio among all coordinates [1].
constexpr double kAlongShare = 1e-3, kAsWellRatio = 0.5;

/// Returns for each coordinate whether it does work on internal forces, which cancel out on the
/// object. Others, like those of an arm, move all contacts as one body would.
std::vector<bool> squeezing(const WrenchSet& set, const MatrixXd& T) {
  std::vector<bool> squeezing(static_cast<std::size_t>(T.rows()), false);
  if (T.size() == 0) return squeezing;
  // Orthonormal basis of the forces that make a wrench on the object.
  Eigen::ColPivHouseholderQR<MatrixXd> qr(free_forces(set).wrench.transpose());
  qr.setThreshold(kForceRounding);
  const MatrixXd Q = qr.householderQ() * MatrixXd::Identity(T.cols(), qr.rank());
  // What is left of the torques is due to internal forces.
  const MatrixXd internal = T - (T * Q) * Q.transpose();
  for (Index j = 0; j < T.rows(); ++j)
    squeezing[static_cast<std::size_t>(j)] =
        internal.row(j).norm() > kForceRounding * T.row(j).norm();
  return squeezing;
}

/// One contact as the joints feel it: torques (coordinates, size).
class OneContact {
 public:
  OneContact(const MatrixXd& torques, const Reactions& reactions,
             const std::vector<bool>& squeezing, double zero)
      : torques_(torques), reactions_(reactions), squeezing_(squeezing), zero_(zero) {
    for (Index j = 0; j < torques.rows(); ++j)
      if (!is_locked(reactions, j)) least_along_ = std::max(least_along_, kAsWellRatio * along(j));
  }

  [[nodiscard]] ContactSupport contact_support() const {
    ContactSupport found{SupportKind::kStructure, -1, 0, torques_.cols(),
                         VectorXd::Zero(torques_.rows())};
    // The outermost non-backdrivable coordinate that presses along the normal; failing it, one that
    // feels the contact.
    for (const int j : reactions_.non_backdrivable)
      if (along(j) >= least_along_)
        found.pressing_coordinate = std::max(found.pressing_coordinate, j);
    if (found.pressing_coordinate < 0)
      for (const int j : reactions_.non_backdrivable)
        if (feels(j)) found.pressing_coordinate = std::max(found.pressing_coordinate, j);
    // Levers of all coordinates that press.
    bool pressed = false;
    for (Index j = 0; j < torques_.rows(); ++j) {
      if (!presses(j, found.pressing_coordinate)) continue;
      found.levers(j) = std::copysign(longest_lever(j), torques_(j, 0));
      pressed = true;
    }
    // Drives come first, then a joint limit, then structure.
    if (pressed)
      found.by =
          found.pressing_coordinate >= 0 ? SupportKind::kNonBackdrivable : SupportKind::kEffort;
    if (pressed || found.pressing_coordinate >= 0) return found;
    found.pressing_coordinate = longest_stop();
    if (found.pressing_coordinate >= 0) found.by = SupportKind::kJointLimit;
    return found;
  }

 private:
  [[nodiscard]] bool feels(Index j) const { return torques_.row(j).cwiseAbs().maxCoeff() > zero_; }
  [[nodiscard]] double longest_lever(Index j) const {
    return std::max(std::abs(torques_(j, 0)), torques_.row(j).tail(torques_.cols() - 1).norm());
  }
  /// Share of a coordinate's longest lever that is along the normal [1]; 0 if it squeezes nothing.
  [[nodiscard]] double along(Index j) const {
    if (!squeezing_[static_cast<std::size_t>(j)] || !feels(j)) return 0;
    return std::abs(torques_(j, 0)) / longest_lever(j);
  }
  [[nodiscard]] bool is_stopped(Index j) const {
    return along(j) > kAlongShare && bears_torque(reactions_, j, torques_(j, 0));
  }

  /// Returns whether effort at a coordinate presses the contact.
  /// @param worm  the non-backdrivable one, or -1
  [[nodiscard]] bool presses(Index j, int worm) const {
    if (along(j) < least_along_ || is_locked(reactions_, j)) return false;
    const auto& non_backdrivable = reactions_.non_backdrivable;
    if (std::find(non_backdrivable.begin(), non_backdrivable.end(), j) != non_backdrivable.end())
      return j == worm;
    return !is_stopped(j);
  }

  /// Coordinate with the longest lever of those that the normal force pushes against their limits.
  [[nodiscard]] int longest_stop() const {
    int longest = -1;
    for (Index j = 0; j < torques_.rows(); ++j)
      if (!is_locked(reactions_, j) && is_stopped(j) &&
          (longest < 0 || std::abs(torques_(j, 0)) > std::abs(torques_(longest, 0))))
        longest = static_cast<int>(j);
    return longest;
  }

  const MatrixXd& torques_;
  const Reactions& reactions_;
  const std::vector<bool>& squeezing_;
  double zero_, least_along_ = kAlongShare;
};

/// Splits the forces of one contact into active and passive ones.
void split(JointLoads& joint_loads, const std::vector<int>& non_backdrivable,
           const ContactSupport& contact_support) {
  VectorXd passive_torques = joint_loads.x.col(contact_support.first);
  // Non-backdrivable coordinates bear passive forces, and all but the pressing one active ones too.
  for (const int j : non_backdrivable) {
    passive_torques(j) = 0;
    if (j != contact_support.pressing_coordinate)
      joint_loads.x.row(j).segment(contact_support.first, contact_support.size).setZero();
  }
  joint_loads.p.conservativeResize(joint_loads.x.rows(), joint_loads.p.cols() + 1);
  joint_loads.p.rightCols(1) = passive_torques;
}

}  // namespace

JointLoads find_contact_support(const WrenchSet& set, const MatrixXd& T,
                                const Reactions& reactions) {
  const double zero = T.size() > 0 ? kNoTorque * T.cwiseAbs().maxCoeff() : 0;
  const std::vector<bool> does_work = squeezing(set, T);
  JointLoads joint_loads{T, MatrixXd(T.rows(), 0), {}, {}, {}};
  // Tell how each contact is supported; what no effort presses gets a passive force.
  Index first = 0;
  for (const WrenchCap& cap : set.caps) {
    const Index size = 1 + cap.A.cols();
    const MatrixXd torques = T.middleCols(first, size);
    ContactSupport contact_support =
        OneContact(torques, reactions, does_work, zero).contact_support();
    contact_support.first = first;
    if (contact_support.by != SupportKind::kEffort) {
      split(joint_loads, reactions.non_backdrivable, contact_support);
      joint_loads.passive_contacts.push_back(static_cast<int>(joint_loads.contacts.size()));
    }
    joint_loads.contacts.push_back(contact_support);
    first += size;
  }
  // Only coordinates that feel a contact take part in the balance.
  for (int j = 0; j < T.rows(); ++j) {
    const double x = joint_loads.x.cols() > 0 ? joint_loads.x.row(j).cwiseAbs().maxCoeff() : 0;
    const double p = joint_loads.p.cols() > 0 ? joint_loads.p.row(j).cwiseAbs().maxCoeff() : 0;
    if (std::max(x, p) > zero) joint_loads.rows.push_back(j);
  }
  return joint_loads;
}

namespace {

using Eigen::Index;
using Eigen::RowVectorXd;
using Eigen::VectorXd;

/// Rows over y = (x, p, v, r, s); s is absent where no coordinate off its joint limits presses.
class Limits {
 public:
  Limits(ForceSet forces, const JointLoads& joint_loads, const Actuation& actuation,
         double preload_slack)
      : forces_(std::move(forces)),
        joint_loads_(joint_loads),
        actuation_(actuation),
        preload_slack_(preload_slack),
        s_(forces_.wrench.cols()) {
    // Clutches are reactions with finite limits.
    clutches_ = reactions_on(actuation.reactions, joint_loads.rows);
    for (Index i = 0; i < clutches_.cols(); ++i)
      if (!std::isfinite(actuation.reactions.lower(i)) ||
          !std::isfinite(actuation.reactions.upper(i)))
        clutches_.col(i).setZero();

    // One variable s for each contact on a joint limit, if anything can push back against it.
    const bool pushed = count(SupportKind::kEffort) + count(SupportKind::kNonBackdrivable) > 0;
    widen(forces_, pushed ? count(SupportKind::kJointLimit) : 0);
    // Sums that the rows below need: active normal forces, and those of joint limits.
    pressed_ = sum_of(SupportKind::kEffort) + sum_of(SupportKind::kNonBackdrivable);
    by_stops_ = none();
    for (Index i = 0; s_ + i < forces_.wrench.cols(); ++i) by_stops_(s_ + i) = 1;
  }

  ForceSet limited() {
    // Active forces stay within the efforts.
    for (const int j : joint_loads_.rows)
      for (const double way : {1.0, -1.0}) keep_within_efforts(j, way);
    // Passive forces push back at most as much as active ones press.
    push_back();
    if (count(SupportKind::kJointLimit) == 0) return forces_;
    ForceSet idle = forces_;
    // Joints at their limits are pressed on by the efforts, unless their springs outweigh these.
    for (const auto& [j, way] : pressers()) largest(j, way) < 0 ? leave(j) : press(j, way);
    // Keep these rows if the hand stays in balance with them.
    if (is_slack() ||
        minimum_grasp_force(forces_, ScaledWrench{}, GraspForceObjective::kSum).status !=
            Status::kInfeasible)
      return forces_;
    // No effort keeps the hand in balance and off its joint limits: they are not pressed.
    add_rows(idle, sum_of(SupportKind::kJointLimit) - by_stops_, VectorXd::Zero(1));
    return idle;
  }

 private:
  [[nodiscard]] RowVectorXd none() const { return RowVectorXd::Zero(forces_.wrench.cols()); }
  [[nodiscard]] RowVectorXd unit(Index i) const {
    return RowVectorXd::Unit(forces_.wrench.cols(), i);
  }

  [[nodiscard]] Index row_of(int j) const {
    return std::lower_bound(joint_loads_.rows.begin(), joint_loads_.rows.end(), j) -
           joint_loads_.rows.begin();
  }

  [[nodiscard]] Index count(SupportKind carrier) const {
    return std::count_if(joint_loads_.contacts.begin(), joint_loads_.contacts.end(),
                         [&](const ContactSupport& contact) { return contact.by == carrier; });
  }

  [[nodiscard]] RowVectorXd sum_of(SupportKind carrier) const {
    RowVectorXd sum = none();
    for (const ContactSupport& contact : joint_loads_.contacts)
      if (contact.by == carrier) sum(contact.first) = 1;
    return sum;
  }

  /// Coordinates at joint limits whose efforts press, and the sign of moving off the limit.
  [[nodiscard]] std::map<int, double> pressers() const {
    std::map<int, double> ways;
    for (const ContactSupport& contact : joint_loads_.contacts)
      if (contact.by == SupportKind::kJointLimit)
        ways[contact.pressing_coordinate] =
            joint_loads_.x(contact.pressing_coordinate, contact.first) > 0 ? 1 : -1;
    return ways;
  }

  /// Returns whether zero effort is allowed and keeps the hand in balance.
  [[nodiscard]] bool is_slack() const {
    return actuation_.tau_0.isZero(0) && (actuation_.lower.array() <= 0).all() &&
           (actuation_.upper.array() >= 0).all();
  }

  /// Largest torque of efforts and clutches at a coordinate, in the direction of the sign.
  [[nodiscard]] double largest(int j, double way) const {
    double sum = way * actuation_.tau_0(j);
    const auto add = [&](double torque, double least, double most) {
      if (torque != 0) sum += std::max(torque * least, torque * most);
    };
    // Torques of actuators, then of clutches.
    for (Index k = 0; k < actuation_.B.cols(); ++k)
      add(way * actuation_.B(j, k), actuation_.lower(k), actuation_.upper(k));
    for (Index i = 0; i < clutches_.cols(); ++i)
      add(way * clutches_(row_of(j), i), actuation_.reactions.lower(i),
          actuation_.reactions.upper(i));
    return sum;
  }

  /// sum l_i x_i0 <= largest torque, over the contacts that push a coordinate back the same way.
  void keep_within_efforts(int j, double way) {
    RowVectorXd row = none();
    for (const ContactSupport& contact : joint_loads_.contacts)
      if (contact.by == SupportKind::kEffort || contact.by == SupportKind::kNonBackdrivable)
        row(contact.first) = std::max(0.0, way * contact.levers(j));
    // Scaled by the longest lever; an unlimited torque needs no row.
    const double longest = row.maxCoeff(), limit = std::max(0.0, largest(j, way));
    if (longest > 0 && std::isfinite(limit))
      add_rows(forces_, row / longest, VectorXd::Constant(1, limit / longest));
  }

  /// 0 <= s_i <= x_i0, and the sum of passive forces is at most the sum of active ones.
  void push_back() {
    Index s = s_;
    for (const ContactSupport& contact : joint_loads_.contacts) {
      if (contact.by != SupportKind::kJointLimit || s == forces_.wrench.cols()) continue;
      add_rows(forces_, -unit(s), VectorXd::Zero(1));
      add_rows(forces_, unit(s++) - unit(contact.first), VectorXd::Zero(1));
    }
    // sum s <= sum of active normal forces.
    if (s > s_) add_rows(forces_, by_stops_ - pressed_, VectorXd::Zero(1));
    // sum x of structure + sum s <= active sum + sum a, with a = x - s of joint limits.
    if (count(SupportKind::kStructure) > 0)
      add_rows(forces_,
               sum_of(SupportKind::kStructure) + 2 * by_stops_ - sum_of(SupportKind::kJointLimit) -
                   (1 + preload_slack_) * pressed_,
               VectorXd::Zero(1));
  }

  /// The a_i = x_i0 - s_i of contacts at the joint limit of a coordinate, times their levers.
  [[nodiscard]] RowVectorXd pressed_at(int j) const {
    RowVectorXd row = none();
    Index s = s_;
    for (const ContactSupport& contact : joint_loads_.contacts) {
      if (contact.by != SupportKind::kJointLimit) continue;
      const double lever =
          contact.pressing_coordinate == j ? std::abs(joint_loads_.x(j, contact.first)) : 0;
      row(contact.first) = lever;
      if (s < row.size()) row(s++) = -lever;
    }
    return row;
  }

  /// sum |T_j n_i| a_i <= B_j u + R_j r + tau_0j, r of clutches, with the sign of moving off the
  /// limit.
  void press(int j, double way) {
    RowVectorXd row = pressed_at(j);
    // Columns of efforts v and reactions r.
    const Index v = joint_loads_.x.cols() + joint_loads_.p.cols(), r = v + actuation_.B.cols();
    row.segment(v, actuation_.B.cols()) =
        -way * actuation_.B.row(j).cwiseProduct(forces_.effort_unit.transpose());
    row.segment(r, clutches_.cols()) = -way * clutches_.row(row_of(j));
    // Scaled to a largest coefficient of 1.
    const double size = row.cwiseAbs().maxCoeff();
    add_rows(forces_, row / size, VectorXd::Constant(1, way * actuation_.tau_0(j) / size));
  }

  /// Springs keep the joint at its limit whatever the efforts are: a = 0.
  void leave(int j) {
    const RowVectorXd row = pressed_at(j);
    add_rows(forces_, row / row.cwiseAbs().maxCoeff(), VectorXd::Zero(1));
  }

  ForceSet forces_;
  const JointLoads& joint_loads_;
  const Actuation& actuation_;
  double preload_slack_;      // of hand_forces() [1]
  Eigen::MatrixXd clutches_;  // rows of limited reactions, zeros for others (rows, reactions)
  Index s_;                   // first of s
  RowVectorXd pressed_;       // sums the normal forces that joints off their limits press
  RowVectorXd by_stops_;      // sums s
};

}  // namespace

ForceSet limit_preload(ForceSet forces, const JointLoads& joint_loads, const Actuation& actuation,
                       double preload_slack) {
  return Limits(std::move(forces), joint_loads, actuation, preload_slack).limited();
}

}  // namespace thenar::internal
