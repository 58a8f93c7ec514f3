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

/// Whether a number is no more than rounding beside the torques of unit forces.
constexpr double kNoTorque = 1e-12;

/// Shares of a row that are no more than rounding [1].
constexpr double kForceRounding = 1e-8;

/// A coordinate presses where its normal lever is no less than this share of its longest, and than
/// half of the best such share among all coordinates [1].
constexpr double kAlong = 1e-3, kAsWell = 0.5;

/// Which coordinates do work on forces that cancel out on the object. Others, like an arm's, move
/// all contacts as one body would.
std::vector<bool> squeezing(const WrenchSet& set, const MatrixXd& T) {
  std::vector<bool> squeezing(static_cast<std::size_t>(T.rows()), false);
  if (T.size() == 0) return squeezing;
  Eigen::ColPivHouseholderQR<MatrixXd> qr(free_forces(set).wrench.transpose());
  qr.setThreshold(kForceRounding);
  const MatrixXd Q = qr.householderQ() * MatrixXd::Identity(T.cols(), qr.rank());
  const MatrixXd internal = T - (T * Q) * Q.transpose();
  for (Index j = 0; j < T.rows(); ++j)
    squeezing[static_cast<std::size_t>(j)] =
        internal.row(j).norm() > kForceRounding * T.row(j).norm();
  return squeezing;
}

/// One contact, as its joints feel it: torques (coordinates, size).
class OneContact {
 public:
  OneContact(const MatrixXd& torques, const Reactions& reactions,
             const std::vector<bool>& squeezing, double zero)
      : torques_(torques), reactions_(reactions), squeezing_(squeezing), zero_(zero) {
    for (Index j = 0; j < torques.rows(); ++j)
      if (!is_locked(reactions, j)) least_along_ = std::max(least_along_, kAsWell * along(j));
  }

  [[nodiscard]] ContactSupport contact_support() const {
    ContactSupport found{SupportKind::kStructure, -1, 0, torques_.cols(),
                         VectorXd::Zero(torques_.rows())};
    for (const int j : reactions_.non_backdrivable)
      if (along(j) >= least_along_)
        found.pressing_coordinate = std::max(found.pressing_coordinate, j);
    if (found.pressing_coordinate < 0)
      for (const int j : reactions_.non_backdrivable)
        if (feels(j)) found.pressing_coordinate = std::max(found.pressing_coordinate, j);
    bool pressed = false;
    for (Index j = 0; j < torques_.rows(); ++j) {
      if (!presses(j, found.pressing_coordinate)) continue;
      found.levers(j) = std::copysign(longest_lever(j), torques_(j, 0));
      pressed = true;
    }
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
  /// How much of what a coordinate does here is along the normal [1]; 0 if it squeezes nothing.
  [[nodiscard]] double along(Index j) const {
    if (!squeezing_[static_cast<std::size_t>(j)] || !feels(j)) return 0;
    return std::abs(torques_(j, 0)) / longest_lever(j);
  }
  [[nodiscard]] bool is_stopped(Index j) const {
    return along(j) > kAlong && bears_torque(reactions_, j, torques_(j, 0));
  }

  /// Whether the effort at a coordinate presses the contact. @param worm  that does, or -1
  [[nodiscard]] bool presses(Index j, int worm) const {
    if (along(j) < least_along_ || is_locked(reactions_, j)) return false;
    const auto& non_backdrivable = reactions_.non_backdrivable;
    if (std::find(non_backdrivable.begin(), non_backdrivable.end(), j) != non_backdrivable.end())
      return j == worm;
    return !is_stopped(j);
  }

  /// Of the coordinates on stops that the normal force pushes them to, that with the longest lever.
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
  double zero_, least_along_ = kAlong;
};

/// Splits the forces of one contact between what is pressed and what is passive_contacts.
void split(JointLoads& joint_loads, const std::vector<int>& non_backdrivable,
           const ContactSupport& contact_support) {
  VectorXd passive_contacts = joint_loads.x.col(contact_support.first);
  for (const int j : non_backdrivable) {
    passive_contacts(j) = 0;
    if (j != contact_support.pressing_coordinate)
      joint_loads.x.row(j).segment(contact_support.first, contact_support.size).setZero();
  }
  joint_loads.p.conservativeResize(joint_loads.x.rows(), joint_loads.p.cols() + 1);
  joint_loads.p.rightCols(1) = passive_contacts;
}

}  // namespace

JointLoads find_contact_support(const WrenchSet& set, const MatrixXd& T,
                                const Reactions& reactions) {
  const double zero = T.size() > 0 ? kNoTorque * T.cwiseAbs().maxCoeff() : 0;
  const std::vector<bool> does_work = squeezing(set, T);
  JointLoads joint_loads{T, MatrixXd(T.rows(), 0), {}, {}, {}};
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

/// Rows over y = (x, p, v, r, s); s is left out where nothing off the stops presses.
class Limits {
 public:
  Limits(ForceSet forces, const JointLoads& joint_loads, const Actuation& actuation)
      : forces_(std::move(forces)),
        joint_loads_(joint_loads),
        actuation_(actuation),
        s_(forces_.wrench.cols()) {
    clutches_ = reactions_on(actuation.reactions, joint_loads.rows);
    for (Index i = 0; i < clutches_.cols(); ++i)
      if (!std::isfinite(actuation.reactions.least(i)) ||
          !std::isfinite(actuation.reactions.most(i)))
        clutches_.col(i).setZero();

    const bool pushed = count(SupportKind::kEffort) + count(SupportKind::kNonBackdrivable) > 0;
    widen(forces_, pushed ? count(SupportKind::kJointLimit) : 0);
    pressed_ = sum_of(SupportKind::kEffort) + sum_of(SupportKind::kNonBackdrivable);
    by_stops_ = none();
    for (Index i = 0; s_ + i < forces_.wrench.cols(); ++i) by_stops_(s_ + i) = 1;
  }

  ForceSet limited() {
    for (const int j : joint_loads_.rows)
      for (const double way : {1.0, -1.0}) keep_within_efforts(j, way);
    push_back();
    if (count(SupportKind::kJointLimit) == 0) return forces_;
    ForceSet idle = forces_;
    for (const auto& [j, way] : pressers()) largest(j, way) < 0 ? leave(j) : press(j, way);
    if (is_slack() ||
        minimum_grasp_force(forces_, ScaledWrench::Zero(), GraspForceObjective::kSum).status !=
            ConeStatus::kInfeasible)
      return forces_;
    // No effort keeps the hand in balance and off its stops: they are not pressed.
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

  /// Coordinates on stops whose efforts press, and the way off the stop.
  [[nodiscard]] std::map<int, double> pressers() const {
    std::map<int, double> ways;
    for (const ContactSupport& contact : joint_loads_.contacts)
      if (contact.by == SupportKind::kJointLimit)
        ways[contact.pressing_coordinate] =
            joint_loads_.x(contact.pressing_coordinate, contact.first) > 0 ? 1 : -1;
    return ways;
  }

  /// Whether no effort at all is among the efforts, and keeps the hand in balance.
  [[nodiscard]] bool is_slack() const {
    return actuation_.tau_0.isZero(0) && (actuation_.lower.array() <= 0).all() &&
           (actuation_.upper.array() >= 0).all();
  }

  /// Largest torque of efforts and clutches at a coordinate, in one way.
  [[nodiscard]] double largest(int j, double way) const {
    double sum = way * actuation_.tau_0(j);
    const auto add = [&](double torque, double least, double most) {
      if (torque != 0) sum += std::max(torque * least, torque * most);
    };
    for (Index k = 0; k < actuation_.B.cols(); ++k)
      add(way * actuation_.B(j, k), actuation_.lower(k), actuation_.upper(k));
    for (Index i = 0; i < clutches_.cols(); ++i)
      add(way * clutches_(row_of(j), i), actuation_.reactions.least(i),
          actuation_.reactions.most(i));
    return sum;
  }

  /// sum l_i x_i0 <= largest torque, of contacts that push a coordinate back the same way.
  void keep_within_efforts(int j, double way) {
    RowVectorXd row = none();
    for (const ContactSupport& contact : joint_loads_.contacts)
      if (contact.by == SupportKind::kEffort || contact.by == SupportKind::kNonBackdrivable)
        row(contact.first) = std::max(0.0, way * contact.levers(j));
    const double longest = row.maxCoeff(), limit = std::max(0.0, largest(j, way));
    if (longest > 0 && std::isfinite(limit))
      add_rows(forces_, row / longest, VectorXd::Constant(1, limit / longest));
  }

  /// 0 <= s_i <= x_i0, and the sums of what pushes back.
  void push_back() {
    Index s = s_;
    for (const ContactSupport& contact : joint_loads_.contacts) {
      if (contact.by != SupportKind::kJointLimit || s == forces_.wrench.cols()) continue;
      add_rows(forces_, -unit(s), VectorXd::Zero(1));
      add_rows(forces_, unit(s++) - unit(contact.first), VectorXd::Zero(1));
    }
    if (s > s_) add_rows(forces_, by_stops_ - pressed_, VectorXd::Zero(1));
    if (count(SupportKind::kStructure) > 0)
      add_rows(forces_,
               sum_of(SupportKind::kStructure) + 2 * by_stops_ - sum_of(SupportKind::kJointLimit) -
                   pressed_,
               VectorXd::Zero(1));
  }

  /// The a_i = x_i0 - s_i of contacts on the stop of a coordinate, by their levers.
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

  /// sum |T_j n_i| a_i <= B_j u + R_j r + tau_0j, r of clutches, in the way off the stop.
  void press(int j, double way) {
    RowVectorXd row = pressed_at(j);
    const Index v = joint_loads_.x.cols() + joint_loads_.p.cols(), r = v + actuation_.B.cols();
    row.segment(v, actuation_.B.cols()) =
        -way * actuation_.B.row(j).cwiseProduct(forces_.effort_unit.transpose());
    row.segment(r, clutches_.cols()) = -way * clutches_.row(row_of(j));
    const double size = row.cwiseAbs().maxCoeff();
    add_rows(forces_, row / size, VectorXd::Constant(1, way * actuation_.tau_0(j) / size));
  }

  /// Springs hold it on its stop whatever the efforts do: a = 0.
  void leave(int j) {
    const RowVectorXd row = pressed_at(j);
    add_rows(forces_, row / row.cwiseAbs().maxCoeff(), VectorXd::Zero(1));
  }

  ForceSet forces_;
  const JointLoads& joint_loads_;
  const Actuation& actuation_;
  Eigen::MatrixXd
      clutches_;  // rows of limited reactions, zeros for others (rows joint_loads, reactions)
  Index s_;       // first of s
  RowVectorXd pressed_;   // sums the normal forces that joints off their stops press
  RowVectorXd by_stops_;  // sums s
};

}  // namespace

ForceSet limit_preload(ForceSet forces, const JointLoads& joint_loads, const Actuation& actuation) {
  return Limits(std::move(forces), joint_loads, actuation).limited();
}

}  // namespace thenar::internal
