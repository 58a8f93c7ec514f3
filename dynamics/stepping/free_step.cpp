#include "dynamics/stepping/free_step.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace thenar {
namespace {

using Eigen::Index;

constexpr Index kSumLanes = 8;  // rows of rates that one weighted sum keeps in registers
constexpr double kThirdOrderWeight = 0.01;  // weight of the third-order error estimate [1]
using Lanes = Eigen::Matrix<double, kSumLanes, 1>;
using Weights = std::array<double, FreeStep::kStages>;

/// Computes the weighted sum of the rates of some stages for one block of rows.
/// @param rates  first row of the block in the first column;  @param rows  of all blocks
Lanes weighted_sum(const Weights& weights, std::size_t stages, const double* rates, Index rows) {
  Lanes sum = Lanes::Zero();
  for (std::size_t j = 0; j < stages; ++j, rates += rows)
    if (weights[j] != 0) sum += weights[j] * Eigen::Map<const Lanes>(rates);
  return sum;
}

}  // namespace

FreeStep::FreeStep(const ContactStep& scene)
    : flows_(scene.free_flow_count()), stage_(scene.initial_state()), first_(stage_) {
  q_dot_ = Eigen::VectorXd::Zero(stage_.q.size());
  v_dot_ = Eigen::VectorXd::Zero(stage_.v.size());
  z_dot_ = Eigen::VectorXd::Zero(stage_.z.size());
  const Index size = stage_.q.size() + stage_.v.size() + stage_.z.size() + flows_;
  const Index rows = (size + kSumLanes - 1) / kSumLanes * kSumLanes;
  rates_.setZero(rows, static_cast<Index>(kStages));
  y_begin_ = y_ = error_five_ = error_three_ = Eigen::VectorXd::Zero(rows);
  first_.t = std::numeric_limits<double>::quiet_NaN();
}

void FreeStep::unpack(const Eigen::VectorXd& y) {
  const Index q = stage_.q.size(), v = stage_.v.size();
  stage_.q = y.head(q);
  stage_.v = y.segment(q, v);
  stage_.z = y.segment(q + v, stage_.z.size());
}

bool FreeStep::compute_rates(ContactStep& scene, Index stage) {
  const bool acted = scene.compute_free_rates(stage_, q_dot_, v_dot_, z_dot_);
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
  // Reduce the error of order five by that of order three, as DOP853 does [Hairer1993].
  const double five = error_five_.segment(first, count).cwiseAbs().maxCoeff();
  const double three = error_three_.segment(first, count).cwiseAbs().maxCoeff();
  return five > 0 ? five * five / std::sqrt(five * five + kThirdOrderWeight * three * three) : five;
}

FreeStep::Error FreeStep::take_step(ContactStep& scene, double h, SceneState& state) {
  using Method = DormandPrince;
  const Index q = state.q.size(), v = state.v.size(), z = state.z.size(), rows = rates_.rows();
  y_begin_.head(q + v + z + flows_) << state.q, state.v, state.z, state.w.head(flows_);
  // Reuse the first stage of a step from the same state, which was rejected.
  if (!(first_.t == state.t && first_.q == state.q && first_.v == state.v && first_.z == state.z)) {
    first_ = stage_ = state;
    first_acted_ = compute_rates(scene, 0);
  }
  bool acted = first_acted_;
  // Compute the stages  k_i = f(t + c_i h, y + h sum_j a_ij k_j).
  for (std::size_t i = 1; i < kStages; ++i) {
    for (Index k = 0; k < rows; k += kSumLanes)
      y_.segment<kSumLanes>(k) = y_begin_.segment<kSumLanes>(k) +
                                 h * weighted_sum(Method::a[i], i, rates_.data() + k, rows);
    stage_.t = state.t + Method::c[i] * h;
    unpack(y_);
    acted = compute_rates(scene, static_cast<Index>(i)) && acted;
  }
  // Sum the end of order eight, and its differences from orders five and three.
  for (Index k = 0; k < rows; k += kSumLanes) {
    const double* rates = rates_.data() + k;
    const Lanes eight = weighted_sum(Method::b, kStages, rates, rows);
    error_five_.segment<kSumLanes>(k) = weighted_sum(Method::b_minus_b5, kStages, rates, rows);
    error_three_.segment<kSumLanes>(k) = eight - weighted_sum(Method::b3, kStages, rates, rows);
    y_.segment<kSumLanes>(k) = y_begin_.segment<kSumLanes>(k) + h * eight;
  }
  // Write the state at the end.
  unpack(y_);
  state.q = stage_.q;
  state.v = stage_.v;
  state.z = stage_.z;
  state.w.head(flows_) = y_.segment(q + v + z, flows_);
  scene.normalise_quaternions(state.q);
  state.t += h;
  // Leave the last state, the work of elements, out of the error.
  return {h * error_of(0, q), h * error_of(q, v), h * error_of(q + v, std::max<Index>(z - 1, 0)),
          acted};
}

}  // namespace thenar
