// thenar tendon solve SUBJECT --digit D --tension EDC=2.9 ... [--posture ...] [--hood ...] [--net
// ...]
//
// The tension in every band of the hood at one posture, and what all tendons do to the digit.

#include <memory>

#include <fmt/format.h>

#include "apps/options.h"
#include "apps/tendon_answer.h"
#include "apps/tendon_commands.h"
#include "apps/tendon_report.h"
#include "base/error.h"
#include "base/file_io.h"
#include "report/json.h"

namespace thenar {
namespace {

struct TendonSolveArguments {
  TendonQuestion question;
  std::string output;
  bool json = false;
};

void run_tendon_solve(const TendonSolveArguments& options) {
  require_ending(options.output, {".html"});
  if (!options.output.empty()) require_writable(options.output);
  const TendonCase at = find_tendons(options.question);
  const std::vector<DigitPoint> points = sweep_digit(*at.tendons, at.grid.postures, at.t);
  const DigitPoint& point = points.front();
  if (options.json) {
    OrderedJson json = json_header(at);
    json.update(json_of(at, point));
    fmt::print("{}\n", json_text(json));
  } else {
    fmt::print("{}\n", text_header(at));
    print_text(at, point);
  }
  if (!options.output.empty())
    write_tendon_report(options.question, at, {*at.tendons, at.t, points, {0}, 1}, options.output);
  if (!options.output.empty() && !options.json) fmt::print("wrote {}\n", options.output);

  const std::string warning = warning_of(point);
  require(trusted(point.pull.status), "the tendons are not to be trusted here ({}): {}",
          name_of(point.pull.status), warning);
  if (!warning.empty()) fmt::print(stderr, "thenar: warning: {}\n", warning);
}

}  // namespace

void add_tendon_solve(CLI::App& tendon) {
  auto options = std::make_shared<TendonSolveArguments>();  // lives as long as the callback
  CLI::App* command = tendon.add_subcommand("solve", "Bands, slips, torques and tip force");
  add_options(*command, options->question);
  command->add_option("-o,--output", options->output, "Page to write (.html)");
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([options] { run_tendon_solve(*options); });
}

}  // namespace thenar
