#include "grasp/quality/pressed.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "grasp/quality/force_rows.h"
#include "grasp/quality/hold_force.h"
#include "grasp/quality/stops.h"

namespace thenar::internal {
namespace {

using Eigen::Index;
using Eigen::RowVectorXd;
using Eigen::VectorXd;

/// Rows over y = (x, p, v, r, s); s is left out where nothing off the stops presses.
class Limits {
 public:
  Limits(ForceSet forces, const Felt& felt, const Actuation& actuation)
      : forces_(std::move(forces)), felt_(felt), actuation_(actuation), s_(forces_.wrench.cols()) {
    clutches_ = reactions_on(actuation.reactions, felt.rows);
    for (Index i = 0; i < clutches_.cols(); ++i)
      if (!std::isfinite(actuation.reactions.least(i)) ||
          !std::isfinite(actuation.reactions.most(i)))
        clutches_.col(i).setZero();

    const bool pushed = count(Carrier::kEffort) + count(Carrier::kWorm) > 0;
    widen(forces_, pushed ? count(Carrier::kStop) : 0);
    pressed_ = sum_of(Carrier::kEffort) + sum_of(Carrier::kWorm);
    by_stops_ = none();
    for (Index i = 0; s_ + i < forces_.wrench.cols(); ++i) by_stops_(s_ + i) = 1;
  }

  ForceSet limited() {
    for (const int j : felt_.rows)
      for (const double way : {1.0, -1.0}) keep_within_efforts(j, way);
    push_back();
    if (count(Carrier::kStop) == 0) return forces_;
    ForceSet idle = forces_;
    for (const auto& [j, way] : pressers()) largest(j, way) < 0 ? leave(j) : press(j, way);
    if (is_slack() ||
        smallest_hold(forces_, Wrench::Zero(), Squeeze::kSum).status != ConeStatus::kInfeasible)
      return forces_;
    // No effort keeps the hand in balance and off its stops: they are not pressed.
    add_rows(idle, sum_of(Carrier::kStop) - by_stops_, VectorXd::Zero(1));
    return idle;
  }

 private:
  [[nodiscard]] RowVectorXd none() const { return RowVectorXd::Zero(forces_.wrench.cols()); }
  [[nodiscard]] RowVectorXd unit(Index i) const {
    return RowVectorXd::Unit(forces_.wrench.cols(), i);
  }

  [[nodiscard]] Index row_of(int j) const {
    return std::lower_bound(felt_.rows.begin(), felt_.rows.end(), j) - felt_.rows.begin();
  }

  [[nodiscard]] Index count(Carrier carrier) const {
    return std::count_if(felt_.contacts.begin(), felt_.contacts.end(),
                         [&](const Carried& contact) { return contact.by == carrier; });
  }

  [[nodiscard]] RowVectorXd sum_of(Carrier carrier) const {
    RowVectorXd sum = none();
    for (const Carried& contact : felt_.contacts)
      if (contact.by == carrier) sum(contact.first) = 1;
    return sum;
  }

  /// Coordinates on stops whose efforts press, and the way off the stop.
  [[nodiscard]] std::map<int, double> pressers() const {
    std::map<int, double> ways;
    for (const Carried& contact : felt_.contacts)
      if (contact.by == Carrier::kStop)
        ways[contact.presser] = felt_.x(contact.presser, contact.first) > 0 ? 1 : -1;
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
    for (const Carried& contact : felt_.contacts)
      if (contact.by == Carrier::kEffort || contact.by == Carrier::kWorm)
        row(contact.first) = std::max(0.0, way * contact.levers(j));
    const double longest = row.maxCoeff(), limit = std::max(0.0, largest(j, way));
    if (longest > 0 && std::isfinite(limit))
      add_rows(forces_, row / longest, VectorXd::Constant(1, limit / longest));
  }

  /// 0 <= s_i <= x_i0, and the sums of what pushes back.
  void push_back() {
    Index s = s_;
    for (const Carried& contact : felt_.contacts) {
      if (contact.by != Carrier::kStop || s == forces_.wrench.cols()) continue;
      add_rows(forces_, -unit(s), VectorXd::Zero(1));
      add_rows(forces_, unit(s++) - unit(contact.first), VectorXd::Zero(1));
    }
    if (s > s_) add_rows(forces_, by_stops_ - pressed_, VectorXd::Zero(1));
    if (count(Carrier::kStructure) > 0)
      add_rows(forces_,
               sum_of(Carrier::kStructure) + 2 * by_stops_ - sum_of(Carrier::kStop) - pressed_,
               VectorXd::Zero(1));
  }

  /// The a_i = x_i0 - s_i of contacts on the stop of a coordinate, by their levers.
  [[nodiscard]] RowVectorXd pressed_at(int j) const {
    RowVectorXd row = none();
    Index s = s_;
    for (const Carried& contact : felt_.contacts) {
      if (contact.by != Carrier::kStop) continue;
      const double lever = contact.presser == j ? std::abs(felt_.x(j, contact.first)) : 0;
      row(contact.first) = lever;
      if (s < row.size()) row(s++) = -lever;
    }
    return row;
  }

  /// sum |T_j n_i| a_i <= B_j u + R_j r + tau_0j, r of clutches, in the way off the stop.
  void press(int j, double way) {
    RowVectorXd row = pressed_at(j);
    const Index v = felt_.x.cols() + felt_.p.cols(), r = v + actuation_.B.cols();
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
  const Felt& felt_;
  const Actuation& actuation_;
  Eigen::MatrixXd clutches_;  // rows of limited reactions, zeros for others (rows felt, reactions)
  Index s_;                   // first of s
  RowVectorXd pressed_;       // sums the normal forces that joints off their stops press
  RowVectorXd by_stops_;      // sums s
};

}  // namespace

ForceSet limit_pressing(ForceSet forces, const Felt& felt, const Actuation& actuation) {
  return Limits(std::move(forces), felt, actuation).limited();
}

}  // namespace thenar::internal
