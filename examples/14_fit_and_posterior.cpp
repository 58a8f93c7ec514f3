// A finger fitted to measured forces, and what its posterior says of one axis.
//
// Prints:
//   solved
//   tilt of the DIP axis: 90 % of the posterior within -4 and 5 deg
#include <cstdio>

#include <thenar/fits.h>

int main() {
  thenar::FitRequest request;
  request.sources.subject = "an_chao_middle";
  request.sources.experiments = {"synek2019_H01"};
  request.sources.settings = "finger_arms";
  std::printf("%s\n", thenar::name_of(thenar::fit_digit(request).outcome.status).c_str());
  thenar::PosteriorSettings settings;
  settings.run.groups = 2;
  settings.run.draws = settings.run.sampler.warm_up = 500;
  const auto run = thenar::sample_posterior(thenar::read_fit_inputs(request.sources), settings);
  for (const thenar::Estimate& tilt : thenar::summarise_posterior(run).estimates)
    if (tilt.name == "axis/DIP3/direction/1")
      std::printf("tilt of the DIP axis: 90 %% of the posterior within %.0f and %.0f deg\n",
                  tilt.q05, tilt.q95);
}
