#pragma once

/// Command that wrote a result, and changes of its inputs since.

#include <map>
#include <string>
#include <vector>

#include "base/run_record.h"

namespace thenar {

/// The run that a page, a JSON answer, a fit, a posterior or a motion records.
struct RecordedRun {
  std::string file;                           // that records it
  RunRecord run;                              // arguments, folder, commit and date
  std::string version;                        // of thenar that wrote it; empty: it does not say
  std::map<std::string, std::string> inputs;  // path, as the run saw it -> SHA-256
  int compared = 0;                           // inputs that are files, or were
  int changed = 0;                            // of these: others now, or gone
  std::vector<std::string> warnings;          // inputs and sources that are others now
};

/// Reads the record of the run that wrote a file, and compares the inputs with today's files and
/// the commit with that of this program.
/// @throws InputError if the file records no run; DataError if it cannot be read.
[[nodiscard]] RecordedRun read_recorded_run(const std::string& path);

/// Refuses what is no plain command of thenar, and `rerun` itself.
/// @param commands  names of the subcommands: "fit", "pose" ..
/// @throws InputError so, or if the folder of the run is gone.
void require_repeatable(const RecordedRun& recorded, const std::vector<std::string>& commands);

/// Returns whether tendons of the run were straight where no paths were asked for: they were before
/// version 0.2, and are default_path() since.
[[nodiscard]] bool ran_on_straight_paths(const RecordedRun& recorded);

}  // namespace thenar
