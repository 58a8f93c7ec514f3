// Effective draws from the posterior of a thumb: NUTS against adaptive Metropolis, one core.

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "bench/ratios.h"
#include "bench/sampler_task.h"

namespace thenar::bench {
namespace {

constexpr unsigned kTurns = 5;   // seeds
constexpr double kRHat = 1.01;   // of both, or the turn counts as a miss
constexpr double kGoal = 10000;  // effective draws, when warm-up and search count [1]

/// Time of an effective draw, least bulk ESS of all entries [us].
double after_warm_up(const TimedRun& run) { return 1e6 * run.sampling / run.ess; }
/// The same until there are kGoal of them, with all that comes before.
double all_counted(const TimedRun& run) {
  return 1e6 * (run.before + run.warm_up + kGoal * run.sampling / run.ess) / kGoal;
}

/// Greatest difference of two means in their Monte Carlo errors [1].
double disagreement(const TimedRun& a, const TimedRun& b) {
  const double error = std::sqrt(1 / a.ess + 1 / b.ess);
  return (a.mean - b.mean).cwiseQuotient(a.sd).cwiseAbs().maxCoeff() / error;
}

struct Turn {
  TimedRun ours, rival;
};

std::vector<Turn> turns(Told told) {
  const HandPosterior posterior = thumb_posterior();
  RunOptions options;  // the default method, warm-up and number of draws
  options.groups = posterior.preferred_batch_size();
  RivalRun rival;
  rival.told = told;
  rival.warm_up = told == Told::kAll ? 2000 : 100000;
  rival.steps = 100000;
  std::vector<Turn> all;
  for (unsigned seed = 1; seed <= kTurns; ++seed) {
    options.sampler.seed = rival.seed = seed;
    all.push_back({run_ours(posterior, options), run_metropolis(posterior, rival)});
  }
  return all;
}

Row row(const char* name, const std::vector<Turn>& turns, double (*cost)(const TimedRun&),
        double required) {
  std::vector<double> ours, rival, ratio;
  Row out{name, 0, 0, 0, required, 0, 5};  // five errors: 20 entries in five turns
  for (const Turn& turn : turns) {
    ours.push_back(cost(turn.ours));
    rival.push_back(cost(turn.rival));
    ratio.push_back(rival.back() / ours.back());
    const bool converged = turn.ours.r_hat < kRHat && turn.rival.r_hat < kRHat;
    out.error = std::max(out.error, converged ? disagreement(turn.ours, turn.rival)
                                              : std::numeric_limits<double>::infinity());
  }
  out.ours = median(ours);
  out.rival = median(rival);
  out.ratio = median(ratio);
  return out;
}

}  // namespace

Row ratio_sampler() {
  return row("effective draw, against adaptive Metropolis", turns(Told::kAll), after_warm_up, 20);
}
Row ratio_sampler_in_all() {
  return row("the same, search and warm-up counted", turns(Told::kStarts), all_counted, 0);
}

}  // namespace thenar::bench
