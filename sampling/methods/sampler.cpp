#include "sampling/methods/sampler.h"

#include "base/error.h"

namespace thenar {
namespace {

constexpr long kMaxStreamSteps = 1L << 32;  // number of steps that 32 bits can distinguish

void check_sampler(const Eigen::MatrixXd& starts, const SamplerOptions& options) {
  // Starts.
  const Eigen::Index n = starts.rows();
  require(n >= 1 && starts.cols() >= 1, "starts are {} x {}", n, starts.cols());
  require(starts.allFinite(), "a start is not finite");
  // Options.
  require(options.first_chain >= 0, "first chain must be >= 0, got {}", options.first_chain);
  require(options.warm_up >= 0 && options.warm_up < kMaxStreamSteps,
          "warm-up must be >= 0 and below 2^32 steps, got {}", options.warm_up);
  require(options.beta >= 0 && options.beta <= 1, "temper must be in 0..1, got {}", options.beta);
  require(options.target_acceptance >= 0 && options.target_acceptance < 1,
          "target acceptance must be in 0 .. below 1, got {}", options.target_acceptance);
  require(options.max_depth >= 1, "depth of trees must be >= 1, got {}", options.max_depth);
  const Eigen::MatrixXd& C = options.covariance;
  require(C.size() == 0 || (C.rows() == n && C.cols() == n),
          "covariance is {} x {}, starts have {} entries", C.rows(), C.cols(), n);
}

}  // namespace

bool is_hamiltonian(SamplingMethod method) {
  return method == SamplingMethod::kNuts || method == SamplingMethod::kHmc;
}

double target_acceptance_of(const SamplerOptions& options) {
  constexpr double kDefaultAcceptance = 0.8;  // Stan's acceptance rate [1] [Carpenter2017]
  return options.target_acceptance > 0 ? options.target_acceptance : kDefaultAcceptance;
}

std::unique_ptr<Sampler> build_sampler(SamplingMethod method, const Eigen::MatrixXd& starts,
                                       const SamplerOptions& options) {
  check_sampler(starts, options);
  switch (method) {
    case SamplingMethod::kAdaptiveMetropolis:
      return internal::adaptive_metropolis(starts, options);
    case SamplingMethod::kDreamZs:
      return internal::dream_zs(starts, options);
    case SamplingMethod::kStretchMove:
      return internal::stretch_move(starts, options);
    default:
      return internal::hamiltonian(method, starts, options);
  }
}

std::uint32_t internal::stream_step(long step) {
  require(step >= 0 && step < kMaxStreamSteps,
          "a chain has random numbers for 2^32 steps, asked for those of step {}", step);
  return static_cast<std::uint32_t>(step);
}

SamplingMethod sampling_method(const std::string& name) {
  return value_in(kSamplingMethodNames, name, "sampling method");
}

std::string name_of(SamplingMethod method) { return name_in(kSamplingMethodNames, method); }

}  // namespace thenar
