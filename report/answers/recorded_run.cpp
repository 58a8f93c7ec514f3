#include "report/answers/recorded_run.h"

#include <fmt/format.h>

namespace thenar {
namespace {

/// "5, unchanged"
std::string input_words(const RecordedRun& recorded) {
  if (recorded.compared == 0) return "none recorded";
  if (recorded.changed == 0) return fmt::format("{}, unchanged", recorded.compared);
  return fmt::format("{}, {} changed", recorded.compared, recorded.changed);
}

}  // namespace

std::string text_of(const RecordedRun& recorded) {
  const RunRecord& run = recorded.run;
  const std::string what = run.arguments.empty() ? run.request : command_line(run);
  std::string text = fmt::format("{}\n  in {}\n  on {}, by commit {}\n", what, or_dash(run.folder),
                                 or_dash(run.date), or_dash(run.commit));
  text += fmt::format("  inputs: {}\n", input_words(recorded));
  for (const std::string& warning : recorded.warnings) text += "  warning: " + warning + "\n";
  return text;
}

Fields fields_of(const RecordedRun& recorded) {
  return {{"file", recorded.file},
          {"command", command_line(recorded.run)},
          {"arguments", recorded.run.arguments},
          {"folder", recorded.run.folder},
          {"date", recorded.run.date},
          {"commit", recorded.run.commit},
          {"inputs_sha256", recorded.inputs},
          {"inputs_compared", recorded.compared},
          {"inputs_changed", recorded.changed},
          {"warnings", recorded.warnings}};
}

}  // namespace thenar
