#pragma once

/// A fit of few parameters of a middle finger, which takes a fraction of a second.

#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "api/fit.h"
#include "tests/temporary_folder.h"

namespace thenar::sample {

class SmallFit : public TemporaryFolder {
 protected:
  /// Shares in the central slip and the tilt of the load cell move.
  [[nodiscard]] FitSources sources() const {
    std::ofstream(path("few.toml")) << "source = 'Synek2019'\n"
                                       "[[parameter]]\nmatch = 'hood/*/central'\nstate = 'free'\n"
                                       "sd = 0.3\nbetween_sd = 0.27\n"
                                       "[[parameter]]\nmatch = 'sensor/*'\nstate = 'free'\n"
                                       "sd_deg = 0\nbetween_sd_deg = 4\n";
    FitSources sources;
    sources.data = THENAR_DATA_DIR;
    sources.experiments = {THENAR_DATA_DIR "/experiments/synek2019_H01.toml"};
    sources.subject = THENAR_DATA_DIR "/subjects/synek2019_middle.toml";
    sources.settings = path("few.toml");
    return sources;
  }
};

}  // namespace thenar::sample
