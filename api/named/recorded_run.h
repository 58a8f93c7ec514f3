#pragma once

/// Command that wrote a result, and changes of its inputs since.

#include <map>
#include <string>
#include <vector>

#include "base/run_record.h"

namespace thenar {

/// Run recorded in a page, a JSON answer, a fit, a posterior or a motion.
struct RecordedRun {
  std::string file;                           // file that holds the record
  RunRecord run;                              // arguments, folder, commit and date
  std::string version;                        // thenar version that wrote it; empty: not stated
  std::map<std::string, std::string> inputs;  // path, as the run saw it -> SHA-256
  int compared = 0;                           // number of inputs that are or were files
  int changed = 0;                            // number of inputs that have changed or are missing
  std::vector<std::string> warnings;          // inputs and sources that have changed
};

/// Reads the record of the run that wrote a file, and compares the inputs with today's files and
/// the commit with that of this program.
/// @throws InputError if the file records no run; DataError if it cannot be read.
[[nodiscard]] RecordedRun read_recorded_run(const std::string& path);

/// Checks that the record is a plain command of thenar other than `rerun`.
/// @param commands  names of the subcommands: "fit", "pose" ..
/// @throws InputError otherwise, or if the folder of the run is gone.
void require_repeatable(const RecordedRun& recorded, const std::vector<std::string>& commands);

/// Returns true if the run used straight tendon paths by default: before version 0.2 they were the
/// default, since then it is default_path().
[[nodiscard]] bool ran_on_straight_paths(const RecordedRun& recorded);

}  // namespace thenar
