#include "grasp/limits/joint_limits.h"

#include <algorithm>
#include <cmath>

#include "base/lists.h"
#include "base/numbers.h"

namespace thenar {
namespace {

using Eigen::Index;

/// Returns whether the reaction acts on this coordinate alone.
bool is_own(const Reactions& reactions, Index i, Index coordinate) {
  const double own = std::abs(reactions.R(coordinate, i));
  return own > 0 && own == reactions.R.col(i).cwiseAbs().sum();
}

}  // namespace

void add_reaction(Reactions& reactions, const Eigen::VectorXd& torque, double lower, double upper) {
  append_column(reactions.R, torque);
  append_entry(reactions.lower, lower);
  append_entry(reactions.upper, upper);
}

Actuation actuation_with_joint_limits(const Hand& hand, const Eigen::VectorXd& q) {
  const HandLayout& layout = hand.layout();
  Actuation actuation = hand.actuation(q);
  for (Index j = 0; j < q.size(); ++j) {
    // A joint limit pushes towards the inside of the range with any magnitude.
    const Eigen::VectorXd torque = Eigen::VectorXd::Unit(q.size(), j);
    if (q[j] <= layout.lower[j] + kLimitTolerance)
      add_reaction(actuation.reactions, torque, 0, kInfinity);
    if (q[j] >= layout.upper[j] - kLimitTolerance)
      add_reaction(actuation.reactions, -torque, 0, kInfinity);
  }
  return actuation;
}

Eigen::MatrixXd reactions_on(const Reactions& reactions, const std::vector<int>& coordinates) {
  const Index count = reactions.lower.size();
  if (count == 0) return Eigen::MatrixXd(coordinates.size(), 0);
  Eigen::MatrixXd rows = reactions.R(coordinates, Eigen::all);
  for (Index i = 0; i < count; ++i) {
    // Find the innermost coordinate on which the reaction acts.
    int innermost = 0;
    while (innermost + 1 < reactions.R.rows() && reactions.R(innermost, i) == 0) ++innermost;
    // A non-backdrivable drive already supports what a joint limit of its coordinate would.
    const bool stops = reactions.lower(i) == 0 && reactions.upper(i) == kInfinity;
    const bool worm =
        stops && contains(reactions.non_backdrivable, innermost) && is_own(reactions, i, innermost);
    if (worm || !std::binary_search(coordinates.begin(), coordinates.end(), innermost))
      rows.col(i).setZero();
  }
  return rows;
}

bool resists_torque(const Reactions& reactions, Index coordinate, double direction) {
  for (Index i = 0; i < reactions.lower.size(); ++i) {
    // End of the reaction's range in the given direction.
    const bool up = (reactions.R(coordinate, i) > 0) == (direction > 0);
    const double limit = up ? reactions.upper(i) : -reactions.lower(i);
    if (limit == kInfinity && is_own(reactions, i, coordinate)) return true;
  }
  return false;
}

bool is_locked(const Reactions& reactions, Index coordinate) {
  return resists_torque(reactions, coordinate, 1) && resists_torque(reactions, coordinate, -1);
}

}  // namespace thenar
