#pragma once

/// Markov chains as machines that ask for densities, so that many may share one evaluation.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "sampling/methods/state_bytes.h"
#include "sampling/methods/target.h"

namespace thenar {

/// What one step of one chain was like.
struct StepStats {
  double log_prior = 0;       // at the new position [1]
  double log_likelihood = 0;  // at the new position, not tempered [1]
  double acceptance = 0;      // probability of acceptance, mean over the step's proposals, 0..1
  double step_size = 0;       // of the leapfrog; 0 for samplers without one [1]
  double energy = 0;          // Hamiltonian at the new position; 0 without one [1]
  int depth = 0;              // of the tree of NUTS [1]
  int evaluations = 0;        // densities asked for, by this chain: hotter ones not counted [1]
  int non_finite = 0;         // of them: NaN or +inf [1]
  bool divergent = false;     // the energy error of a trajectory exceeded 1000
};

/// One chain, or several that advance together (walkers of an ensemble). The driver evaluates
/// what it asks for and tells it, until it has made as many steps as are wanted. Every draw is a
/// function of the seed, the chain's number and the step alone. Streams of random numbers count
/// steps in 32 bits: a chain makes fewer than 2^32 (4.3e9) of them.
///
/// A density of NaN or +inf counts as zero and is counted in StepStats::non_finite.
class Sampler {
 public:
  virtual ~Sampler() = default;

  [[nodiscard]] virtual int chains() const = 0;
  [[nodiscard]] virtual WithGradient wants() const = 0;

  /// Points whose densities the next tell() must bring; never empty (n, points).
  [[nodiscard]] virtual const Eigen::MatrixXd& asks() const = 0;
  /// @throws InputError if densities are not of what was asked for, or after 2^32 steps.
  virtual void tell(const Densities& at) = 0;

  /// Steps completed. The starting point is no step; its density is asked for first.
  [[nodiscard]] virtual long steps() const = 0;
  [[nodiscard]] virtual const Eigen::MatrixXd& positions() const = 0;     // (n, chains)
  [[nodiscard]] virtual const std::vector<StepStats>& stats() const = 0;  // last step (chains)

  /// Puts a chain elsewhere, between steps: swaps of parallel tempering. The density there is
  /// known and is not asked for again.
  /// @param at  of this one point, with gradients if wants() says so
  virtual void move(int chain, const Eigen::VectorXd& x, const Densities& at) = 0;
  /// Density at a chain's position, as move() wants it.
  [[nodiscard]] virtual Densities density(int chain) const = 0;

  /// Another power of the likelihood from now on; only between steps of warm-up. It is no part of
  /// the saved state: who changes it says it again before restore().
  virtual void set_beta(double beta) = 0;

  /// Everything that the next step depends on, but the options; only between steps.
  virtual void save(StateWriter& to) const = 0;
  virtual void restore(StateReader& from) = 0;
};

enum class SamplingMethod {
  kAdaptiveMetropolis,  // Haario's, with a scale learnt by Robbins and Monro
  kDreamZs,             // differential evolution from an archive of past states
  kStretchMove,         // affine-invariant ensemble
  kHmc,                 // Hamiltonian, jittered length
  kNuts                 // no U-turn, multinomial
};

enum class Metric { kDiagonal, kDense };

struct SamplerOptions {
  unsigned seed = 1;
  int first_chain = 0;             // number of its first chain, for its random streams [1]
  long warm_up = 1000;             // steps that adapt, below 2^32; afterwards nothing does [1]
  double beta = 1;                 // power of the likelihood: prior * likelihood^beta, 0..1 [1]
  double target_acceptance = 0;    // 0: the method's own [1]
  int max_depth = 10;              // of trees of NUTS [1]
  Metric metric = Metric::kDense;  // of HMC and NUTS
  Eigen::MatrixXd covariance;      // guess of the target's, to start from; empty: identity (n, n)
};

/// @param starts  one column for each chain; kStretchMove wants at least n + 2 and an even number,
/// kDreamZs at least 3, the others one (n, chains). Their densities are not known yet: a
/// Hamiltonian chain at a start of no density has no slope to follow; it stays, and calls each step
/// divergent, until move() takes it away.
/// @throws InputError if shapes or options do not fit, or a start is not finite.
[[nodiscard]] std::unique_ptr<Sampler> build_sampler(SamplingMethod method,
                                                     const Eigen::MatrixXd& starts,
                                                     const SamplerOptions& options);

/// "adaptive-metropolis", "dream-zs", "stretch", "hmc" or "nuts". @throws InputError else.
[[nodiscard]] SamplingMethod sampling_method(const std::string& name);
[[nodiscard]] std::string name_of(SamplingMethod method);

namespace internal {
/// The number of a step, from 0, for its stream of random numbers.
/// @throws InputError from 2^32 on, where the numbers would begin to repeat.
[[nodiscard]] std::uint32_t stream_step(long step);

std::unique_ptr<Sampler> adaptive_metropolis(const Eigen::MatrixXd&, const SamplerOptions&);
std::unique_ptr<Sampler> dream_zs(const Eigen::MatrixXd&, const SamplerOptions&);
std::unique_ptr<Sampler> stretch_move(const Eigen::MatrixXd&, const SamplerOptions&);
std::unique_ptr<Sampler> hamiltonian(SamplingMethod, const Eigen::MatrixXd&, const SamplerOptions&);
}  // namespace internal

}  // namespace thenar
