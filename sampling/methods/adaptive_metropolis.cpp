#include <cmath>

#include "sampling/methods/saved_shape.h"

#include "sampling/methods/metropolis.h"

namespace thenar::internal {
namespace {

constexpr std::uint32_t kProposalStream = 0;  // purpose of the random stream of proposals
// Optimal acceptance rate in many dimensions [1] [Roberts1997]
constexpr double kBestAcceptance = 0.234;

/// Shape of the target estimated by one chain.
struct ProposalShape {
  Eigen::VectorXd mean;  // mean of past states (n)
  Eigen::MatrixXd L;     // Cholesky factor of the covariance L L' (n, n)
  double log_scale;      // logarithm of the proposal scale relative to L [1]
};

/// Updates L to the Cholesky factor of L L' + v v' by one rotation per column.
void add_square(Eigen::MatrixXd& L, Eigen::VectorXd v) {
  for (Eigen::Index k = 0; k < v.size(); ++k) {
    const double r = std::hypot(L(k, k), v[k]), c = L(k, k) / r, s = v[k] / r;
    const Eigen::Index below = v.size() - k - 1;
    L(k, k) = r;
    const Eigen::VectorXd column = L.col(k).tail(below);
    L.col(k).tail(below) = c * column + s * v.tail(below);
    v.tail(below) = c * v.tail(below) - s * column;
  }
}

/// Adaptive Metropolis sampler with normal proposals  x' = x + s L w,  w ~ N(0, I). L L' is the
/// covariance of the chain's past [Haario2001], and s is adapted by a Robbins-Monro search for the
/// target acceptance, both as in [Andrieu2008, algorithm 4]. Every chain adapts separately.
///
/// Differences: the weight of step t in the covariance is 2 / (t + 10 n), so that early steps are
/// forgotten as 1 / t^2, and the initial covariance counts for the first 10 n steps; adaptation
/// ends after warm-up.
class AdaptiveMetropolis final : public Metropolis {
 public:
  AdaptiveMetropolis(const Eigen::MatrixXd& starts, const SamplerOptions& options)
      : Metropolis(starts, options) {
    const double scale =
        2.38 / std::sqrt(double(size()));  // optimal for a normal target [Roberts1997]
    for (int k = 0; k < chains(); ++k)
      shapes_.push_back(
          {starts.col(k), initial_covariance_factor(options, size()), std::log(scale)});
  }

 private:
  Proposals propose(int /*round*/) override {
    Proposals to{{}, positions(), Eigen::VectorXd::Zero(chains())};
    for (int k = 0; k < chains(); ++k) {
      // Take a normal step with the estimated covariance.
      const ProposalShape& shape = shapes_[static_cast<std::size_t>(k)];
      RandomStream draw = random(k, kProposalStream);
      Eigen::VectorXd w(size());
      for (double& entry : w) entry = draw.normal();
      to.chain.push_back(k);
      to.x.col(k) += shape.L.triangularView<Eigen::Lower>() * (std::exp(shape.log_scale) * w);
    }
    return to;
  }

  void learn(const Eigen::MatrixXd& /*before*/) override {
    // Weights decrease with the steps.
    const double t = double(steps()) + 1;
    const double weight = 2 / (t + 10 * size()), gain = std::pow(t, -0.6);
    const double target =
        options().target_acceptance > 0 ? options().target_acceptance : kBestAcceptance;
    for (int k = 0; k < chains(); ++k) {
      if (!has_density(k)) continue;
      ProposalShape& shape = shapes_[static_cast<std::size_t>(k)];
      // Update mean and covariance of the chain's past.
      const Eigen::VectorXd off = positions().col(k) - shape.mean;
      shape.mean += weight * off;
      // Update C to (1 - weight) C + weight off off'.
      shape.L *= std::sqrt(1 - weight);
      add_square(shape.L, std::sqrt(weight) * off);
      // Increase the scale if the acceptance is above the target.
      shape.log_scale += gain * (stats()[static_cast<std::size_t>(k)].acceptance - target);
    }
  }

  void save_learnt(StateWriter& to) const override {
    for (const ProposalShape& shape : shapes_) {
      to.write(shape.mean);
      to.write(shape.L);
      to.write(shape.log_scale);
    }
  }

  void restore_learnt(StateReader& from) override {
    for (ProposalShape& shape : shapes_) {
      shape.mean = saved_vector(from, "mean of a chain", size());
      shape.L = saved_matrix(from, "covariance factor of a chain", size(), size());
      shape.log_scale = from.number();
    }
  }

  std::vector<ProposalShape> shapes_;  // (chains)
};

}  // namespace

std::unique_ptr<Sampler> adaptive_metropolis(const Eigen::MatrixXd& starts,
                                             const SamplerOptions& options) {
  return std::make_unique<AdaptiveMetropolis>(starts, options);
}

}  // namespace thenar::internal
