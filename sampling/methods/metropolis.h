#pragma once

/// Base class of samplers that only compare densities and need no gradient.

#include <vector>

#include "base/random_stream.h"
#include "sampling/methods/sampler.h"

namespace thenar::internal {

/// Chains that propose a point, compare densities, and accept or stay.
///
/// A step has one or more rounds, each of which proposes for some of the chains at once. A chain at
/// zero density stays until a proposal has positive density, and accepts it whatever its value; it
/// does not adapt until then.
class Metropolis : public Sampler {
 public:
  Metropolis(const Eigen::MatrixXd& starts, SamplerOptions options);

  [[nodiscard]] int chains() const final { return static_cast<int>(x_.cols()); }
  [[nodiscard]] WithGradient wants() const final { return WithGradient::kNo; }
  [[nodiscard]] const Eigen::MatrixXd& asks() const final { return proposals_.x; }
  void tell(const Densities& at) final;
  [[nodiscard]] long steps() const final { return steps_; }
  [[nodiscard]] const Eigen::MatrixXd& positions() const final { return x_; }
  [[nodiscard]] const std::vector<StepStats>& stats() const final { return stats_; }
  void move(int chain, const Eigen::VectorXd& x, const Densities& at) final;
  [[nodiscard]] Densities density(int chain) const final;
  void set_beta(double beta) final;
  void save(StateWriter& to) const final;
  void restore(StateReader& from) final;

 protected:
  struct Proposals {
    std::vector<int> chain;              // chain of each proposal (points)
    Eigen::MatrixXd x;                   // proposed positions (n, points)
    Eigen::VectorXd log_proposal_ratio;  // log q(x | x') - log q(x' | x) [1] (points)
  };

  /// Returns the proposals of one round, which depend only on the state between steps and on
  /// earlier rounds.
  [[nodiscard]] virtual Proposals propose(int round) = 0;
  /// Returns the number of rounds of a step.
  [[nodiscard]] virtual int rounds() const { return 1; }
  /// Adapts the proposals after a step of warm-up. @param before  positions at its start (n,
  /// chains)
  virtual void learn(const Eigen::MatrixXd& before) { (void)before; }
  virtual void save_learnt(StateWriter& to) const { (void)to; }
  virtual void restore_learnt(StateReader& from) { (void)from; }

  [[nodiscard]] const SamplerOptions& options() const { return options_; }
  [[nodiscard]] int size() const { return static_cast<int>(x_.rows()); }
  [[nodiscard]] bool has_density(int chain) const;  // the density is not zero
  /// Returns the random stream of a chain's current step.
  [[nodiscard]] RandomStream random(int chain, std::uint32_t purpose) const;

 private:
  void begin(const Densities& at);
  void decide(const Densities& at, Eigen::Index point);

  SamplerOptions options_;
  Eigen::MatrixXd x_, before_;          // positions now, and at the start of the step (n, chains)
  Eigen::VectorXd prior_, likelihood_;  // log prior and log likelihood at x_ (chains)
  Eigen::VectorXd value_;               // log of the tempered density at x_ (chains)
  std::vector<StepStats> stats_;
  Proposals proposals_;  // current proposals; the starting points until their densities are known
  long steps_ = 0;       // completed steps
  int round_ = 0;        // current round of the step
  bool begun_ = false;   // the densities of the starting points are known
};

/// Returns the Cholesky factor L of the initial covariance C = L L'; the identity if none is given
/// (n, n).
/// @throws InputError if the covariance is not positive definite.
[[nodiscard]] Eigen::MatrixXd initial_covariance_factor(const SamplerOptions& options, int size);

}  // namespace thenar::internal
