// What do priors and measured forces together say of a finger: how far is its DIP axis tilted?
//
// Prints:
//   chains agree: yes
//   tilt of the DIP axis: sd 4 deg before, 3 deg after
#include <cstdio>

#include <thenar/fits.h>

int main() {
  // Two chains in memory; `thenar fit --method mcmc` also searches better and writes a file.
  thenar::FitSources sources;
  sources.subject = "an_chao_middle";
  sources.experiments = {"synek2019_H01"};
  sources.settings = "finger_arms";
  thenar::PosteriorSettings settings;
  settings.run.groups = 2;
  settings.run.draws = 1000;
  settings.run.sampler.warm_up = 500;
  settings.mode_starts = 2;
  const thenar::PosteriorRun run =
      thenar::sample_posterior(thenar::read_fit_inputs(sources), settings);
  std::printf("chains agree: %s\n", run.convergence.worst_r_hat < 1.05 ? "yes" : "no");

  // One of some hundred parameters: what was believed beforehand, and what the forces left of it.
  const auto parameters = thenar::posterior_quantities(run);
  const auto estimates = thenar::estimates_of(parameters, run.draws.group);
  for (std::size_t i = 0; i < parameters.size(); ++i)
    if (parameters[i].name == "axis/DIP3/direction/1")
      std::printf("tilt of the DIP axis: sd %.0f deg before, %.0f deg after\n",
                  thenar::prior_sd(parameters[i]), estimates[i].sd);
}
