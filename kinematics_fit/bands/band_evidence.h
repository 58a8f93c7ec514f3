#pragma once

/// Marginal likelihood of a fit with a net: evidence of measured forces for one set of bands, with
/// all free parameters integrated out.

#include <string>
#include <vector>

#include <Eigen/Core>

#include "kinematics_fit/fit_problem.h"

namespace thenar {

/// Evidence for one set of bands.
struct [[nodiscard]] BandEvidence {
  bool holds = false;  // the net carries all loads at the mode; otherwise no other field is valid
  bool converged = false;  // the remaining Newton step is below kSettledStep
  Eigen::VectorXd z;       // mode (size of its problem)
  double misfit = 0;       // chi^2 of the data at the mode [1]
  double effective = 0;    // parameters that the data determine, trace(I - C) [1]
  double laplace = 0;     // log p(data | bands) by Laplace's approximation, -1/2 |r(z)|^2 - 1/2 log
                          // det H, up to a constant that all sets share [nat]
  double integral = 0;    // log p(data | bands) by draws; `laplace` if too few draws count [nat]
  double draws_left = 0;  // effective share of the draws, (sum w)^2 / (n sum w^2) [1]
  bool by_draws = false;  // draws_left reaches kFewDraws; otherwise `laplace` is not verified
};

/// Effective share of draws below which importance weights are too uneven [1].
inline constexpr double kFewDraws = 0.1;

/// Newton step at the mode below which the search has converged, in posterior sds [1]; the error of
/// the cost is then at most half its square, 0.05.
inline constexpr double kSettledStep = 0.3;

/// Options of band_evidence().
struct EvidenceOptions {
  int draws = 64;     // number of draws from the Gaussian at the mode, in pairs +-; 0: Laplace only
  unsigned seed = 1;  // random seed; each coordinate has its own stream, selected by its name, so
                      // that errors of two sets are correlated and cancel in their difference
  int slopes = 40;    // maximum number of Jacobians in the search for the mode
};

/// Finds the mode from all starts at which the net carries the loads, keeps the best, and
/// integrates over z ~ N(0, 1):
///   log p(data) = log integral exp(-1/2 |r_data(z)|^2) N(z; 0, 1) dz + constant.
/// Laplace's value is corrected by importance draws z_i = z + H^-1/2 v_i,
///   log mean of exp(-1/2 |r(z_i)|^2 + 1/2 |r(z)|^2 + 1/2 |v_i|^2),
/// which converges to the exact value, even if a band becomes slack and the likelihood has a kink.
/// Draws beyond a bound count 0; apart from that, bounds of the priors are ignored, for all sets
/// alike.
/// Source: [TierneyKadane1986].
BandEvidence band_evidence(const FitProblem& problem, const std::vector<Eigen::VectorXd>& starts,
                           const EvidenceOptions& options = {});

/// Returns whether the net carries the loads of every trial that pulls it.
[[nodiscard]] bool carries_loads(const FitProblem& problem, const Eigen::VectorXd& z);

/// Maximum tension of one passive band over all trials.
struct BandTension {
  std::string band;
  double tension = 0;  // [N]
};
/// Returns the maximum tension of each passive band, in the net's order.
[[nodiscard]] std::vector<BandTension> largest_tensions(const FitProblem& problem,
                                                        const Eigen::VectorXd& z);

/// Slack length of a band in the posterior of one set.
struct SlackRange {
  double length = 0;    // length at the mode [m]
  double sd = 0;        // posterior sd [m]
  double prior_sd = 0;  // prior sd; the data are uninformative if the posterior sd is similar [m]
  bool at_bound = false;
};

/// Returns the free slack lengths by band name in the posterior of one set with mode z.
[[nodiscard]] std::vector<std::pair<std::string, SlackRange>> slack_ranges(
    const FitProblem& problem, const Eigen::VectorXd& z);

}  // namespace thenar
