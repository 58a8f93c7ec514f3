#include "sampling/diagnostics/psis.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/error.h"
#include "sampling/diagnostics/convergence.h"
#include "sampling/diagnostics/log_sum.h"

namespace thenar {
namespace {

/// sqrt(n var) of n terms of a sum.
double error_of_sum(const Eigen::VectorXd& terms) {
  const double n = double(terms.size());
  return n < 2 ? std::nan("")
               : std::sqrt(n / (n - 1) * (terms.array() - terms.mean()).square().sum());
}

/// Effective over actual draws for the mean of the likelihood; 1 if it does not vary.
double efficiency_of(const Eigen::VectorXd& log_likelihood, int chains,
                     const std::vector<int>& group) {
  const Eigen::VectorXd likelihood = (log_likelihood.array() - log_likelihood.maxCoeff()).exp();
  const double ess = mean_ess(likelihood.reshaped(likelihood.size() / chains, chains), group);
  return std::isnan(ess) ? 1 : ess / double(likelihood.size());
}

}  // namespace

LeaveOneOut leave_one_out(const Eigen::Ref<const Eigen::MatrixXd>& log_likelihood, int chains,
                          const std::vector<int>& group) {
  const Eigen::Index draws = log_likelihood.cols(), observations = log_likelihood.rows();
  require(chains > 0 && draws % chains == 0 && draws / chains >= 4 && observations > 0,
          "leave-one-out needs observations and 4 draws a chain, got {} of {} chains for {}", draws,
          chains, observations);
  require(log_likelihood.allFinite(), "leave-one-out needs finite log likelihoods");

  LeaveOneOut of;
  of.good_k = std::min(1 - 1 / std::log10(double(draws)), 0.7);
  of.pointwise.resize(observations);
  of.k.resize(observations);
  for (Eigen::Index i = 0; i < observations; ++i) {
    const Eigen::VectorXd seen = log_likelihood.row(i).transpose();
    const SmoothedWeights weights = smooth_weights(-seen, efficiency_of(seen, chains, group));
    of.k[i] = weights.k;
    of.pointwise[i] = log_sum(weights.log_weight + seen);
    of.effective_parameters += log_sum(seen) - std::log(double(draws)) - of.pointwise[i];
  }
  of.elpd = of.pointwise.sum();
  of.se = error_of_sum(of.pointwise);

  Eigen::Index worst;
  const double highest = of.k.maxCoeff(&worst);
  if (const long bad = (of.k.array() > of.good_k).count(); bad > 0)
    of.doubts.push_back(
        fmt::format("{} of {} observations have a Pareto k above {:.2f}, up to {:.2f} of number "
                    "{}: the draws do not reach where the posterior would be without them",
                    bad, observations, of.good_k, highest, worst + 1));
  return of;
}

ElpdDifference compare_elpd(const LeaveOneOut& first, const LeaveOneOut& second) {
  require(first.pointwise.size() == second.pointwise.size(),
          "models of {} and {} observations cannot be compared", first.pointwise.size(),
          second.pointwise.size());
  const Eigen::VectorXd difference = first.pointwise - second.pointwise;
  return {difference.sum(), error_of_sum(difference)};
}

}  // namespace thenar
