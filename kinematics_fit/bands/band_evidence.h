#pragma once

/// Marginal likelihood of a fit with a net: what measured forces say for one set of bands when all
/// that else is free has been averaged out.

#include <string>
#include <vector>

#include <Eigen/Core>

#include "kinematics_fit/fit_problem.h"

namespace thenar {

/// Evidence for one set of bands.
struct [[nodiscard]] BandEvidence {
  bool holds = false;      // the net carries all loads at the mode; otherwise nothing else is meant
  bool converged = false;  // the Newton step that is left is below kSettledStep
  Eigen::VectorXd z;       // mode (size of its problem)
  double misfit = 0;       // chi^2 of the data there [1]
  double effective = 0;    // parameters that the data determine, trace(I - C) [1]
  double laplace = 0;      // log p(data | bands) by Laplace's approximation [nat], less a constant
                           // of the data that all sets share:
                           //   -1/2 |r(z)|^2 - 1/2 log det H
  double integral = 0;     // the same by draws; laplace where too few of them count [nat]
  double draws_left = 0;   // share of the draws that count, (sum w)^2 / (n sum w^2) [1]
  bool by_draws = false;   // draws_left reaches kFewDraws; otherwise nothing vouches for laplace
};

/// Share of draws below which importance weights are too uneven for a mean [1].
inline constexpr double kFewDraws = 0.1;

/// Newton step at the mode below which it counts as found, in posterior sds [1]: the cost is then
/// right to half its square, 0.05.
inline constexpr double kSettledStep = 0.3;

/// Options of band_evidence().
struct EvidenceOptions {
  int draws = 64;     // from the Gaussian at the mode, in pairs +-; 0: Laplace alone
  unsigned seed = 1;  // of the draws. Each coordinate has a stream of its own by its name, so that
                      // errors of two sets are alike and drop out of their difference
  int slopes = 40;    // Jacobians of the search for the mode, at most
};

/// Finds the mode from all starts at which the net carries the loads, keeps the best, and
/// integrates over z ~ N(0, 1):
///   log p(data) = log integral exp(-1/2 |r_data(z)|^2) N(z; 0, 1) dz + constant.
/// Laplace's value is corrected by importance draws z_i = z + H^-1/2 v_i,
///   log mean of exp(-1/2 |r(z_i)|^2 + 1/2 |r(z)|^2 + 1/2 |v_i|^2),
/// exact as draws grow, also where a band turns slack and the likelihood has a kink. Draws beyond a
/// bound count 0; that priors end at bounds is otherwise left out, alike for all sets.
/// Source: [TierneyKadane1986].
BandEvidence band_evidence(const FitProblem& problem, const std::vector<Eigen::VectorXd>& starts,
                           const EvidenceOptions& options = {});

/// Returns whether the net carries the loads of every trial that pulls it.
[[nodiscard]] bool carries_loads(const FitProblem& problem, const Eigen::VectorXd& z);

/// Largest tension of each passive band over all trials, by name, in the net's order [N].
struct BandTension {
  std::string band;
  double tension;  // [N]
};
[[nodiscard]] std::vector<BandTension> largest_tensions(const FitProblem& problem,
                                                        const Eigen::VectorXd& z);

/// Slack length of a band in the posterior of one set.
struct SlackRange {
  double length = 0;    // at the mode [m]
  double sd = 0;        // posterior [m]
  double prior_sd = 0;  // [m]; sd near it: nothing was learnt
  bool at_bound = false;
};

/// Slack lengths that are free, by the bands' names, in the posterior of one set with its mode z.
[[nodiscard]] std::vector<std::pair<std::string, SlackRange>> slack_ranges(
    const FitProblem& problem, const Eigen::VectorXd& z);

}  // namespace thenar
