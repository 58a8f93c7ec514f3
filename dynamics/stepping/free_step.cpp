#include "dynamics/stepping/free_step.h"

namespace thenar {
namespace {

constexpr std::size_t kStages = FreeStep::kStages;

constexpr std::array<double, kStages> kNodes{
    0, 2.0 / 27, 1.0 / 9, 1.0 / 6, 5.0 / 12, 1.0 / 2, 5.0 / 6, 1.0 / 6, 2.0 / 3, 1.0 / 3, 1, 0, 1};

constexpr std::array<std::array<double, kStages - 1>, kStages> kStage{{
    {},
    {2.0 / 27},
    {1.0 / 36, 1.0 / 12},
    {1.0 / 24, 0, 1.0 / 8},
    {5.0 / 12, 0, -25.0 / 16, 25.0 / 16},
    {1.0 / 20, 0, 0, 1.0 / 4, 1.0 / 5},
    {-25.0 / 108, 0, 0, 125.0 / 108, -65.0 / 27, 125.0 / 54},
    {31.0 / 300, 0, 0, 0, 61.0 / 225, -2.0 / 9, 13.0 / 900},
    {2, 0, 0, -53.0 / 6, 704.0 / 45, -107.0 / 9, 67.0 / 90, 3},
    {-91.0 / 108, 0, 0, 23.0 / 108, -976.0 / 135, 311.0 / 54, -19.0 / 60, 17.0 / 6, -1.0 / 12},
    {2383.0 / 4100, 0, 0, -341.0 / 164, 4496.0 / 1025, -301.0 / 82, 2133.0 / 4100, 45.0 / 82,
     45.0 / 164, 18.0 / 41},
    {3.0 / 205, 0, 0, 0, 0, -6.0 / 41, -3.0 / 205, -3.0 / 41, 3.0 / 41, 6.0 / 41, 0},
    {-1777.0 / 4100, 0, 0, -341.0 / 164, 4496.0 / 1025, -289.0 / 82, 2193.0 / 4100, 51.0 / 82,
     33.0 / 164, 12.0 / 41, 0, 1},
}};

constexpr std::array<double, kStages> kWeights{
    0, 0, 0, 0, 0, 34.0 / 105, 9.0 / 35, 9.0 / 35, 9.0 / 280, 9.0 / 280, 0, 41.0 / 840, 41.0 / 840};

constexpr double kErrorWeight = 41.0 / 840;  // of k_1 + k_11 - k_12 - k_13, the error of order 7

using Rates = std::array<Eigen::VectorXd, kStages>;

double error_of(const Rates& k) {
  if (k[0].size() == 0) return 0;
  return kErrorWeight * (k[0] + k[10] - k[11] - k[12]).cwiseAbs().maxCoeff();
}

}  // namespace

FreeStep::FreeStep(const SceneState& start) {
  q_rate_.fill(Eigen::VectorXd::Zero(start.q.size()));
  v_rate_.fill(Eigen::VectorXd::Zero(start.v.size()));
  z_rate_.fill(Eigen::VectorXd::Zero(start.z.size()));
}

FreeStep::Error FreeStep::step(ContactStep& scene, double h, SceneState& state) {
  bool acted = true;
  for (std::size_t i = 0; i < kStages; ++i) {
    at_.t = state.t + kNodes[i] * h;
    at_.q = state.q;
    at_.v = state.v;
    at_.z = state.z;
    for (std::size_t j = 0; j < i; ++j) {
      if (kStage[i][j] == 0) continue;
      at_.q += (h * kStage[i][j]) * q_rate_[j];
      at_.v += (h * kStage[i][j]) * v_rate_[j];
      at_.z += (h * kStage[i][j]) * z_rate_[j];
    }
    acted = scene.free_rates(at_, q_rate_[i], v_rate_[i], z_rate_[i]) && acted;
  }
  for (std::size_t i = 0; i < kStages; ++i) {
    state.q += (h * kWeights[i]) * q_rate_[i];
    state.v += (h * kWeights[i]) * v_rate_[i];
    state.z += (h * kWeights[i]) * z_rate_[i];
  }
  scene.normalise(state.q);
  state.t += h;
  return {h * error_of(q_rate_), h * error_of(v_rate_), h * error_of(z_rate_), acted};
}

}  // namespace thenar
