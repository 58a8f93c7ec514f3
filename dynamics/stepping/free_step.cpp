#include "dynamics/stepping/free_step.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace thenar {
namespace {

using Eigen::Index;
using Coefficients = Eigen::Map<const Eigen::Matrix<double, FreeStep::kStages, 1>>;

Coefficients coefficients(const std::array<double, FreeStep::kStages>& of) {
  return Coefficients(of.data());
}

}  // namespace

FreeStep::FreeStep(const ContactStep& scene)
    : flows_(scene.free_flows()), at_(scene.start()), first_(at_) {
  q_dot_ = Eigen::VectorXd::Zero(at_.q.size());
  v_dot_ = Eigen::VectorXd::Zero(at_.v.size());
  z_dot_ = Eigen::VectorXd::Zero(at_.z.size());
  const Index size = at_.q.size() + at_.v.size() + at_.z.size() + flows_;
  rates_.setZero(size, static_cast<Index>(kStages));
  begin_ = y_ = five_ = three_ = Eigen::VectorXd::Zero(size);
  first_.t = std::numeric_limits<double>::quiet_NaN();
}

void FreeStep::put(const Eigen::VectorXd& y) {
  at_.q = y.head(at_.q.size());
  at_.v = y.segment(at_.q.size(), at_.v.size());
  at_.z = y.segment(at_.q.size() + at_.v.size(), at_.z.size());
}

bool FreeStep::find_rates(ContactStep& scene, Index stage) {
  const bool acted = scene.free_rates(at_, q_dot_, v_dot_, z_dot_);
  rates_.col(stage) << q_dot_, v_dot_, z_dot_, scene.free_powers();
  return acted;
}

double FreeStep::error_of(Index first, Index count) const {
  if (count == 0) return 0;
  const double five = five_.segment(first, count).cwiseAbs().maxCoeff();
  const double three = three_.segment(first, count).cwiseAbs().maxCoeff();
  return five > 0 ? five * five / std::sqrt(five * five + 0.01 * three * three) : five;
}

FreeStep::Error FreeStep::step(ContactStep& scene, double h, SceneState& state) {
  using Method = DormandPrince;
  begin_ << state.q, state.v, state.z, state.w.head(flows_);
  // A rejected step has told the first stage.
  if (!(first_.t == state.t && first_.q == state.q && first_.v == state.v && first_.z == state.z)) {
    first_ = at_ = state;
    first_acted_ = find_rates(scene, 0);
  }
  bool acted = first_acted_;
  for (Index i = 1; i < static_cast<Index>(kStages); ++i) {
    const auto stage = static_cast<std::size_t>(i);
    y_.noalias() = rates_.leftCols(i) * coefficients(Method::a[stage]).head(i);
    y_ = begin_ + h * y_;
    at_.t = state.t + Method::c[stage] * h;
    put(y_);
    acted = find_rates(scene, i) && acted;
  }
  y_.noalias() = rates_ * coefficients(Method::b);
  five_.noalias() = rates_ * coefficients(Method::less_five);
  three_ = y_;
  three_.noalias() -= rates_ * coefficients(Method::three);
  y_ = begin_ + h * y_;
  put(y_);
  state.q = at_.q;
  state.v = at_.v;
  state.z = at_.z;
  state.w.head(flows_) = y_.tail(flows_);
  scene.normalise(state.q);
  state.t += h;
  const Index q = state.q.size(), v = state.v.size(), z = state.z.size();
  // The work of elements, the last state, steers nothing.
  return {h * error_of(0, q), h * error_of(q, v), h * error_of(q + v, std::max<Index>(z - 1, 0)),
          acted};
}

}  // namespace thenar
