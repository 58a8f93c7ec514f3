#pragma once

/// A small posterior of the middle finger, sampled once for all tests.

#include <filesystem>
#include <string>
#include <vector>

#include "posterior/run/sample_posterior.h"
#include "tests/kinematics_fit/fit_samples.h"

namespace thenar::sample {

/// A few path points of the middle finger of H01 move, and its noise.
inline FitInputs small_inputs(const std::vector<std::string>& specimens = {"H01"}) {
  FitInputs inputs = finger_inputs("synek2019_middle", specimens);
  inputs.settings = {"fit.toml",
                     "source = 'Synek2019'\n"
                     "[[parameter]]\nmatch = 'hood/*/central'\nstate = 'free'\nsd = 0.3\n"
                     "between_sd = 0.27\n"
                     "[[parameter]]\nmatch = 'sensor/*'\nstate = 'free'\nsd_deg = 0\n"
                     "between_sd_deg = 4\n"};
  return inputs;
}

/// Settings of a run that takes about a second.
inline PosteriorSettings quick_settings(long draws = 250) {
  PosteriorSettings settings;
  settings.run.sampler.warm_up = 250;
  settings.run.draws = draws;
  settings.run.threads = 1;
  settings.run.sampler.target_acceptance = 0.85;
  settings.run.sampler.max_depth = 9;
  settings.mode_starts = 4;
  return settings;
}

/// A run with the quick settings, sampled when it is first asked for.
inline const PosteriorRun& sampled() {
  static const PosteriorRun run = sample_posterior(small_inputs(), quick_settings());
  return run;
}

/// A path of the system's folder for temporary files.
inline std::string temporary_path(const std::string& name) {
  return (std::filesystem::temp_directory_path() / name).string();
}

}  // namespace thenar::sample
