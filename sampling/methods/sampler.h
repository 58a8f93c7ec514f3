#pragma once

/// Ask/tell interface of Markov chain samplers: a sampler requests densities at points, and the
/// driver supplies them, so that many chains share one batch evaluation.

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
struct StepStats {            // log prior at the new position [1]
  double log_prior = 0;       // log likelihood at the new position, without beta [1]
  double log_likelihood = 0;  // log likelihood at the new position, not tempered [1]
  double acceptance = 0;      // acceptance probability, mean over the step's proposals, 0..1
  double step_size = 0;       // leapfrog step size; 0 for samplers without one [1]
  double energy = 0;          // Hamiltonian at the new position; 0 without one [1]
  int depth = 0;              // depth of the NUTS tree [1]
  int evaluations = 0;     // number of densities requested by this chain, without hotter ones [1]
  int non_finite = 0;      // number of evaluations that gave NaN or +inf [1]
  bool divergent = false;  // the energy error of a trajectory exceeded 1000
};

/// Sampler of one chain, or of several that advance together (walkers of an ensemble). The driver
/// evaluates the target at asks() and passes the densities to tell(), until the sampler has made
/// the required number of steps. Every draw depends only on the seed, the chain's number and the
/// step. Random streams count steps in 32 bits: a chain makes fewer than 2^32 (4.3e9) steps.
///
/// A density of NaN or +inf is treated as zero and counted in StepStats::non_finite.
class Sampler {
 public:
  virtual ~Sampler() = default;

  [[nodiscard]] virtual int chains() const = 0;
  /// Returns whether tell() needs gradients.
  [[nodiscard]] virtual WithGradient wants() const = 0;

  /// Returns the points whose densities the next tell() must supply; never empty (n, points).
  [[nodiscard]] virtual const Eigen::MatrixXd& asks() const = 0;
  /// Continues with the requested densities. @param at  densities at asks(), in the same order
  /// @throws InputError if their number differs, or after 2^32 steps.
  virtual void tell(const Densities& at) = 0;

  /// Returns the number of completed steps. The starting point is no step; its density is requested
  /// first.
  [[nodiscard]] virtual long steps() const = 0;
  [[nodiscard]] virtual const Eigen::MatrixXd& positions() const = 0;     // (n, chains)
  [[nodiscard]] virtual const std::vector<StepStats>& stats() const = 0;  // last step (chains)

  /// Moves a chain to another point between steps, as in swaps of parallel tempering. The density
  /// there is known and will not be requested.
  /// @param at  density at x only, with gradients if wants() says so
  virtual void move(int chain, const Eigen::VectorXd& x, const Densities& at) = 0;
  /// Returns the density at a chain's position, in the form required by move().
  [[nodiscard]] virtual Densities density(int chain) const = 0;

  /// Sets another power of the likelihood; only between steps of warm-up. It is not part of the
  /// saved state: set it again before restore().
  virtual void set_beta(double beta) = 0;

  /// Save and restore everything that the next step depends on, except the options; only between
  /// steps.
  virtual void save(StateWriter& to) const = 0;
  virtual void restore(StateReader& from) = 0;
};

/// Sampling method.
enum class SamplingMethod {
  kAdaptiveMetropolis,  // adaptive Metropolis (Haario) with a scale adapted by Robbins-Monro
  kDreamZs,             // differential evolution with an archive of past states
  kStretchMove,         // affine-invariant ensemble
  kHmc,                 // Hamiltonian Monte Carlo with jittered length
  kNuts                 // no-U-turn sampler with multinomial draws
};
inline constexpr std::array kSamplingMethodNames{
    EnumName{SamplingMethod::kAdaptiveMetropolis, "adaptive-metropolis"},
    EnumName{SamplingMethod::kDreamZs, "dream-zs"},
    EnumName{SamplingMethod::kStretchMove, "stretch"}, EnumName{SamplingMethod::kHmc, "hmc"},
    EnumName{SamplingMethod::kNuts, "nuts"}};

/// Shape of the mass matrix of Hamiltonian samplers.
enum class Metric { kDiagonal, kDense };

/// Options of a sampler.
struct SamplerOptions {
  unsigned seed = 1;    // random seed
  int first_chain = 0;  // number of the first chain, which selects its random streams [1]
  long warm_up =
      1000;         // number of adaptation steps, below 2^32; the sampler is fixed afterwards [1]
  double beta = 1;  // power of the likelihood: prior * likelihood^beta, 0..1 [1]
  double target_acceptance = 0;    // target acceptance probability; 0: default of the method [1]
  int max_depth = 10;              // maximum depth of NUTS trees [1]
  Metric metric = Metric::kDense;  // metric of HMC and NUTS
  Eigen::MatrixXd covariance;  // initial guess of the target's covariance; empty: identity (n, n)
};

/// Returns whether a method follows trajectories, which have a target acceptance and may diverge.
[[nodiscard]] bool is_hamiltonian(SamplingMethod method);
/// Returns the target acceptance used by HMC and NUTS [1].
[[nodiscard]] double target_acceptance_of(const SamplerOptions& options);

/// Creates a sampler.
/// @param starts  one column per chain; kStretchMove needs an even number of at least n + 2,
///         kDreamZs at
/// least 3, the others one (n, chains). Their densities are not known yet: a Hamiltonian chain that
/// starts at zero density has no gradient to follow; it stays, and reports each step as divergent,
/// until move() puts it elsewhere.
/// @throws InputError if shapes or options are invalid, or a start is not finite.
[[nodiscard]] std::unique_ptr<Sampler> build_sampler(SamplingMethod method,
                                                     const Eigen::MatrixXd& starts,
                                                     const SamplerOptions& options);

/// Returns the method of a name: "adaptive-metropolis", "dream-zs", "stretch", "hmc" or "nuts".
/// @throws InputError for any other name.
[[nodiscard]] SamplingMethod sampling_method(const std::string& name);
[[nodiscard]] std::string name_of(SamplingMethod method);

namespace internal {
/// Converts a step number, from 0, to the counter of its random stream.
/// @throws InputError from 2^32 on, where random numbers would repeat.
[[nodiscard]] std::uint32_t stream_step(long step);

std::unique_ptr<Sampler> adaptive_metropolis(const Eigen::MatrixXd&, const SamplerOptions&);
std::unique_ptr<Sampler> dream_zs(const Eigen::MatrixXd&, const SamplerOptions&);
std::unique_ptr<Sampler> stretch_move(const Eigen::MatrixXd&, const SamplerOptions&);
std::unique_ptr<Sampler> hamiltonian(SamplingMethod, const Eigen::MatrixXd&, const SamplerOptions&);
}  // namespace internal

}  // namespace thenar
