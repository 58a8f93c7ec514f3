#include "posterior/run/assess_run.h"

#include "posterior/run/laplace.h"

namespace thenar {

void assess_run(PosteriorRun& run) {
  if (run.draws.draws() == 0) return;
  ConvergenceLimits limits = run.settings.limits;
  limits.max_depth = run.settings.run.sampler.max_depth;
  run.convergence = assess(run.draws, run.posterior->names(), limits);
  std::vector<KnownMode> known;
  for (const Mode& mode : run.modes) {
    const Eigen::VectorXd centre = run.posterior->from_fit(mode.z);
    known.push_back({centre, laplace_covariance(*run.posterior, centre), mode.laplace_mass});
  }
  run.mode_table = tabulate_modes(run.draws, known);
}

}  // namespace thenar
