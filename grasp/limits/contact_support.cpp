#include "grasp/limits/contact_support.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <Eigen/QR>

#include "base/lists.h"
#include "grasp/limits/grasp_force.h"
#include "grasp/limits/joint_limits.h"

namespace thenar::internal {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Torques below this fraction of the largest torque of unit forces are rounding errors [1]
constexpr double kTorqueRounding = 1e-12;

/// Entries of a row below this fraction of its norm are rounding errors [1]
constexpr double kForceRounding = 1e-8;

/// Minimum ratio of a coordinate's normal lever to its longest lever at which it presses a contact,
/// and minimum of this ratio over the best one among all coordinates [1]
constexpr double kMinNormalLever = 1e-3, kMinNormalLeverRatio = 0.5;

/// Returns for each coordinate whether it does work on internal forces, which produce no wrench on
/// the object. Other coordinates, such as those of an arm, move all contacts as one rigid body.
std::vector<bool> works_on_internal_forces(const WrenchSet& set, const MatrixXd& T) {
  std::vector<bool> squeezing(static_cast<std::size_t>(T.rows()), false);
  if (T.size() == 0) return squeezing;
  // Orthonormal basis of the forces that exert a wrench on the object.
  Eigen::ColPivHouseholderQR<MatrixXd> qr(free_forces(set).wrench.transpose());
  qr.setThreshold(kForceRounding);
  const MatrixXd Q = qr.householderQ() * MatrixXd::Identity(T.cols(), qr.rank());
  // The remaining torques are due to internal forces.
  const MatrixXd internal = T - (T * Q) * Q.transpose();
  for (Index j = 0; j < T.rows(); ++j)
    squeezing[j] = internal.row(j).norm() > kForceRounding * T.row(j).norm();
  return squeezing;
}

/// One contact with its joint torques (coordinates, size).
class OneContact {
 public:
  OneContact(const MatrixXd& torques, const Reactions& reactions,
             const std::vector<bool>& squeezing, double zero)
      : torques_(torques), reactions_(reactions), squeezing_(squeezing), zero_(zero) {
    for (Index j = 0; j < torques.rows(); ++j)
      if (!is_locked(reactions, j))
        min_ratio_ = std::max(min_ratio_, kMinNormalLeverRatio * normal_ratio(j));
  }

  [[nodiscard]] ContactSupport contact_support() const {
    ContactSupport found{SupportKind::kStructure, -1, 0, torques_.cols(),
                         VectorXd::Zero(torques_.rows())};
    // Select the outermost non-backdrivable coordinate that presses along the normal; without one,
    // the outermost that carries contact force.
    for (const int j : reactions_.non_backdrivable)
      if (normal_ratio(j) >= min_ratio_)
        found.pressing_coordinate = std::max(found.pressing_coordinate, j);
    if (found.pressing_coordinate < 0)
      for (const int j : reactions_.non_backdrivable)
        if (carries_force(j)) found.pressing_coordinate = std::max(found.pressing_coordinate, j);
    // Levers of all coordinates that press.
    bool pressed = false;
    for (Index j = 0; j < torques_.rows(); ++j) {
      if (!presses(j, found.pressing_coordinate)) continue;
      found.levers(j) = std::copysign(longest_lever(j), torques_(j, 0));
      pressed = true;
    }
    // Support by drives first, then by a joint limit, then by structure.
    if (pressed)
      found.kind =
          found.pressing_coordinate >= 0 ? SupportKind::kNonBackdrivable : SupportKind::kEffort;
    if (pressed || found.pressing_coordinate >= 0) return found;
    found.pressing_coordinate = longest_stop();
    if (found.pressing_coordinate >= 0) found.kind = SupportKind::kJointLimit;
    return found;
  }

 private:
  [[nodiscard]] bool carries_force(Index j) const {
    return torques_.row(j).cwiseAbs().maxCoeff() > zero_;
  }
  [[nodiscard]] double longest_lever(Index j) const {
    return std::max(std::abs(torques_(j, 0)), torques_.row(j).tail(torques_.cols() - 1).norm());
  }
  /// Returns the normal lever of a coordinate over its longest lever [1]; 0 if it does no work on
  /// internal forces.
  [[nodiscard]] double normal_ratio(Index j) const {
    if (!squeezing_[j] || !carries_force(j)) return 0;
    return std::abs(torques_(j, 0)) / longest_lever(j);
  }
  [[nodiscard]] bool is_stopped(Index j) const {
    return normal_ratio(j) > kMinNormalLever && resists_torque(reactions_, j, torques_(j, 0));
  }

  /// Returns whether effort at a coordinate presses the contact.
  /// @param worm  the non-backdrivable coordinate that presses, or -1
  [[nodiscard]] bool presses(Index j, int worm) const {
    if (normal_ratio(j) < min_ratio_ || is_locked(reactions_, j)) return false;
    return contains(reactions_.non_backdrivable, j) ? j == worm : !is_stopped(j);
  }

  /// Returns the coordinate with the longest lever of those that the normal force pushes against
  /// their limits.
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
  double zero_, min_ratio_ = kMinNormalLever;
};

/// Splits the forces of one contact into active and passive ones.
void split(JointLoads& joint_loads, const std::vector<int>& non_backdrivable,
           const ContactSupport& contact_support) {
  VectorXd passive_torques = joint_loads.x.col(contact_support.first);
  // Non-backdrivable coordinates support passive forces, and all but the pressing one also active
  // ones.
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
  const double zero = T.size() > 0 ? kTorqueRounding * T.cwiseAbs().maxCoeff() : 0;
  const std::vector<bool> does_work = works_on_internal_forces(set, T);
  JointLoads joint_loads{T, MatrixXd(T.rows(), 0), {}, {}, {}};
  // Find the support of each contact; contacts that no effort presses get a passive force.
  Index first = 0;
  for (const WrenchCap& cap : set.caps) {
    const Index size = 1 + cap.A.cols();
    const MatrixXd torques = T.middleCols(first, size);
    ContactSupport contact_support =
        OneContact(torques, reactions, does_work, zero).contact_support();
    contact_support.first = first;
    if (contact_support.kind != SupportKind::kEffort) {
      split(joint_loads, reactions.non_backdrivable, contact_support);
      joint_loads.passive_contacts.push_back(static_cast<int>(joint_loads.contacts.size()));
    }
    joint_loads.contacts.push_back(contact_support);
    first += size;
  }
  // Only coordinates that carry contact forces are part of the balance.
  for (int j = 0; j < T.rows(); ++j) {
    const double x = joint_loads.x.cols() > 0 ? joint_loads.x.row(j).cwiseAbs().maxCoeff() : 0;
    const double p = joint_loads.p.cols() > 0 ? joint_loads.p.row(j).cwiseAbs().maxCoeff() : 0;
    if (std::max(x, p) > zero) joint_loads.rows.push_back(j);
  }
  return joint_loads;
}

namespace {

using Eigen::RowVectorXd;

/// Rows over y = (x, p, v, r, s) that limit preload; s is absent if no coordinate away from its
/// limits presses.
class PreloadLimits {
 public:
  PreloadLimits(ForceSet forces, const JointLoads& joint_loads, const Actuation& actuation,
                double preload_slack)
      : forces_(std::move(forces)),
        joint_loads_(joint_loads),
        actuation_(actuation),
        preload_slack_(preload_slack),
        s_(forces_.wrench.cols()) {
    // Clutches are the reactions with finite limits.
    clutches_ = reactions_on(actuation.reactions, joint_loads.rows);
    for (Index i = 0; i < clutches_.cols(); ++i)
      if (!std::isfinite(actuation.reactions.lower(i)) ||
          !std::isfinite(actuation.reactions.upper(i)))
        clutches_.col(i).setZero();

    // Add one variable s for each contact on a joint limit, if anything can push back against it.
    const bool pushed = count(SupportKind::kEffort) + count(SupportKind::kNonBackdrivable) > 0;
    append_variables(forces_, pushed ? count(SupportKind::kJointLimit) : 0);
    // Sums for the rows below: active normal forces, and those of joint limits.
    pressed_ = sum_of(SupportKind::kEffort) + sum_of(SupportKind::kNonBackdrivable);
    sum_of_stops_ = zero_row();
    for (Index i = 0; s_ + i < forces_.wrench.cols(); ++i) sum_of_stops_(s_ + i) = 1;
  }

  ForceSet apply() {
    // Limit active forces by the efforts.
    for (const int j : joint_loads_.rows)
      for (const double sign : {1.0, -1.0}) keep_within_efforts(j, sign);
    // Limit passive forces by the sum of active ones.
    limit_push_back();
    if (count(SupportKind::kJointLimit) == 0) return forces_;
    ForceSet without_pressing = forces_;
    // Efforts press joints against their limits, unless springs are stronger.
    for (const auto& [j, sign] : pressing_coordinates())
      max_torque(j, sign) < 0 ? release_stop(j) : press_stop(j, sign);
    // Keep these rows if the hand can be in balance with them.
    if (is_slack() ||
        minimum_grasp_force(forces_, ScaledWrench{}, GraspForceObjective::kSum).status !=
            Status::kInfeasible)
      return forces_;
    // No effort keeps the hand in balance and away from its limits: they are not pressed.
    append_limit(without_pressing, sum_of(SupportKind::kJointLimit) - sum_of_stops_, 0);
    return without_pressing;
  }

 private:
  [[nodiscard]] RowVectorXd zero_row() const { return RowVectorXd::Zero(forces_.wrench.cols()); }
  [[nodiscard]] RowVectorXd unit(Index i) const {
    return RowVectorXd::Unit(forces_.wrench.cols(), i);
  }

  [[nodiscard]] Index row_of(int j) const {
    return std::lower_bound(joint_loads_.rows.begin(), joint_loads_.rows.end(), j) -
           joint_loads_.rows.begin();
  }

  [[nodiscard]] Index count(SupportKind kind) const {
    return std::count_if(joint_loads_.contacts.begin(), joint_loads_.contacts.end(),
                         [&](const ContactSupport& contact) { return contact.kind == kind; });
  }

  [[nodiscard]] RowVectorXd sum_of(SupportKind kind) const {
    RowVectorXd sum = zero_row();
    for (const ContactSupport& contact : joint_loads_.contacts)
      if (contact.kind == kind) sum(contact.first) = 1;
    return sum;
  }

  /// Returns the coordinates at joint limits whose efforts press, with the sign of motion off the
  /// limit.
  [[nodiscard]] std::map<int, double> pressing_coordinates() const {
    std::map<int, double> signs;
    for (const ContactSupport& contact : joint_loads_.contacts)
      if (contact.kind == SupportKind::kJointLimit)
        signs[contact.pressing_coordinate] =
            joint_loads_.x(contact.pressing_coordinate, contact.first) > 0 ? 1 : -1;
    return signs;
  }

  /// Returns whether zero effort is allowed and keeps the hand in balance.
  [[nodiscard]] bool is_slack() const {
    return actuation_.tau_0.isZero(0) && (actuation_.lower.array() <= 0).all() &&
           (actuation_.upper.array() >= 0).all();
  }

  /// Returns the maximum torque of efforts and clutches at a coordinate, in the direction of the
  /// sign.
  [[nodiscard]] double max_torque(int j, double sign) const {
    double sum = sign * actuation_.tau_0(j);
    const auto add = [&](double torque, double lower, double upper) {
      if (torque != 0) sum += std::max(torque * lower, torque * upper);
    };
    // Torques of actuators, then of clutches.
    for (Index k = 0; k < actuation_.B.cols(); ++k)
      add(sign * actuation_.B(j, k), actuation_.lower(k), actuation_.upper(k));
    for (Index i = 0; i < clutches_.cols(); ++i)
      add(sign * clutches_(row_of(j), i), actuation_.reactions.lower(i),
          actuation_.reactions.upper(i));
    return sum;
  }

  /// Adds  sum l_i x_i0 <= max_torque(), over the contacts that push a coordinate back in one
  /// direction.
  void keep_within_efforts(int j, double sign) {
    RowVectorXd row = zero_row();
    for (const ContactSupport& contact : joint_loads_.contacts)
      if (contact.kind == SupportKind::kEffort || contact.kind == SupportKind::kNonBackdrivable)
        row(contact.first) = std::max(0.0, sign * contact.levers(j));
    // Scale by the longest lever; an unlimited torque needs no row.
    const double longest = row.maxCoeff(), limit = std::max(0.0, max_torque(j, sign));
    if (longest > 0 && std::isfinite(limit)) append_limit(forces_, row / longest, limit / longest);
  }

  /// Adds  0 <= s_i <= x_i0, and limits the sum of passive forces by the sum of active ones.
  void limit_push_back() {
    Index s = s_;
    for (const ContactSupport& contact : joint_loads_.contacts) {
      if (contact.kind != SupportKind::kJointLimit || s == forces_.wrench.cols()) continue;
      append_limit(forces_, -unit(s), 0);
      append_limit(forces_, unit(s++) - unit(contact.first), 0);
    }
    // sum s <= sum of active normal forces.
    if (s > s_) append_limit(forces_, sum_of_stops_ - pressed_, 0);
    // sum x of structure + sum s <= active sum + sum a, with a = x - s of joint limits.
    if (count(SupportKind::kStructure) == 0) return;
    // Without anything that presses these x are zero: they exert no wrench.
    if (pressed_.isZero(0) && count(SupportKind::kJointLimit) == 0)
      for (const ContactSupport& contact : joint_loads_.contacts)
        forces_.wrench.middleCols(contact.first, contact.size).setZero();
    append_limit(forces_,
                 sum_of(SupportKind::kStructure) + 2 * sum_of_stops_ -
                     sum_of(SupportKind::kJointLimit) - (1 + preload_slack_) * pressed_,
                 0);
  }

  /// Returns the row of a_i = x_i0 - s_i of contacts at the joint limit of a coordinate, times
  /// their levers.
  [[nodiscard]] RowVectorXd pressed_at(int j) const {
    RowVectorXd row = zero_row();
    Index s = s_;
    for (const ContactSupport& contact : joint_loads_.contacts) {
      if (contact.kind != SupportKind::kJointLimit) continue;
      const double lever =
          contact.pressing_coordinate == j ? std::abs(joint_loads_.x(j, contact.first)) : 0;
      row(contact.first) = lever;
      if (s < row.size()) row(s++) = -lever;
    }
    return row;
  }

  /// Adds  sum |T_j n_i| a_i <= B_j u + R_j r + tau_0j, r of clutches, with the sign of motion off
  /// the limit.
  void press_stop(int j, double sign) {
    RowVectorXd row = pressed_at(j);
    // Columns of efforts v and reactions r.
    const Index v = joint_loads_.x.cols() + joint_loads_.p.cols(), r = v + actuation_.B.cols();
    row.segment(v, actuation_.B.cols()) =
        -sign * actuation_.B.row(j).cwiseProduct(forces_.effort_unit.transpose());
    row.segment(r, clutches_.cols()) = -sign * clutches_.row(row_of(j));
    // Scale to a largest coefficient of 1.
    const double size = row.cwiseAbs().maxCoeff();
    append_limit(forces_, row / size, sign * actuation_.tau_0(j) / size);
  }

  /// Adds a = 0: springs keep the joint at its limit for all efforts.
  void release_stop(int j) {
    const RowVectorXd row = pressed_at(j);
    append_limit(forces_, row / row.cwiseAbs().maxCoeff(), 0);
  }

  ForceSet forces_;
  const JointLoads& joint_loads_;
  const Actuation& actuation_;
  double preload_slack_;      // parameter of hand_forces() [1]
  Eigen::MatrixXd clutches_;  // rows of limited reactions, zeros for others (rows, reactions)
  Index s_;                   // first entry of s
  RowVectorXd pressed_;       // sum of the normal forces that joints away from their limits press
  RowVectorXd sum_of_stops_;  // sum of s
};

}  // namespace

ForceSet limit_preload(ForceSet forces, const JointLoads& joint_loads, const Actuation& actuation,
                       double preload_slack) {
  return PreloadLimits(std::move(forces), joint_loads, actuation, preload_slack).apply();
}

}  // namespace thenar::internal
