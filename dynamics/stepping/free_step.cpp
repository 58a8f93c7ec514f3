#include "dynamics/stepping/free_step.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace thenar {
namespace {

using Eigen::Index;

constexpr Index kSumLanes = 8;  // numbers that a sum of rates holds in registers
using Lanes = Eigen::Matrix<double, kSumLanes, 1>;
using Weights = std::array<double, FreeStep::kStages>;

/// Sum of the rates of some stages, by weights: rows of a block. @param rates  its first column
Lanes weighted_sum(const Weights& weights, std::size_t stages, const double* rates, Index rows) {
  Lanes sum = Lanes::Zero();
  for (std::size_t j = 0; j < stages; ++j, rates += rows)
    if (weights[j] != 0) sum += weights[j] * Eigen::Map<const Lanes>(rates);
  return sum;
}

}  // namespace

FreeStep::FreeStep(const ContactStep& scene)
    : flows_(scene.free_flows()), at_(scene.start()), first_(at_) {
  q_dot_ = Eigen::VectorXd::Zero(at_.q.size());
  v_dot_ = Eigen::VectorXd::Zero(at_.v.size());
  z_dot_ = Eigen::VectorXd::Zero(at_.z.size());
  const Index size = at_.q.size() + at_.v.size() + at_.z.size() + flows_;
  const Index rows = (size + kSumLanes - 1) / kSumLanes * kSumLanes;
  rates_.setZero(rows, static_cast<Index>(kStages));
  begin_ = y_ = five_ = three_ = Eigen::VectorXd::Zero(rows);
  first_.t = std::numeric_limits<double>::quiet_NaN();
}

void FreeStep::put(const Eigen::VectorXd& y) {
  const Index q = at_.q.size(), v = at_.v.size();
  at_.q = y.head(q);
  at_.v = y.segment(q, v);
  at_.z = y.segment(q + v, at_.z.size());
}

bool FreeStep::find_rates(ContactStep& scene, Index stage) {
  const bool acted = scene.free_rates(at_, q_dot_, v_dot_, z_dot_);
  const Index q = q_dot_.size(), v = v_dot_.size();
  auto column = rates_.col(stage);
  column.head(q) = q_dot_;
  column.segment(q, v) = v_dot_;
  column.segment(q + v, z_dot_.size()) = z_dot_;
  if (flows_ > 0) column.segment(q + v + z_dot_.size(), flows_) = scene.free_powers();
  return acted;
}

double FreeStep::error_of(Index first, Index count) const {
  if (count == 0) return 0;
  // Error of order five, reduced by that of order three [Hairer1993].
  const double five = five_.segment(first, count).cwiseAbs().maxCoeff();
  const double three = three_.segment(first, count).cwiseAbs().maxCoeff();
  return five > 0 ? five * five / std::sqrt(five * five + 0.01 * three * three) : five;
}

FreeStep::Error FreeStep::step(ContactStep& scene, double h, SceneState& state) {
  using Method = DormandPrince;
  const Index q = state.q.size(), v = state.v.size(), z = state.z.size(), rows = rates_.rows();
  begin_.head(q + v + z + flows_) << state.q, state.v, state.z, state.w.head(flows_);
  // A rejected step from the same state has found the first stage.
  if (!(first_.t == state.t && first_.q == state.q && first_.v == state.v && first_.z == state.z)) {
    first_ = at_ = state;
    first_acted_ = find_rates(scene, 0);
  }
  bool acted = first_acted_;
  // Stages  k_i = f(t + c_i h, y + h sum_j a_ij k_j).
  for (std::size_t i = 1; i < kStages; ++i) {
    for (Index k = 0; k < rows; k += kSumLanes)
      y_.segment<kSumLanes>(k) =
          begin_.segment<kSumLanes>(k) + h * weighted_sum(Method::a[i], i, rates_.data() + k, rows);
    at_.t = state.t + Method::c[i] * h;
    put(y_);
    acted = find_rates(scene, static_cast<Index>(i)) && acted;
  }
  // End of order eight, and the differences to orders five and three.
  for (Index k = 0; k < rows; k += kSumLanes) {
    const double* rates = rates_.data() + k;
    const Lanes eight = weighted_sum(Method::b, kStages, rates, rows);
    five_.segment<kSumLanes>(k) = weighted_sum(Method::less_five, kStages, rates, rows);
    three_.segment<kSumLanes>(k) = eight - weighted_sum(Method::three, kStages, rates, rows);
    y_.segment<kSumLanes>(k) = begin_.segment<kSumLanes>(k) + h * eight;
  }
  // State at the end.
  put(y_);
  state.q = at_.q;
  state.v = at_.v;
  state.z = at_.z;
  state.w.head(flows_) = y_.segment(q + v + z, flows_);
  scene.normalise(state.q);
  state.t += h;
  // The work of elements, the last state, steers nothing.
  return {h * error_of(0, q), h * error_of(q, v), h * error_of(q + v, std::max<Index>(z - 1, 0)),
          acted};
}

}  // namespace thenar
