#pragma once

/// Ask/tell interface of Markov chain samplers: a sampler asks for densities at points and is told
/// them, so that many chains share one batch evaluation.

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/enum_names.h"
#include "sampling/methods/state_bytes.h"
#include "sampling/methods/target.h"

namespace thenar {

/// Statistics of one step of one chain.
struct StepStats {
  double log_prior = 0;       // at the new position [1]
  double log_likelihood = 0;  // at the new position, not tempered [1]
  double acceptance = 0;      // probability of acceptance, mean over the step's proposals, 0..1
  double step_size = 0;       // of the leapfrog; 0 for samplers without one [1]
  double energy = 0;          // Hamiltonian at the new position; 0 without one [1]
  int depth = 0;              // of the tree of NUTS [1]
  int evaluations = 0;        // densities asked for by this chain alone, not by hotter ones [1]
  int non_finite = 0;         // evaluations that gave NaN or +inf [1]
  bool divergent = false;     // the energy error of a trajectory exceeded 1000
};

/// One chain, or several that advance together (walkers of an ensemble). The driver evaluates the
/// target at asks() and passes the densities to tell(), until the sampler has made the wanted
/// number of steps. Every draw is a function of the seed, the chain's number and the step alone.
/// Streams of random numbers count steps in 32 bits: a chain makes fewer than 2^32 (4.3e9) steps.
///
/// A density of NaN or +inf counts as zero and is counted in StepStats::non_finite.
class Sampler {
 public:
  virtual ~Sampler() = default;

  [[nodiscard]] virtual int chains() const = 0;
  [[nodiscard]] virtual WithGradient wants() const = 0;

  /// Points whose densities the next tell() must bring; never empty (n, points).
  [[nodiscard]] virtual const Eigen::MatrixXd& asks() const = 0;
  /// @param at  densities at asks(), in its order
  /// @throws InputError if their number differs, or after 2^32 steps.
  virtual void tell(const Densities& at) = 0;

  /// Steps completed. The starting point is no step; its density is asked for first.
  [[nodiscard]] virtual long steps() const = 0;
  [[nodiscard]] virtual const Eigen::MatrixXd& positions() const = 0;     // (n, chains)
  [[nodiscard]] virtual const std::vector<StepStats>& stats() const = 0;  // last step (chains)

  /// Puts a chain at another point between steps, as swaps of parallel tempering do. The density
  /// there is known and is not asked for again.
  /// @param at  density at x alone, with gradients if wants() says so
  virtual void move(int chain, const Eigen::VectorXd& x, const Densities& at) = 0;
  /// Density at a chain's position, as move() wants it.
  [[nodiscard]] virtual Densities density(int chain) const = 0;

  /// Sets another power of the likelihood; only between steps of warm-up. It is no part of the
  /// saved state: set it again before restore().
  virtual void set_beta(double beta) = 0;

  /// Writes and reads everything that the next step depends on, except the options; only between
  /// steps.
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
inline constexpr std::array kSamplingMethodNames{
    EnumName{SamplingMethod::kAdaptiveMetropolis, "adaptive-metropolis"},
    EnumName{SamplingMethod::kDreamZs, "dream-zs"},
    EnumName{SamplingMethod::kStretchMove, "stretch"}, EnumName{SamplingMethod::kHmc, "hmc"},
    EnumName{SamplingMethod::kNuts, "nuts"}};

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

/// Returns whether a method moves along trajectories, which have a target acceptance and may
/// diverge.
[[nodiscard]] bool is_hamiltonian(SamplingMethod method);
/// The target acceptance that HMC and NUTS take [1].
[[nodiscard]] double target_acceptance_of(const SamplerOptions& options);

/// @param starts  one column for each chain; kStretchMove wants at least n + 2 and an even number,
/// kDreamZs at least 3, the others one (n, chains). Their densities are not known yet: a
/// Hamiltonian chain that starts at zero density has no gradient to follow; it stays, and calls
/// each step divergent, until move() puts it elsewhere.
/// @throws InputError if shapes or options do not fit, or a start is not finite.
[[nodiscard]] std::unique_ptr<Sampler> build_sampler(SamplingMethod method,
                                                     const Eigen::MatrixXd& starts,
                                                     const SamplerOptions& options);

/// Method of a name: "adaptive-metropolis", "dream-zs", "stretch", "hmc" or "nuts".
/// @throws InputError for any other name.
[[nodiscard]] SamplingMethod sampling_method(const std::string& name);
[[nodiscard]] std::string name_of(SamplingMethod method);

namespace internal {
/// Step number, from 0, as the counter of its stream of random numbers.
/// @throws InputError from 2^32 on, where random numbers would begin to repeat.
[[nodiscard]] std::uint32_t stream_step(long step);

std::unique_ptr<Sampler> adaptive_metropolis(const Eigen::MatrixXd&, const SamplerOptions&);
std::unique_ptr<Sampler> dream_zs(const Eigen::MatrixXd&, const SamplerOptions&);
std::unique_ptr<Sampler> stretch_move(const Eigen::MatrixXd&, const SamplerOptions&);
std::unique_ptr<Sampler> hamiltonian(SamplingMethod, const Eigen::MatrixXd&, const SamplerOptions&);
}  // namespace internal

}  // namespace thenar
