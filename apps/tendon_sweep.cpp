// thenar tendon sweep SUBJECT --digit D --tension EDC=2.9 ... --vary PIP3=0:90:5 [--vary ...]
//
// The same as `tendon solve` over postures, each net started from its neighbour.

#include <algorithm>
#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "api/posture.h"
#include "apps/options.h"
#include "apps/tendon_answer.h"
#include "apps/tendon_commands.h"
#include "apps/tendon_report.h"
#include "apps/tendon_table.h"
#include "apps/terminal.h"
#include "base/error.h"
#include "base/file_io.h"
#include "base/progress_parts.h"
#include "report/json.h"

namespace thenar {
namespace {

struct TendonSweepArguments {
  TendonQuestion question;
  std::string output;
  bool json = false;
};

/// Row by row; each row comes anew from the straight finger.
std::vector<DigitPoint> sweep_rows(const TendonCase& at) {
  const PostureGrid& varied = at.grid;
  const Progress bar = terminal_progress();
  std::vector<DigitPoint> points;
  const double count = static_cast<double>(varied.postures.size());
  for (std::size_t begin = 0; begin < varied.postures.size() && !bar.stop(); begin += varied.row) {
    const auto from = varied.postures.begin() + static_cast<std::ptrdiff_t>(begin);
    Progress row = bar;
    row.report = [&](double fraction, const std::string& what) {
      bar((static_cast<double>(begin) + fraction * static_cast<double>(varied.row)) / count, what);
    };
    for (DigitPoint& point : sweep_digit(
             *at.tendons, {from, from + static_cast<std::ptrdiff_t>(varied.row)}, at.t, row))
      points.push_back(std::move(point));
  }
  return points;
}

void write(const TendonSweepArguments& options, const TendonCase& at,
           const std::vector<DigitPoint>& points) {
  if (std::filesystem::path(options.output).extension() == ".csv")
    write_file(options.output, csv_of(at, points));
  else
    write_tendon_report(options.question, at,
                        {*at.tendons, at.t, points, at.grid.varied, at.grid.row}, options.output);
}

/// Says on stderr where nets snapped, where they are not to be trusted, and where postures are
/// singular.
void warn_of(const TendonCase& at, const std::vector<DigitPoint>& points) {
  const auto doubtful = [](const DigitPoint& point) { return !tip_note(point.tip).empty(); };
  const auto first = std::find_if(points.begin(), points.end(), doubtful);
  if (first != points.end())
    fmt::print(stderr, "thenar: note: the force of the tip at {} of {} postures, first at {}: {}\n",
               std::count_if(first, points.end(), doubtful), points.size(),
               angles_in_words(at, first->q), tip_note(first->tip));
  for (const DigitPoint& point : points) {
    const std::string warning = warning_of(point);
    if (point.snapped)
      fmt::print(stderr, "thenar: note: the net snaps on the way to {}\n",
                 angles_in_words(at, point.q));
    if (!warning.empty())
      fmt::print(stderr, "thenar: warning: at {}: {}\n", angles_in_words(at, point.q), warning);
  }
}

/// The rule of `tendon solve`, posture by posture.
/// @throws InputError naming the first posture at which the tendons are not to be trusted.
void refuse_untrusted(const TendonCase& at, const std::vector<DigitPoint>& points) {
  const auto refused = [](const DigitPoint& p) { return !trusted(p.pull.status); };
  const auto first = std::find_if(points.begin(), points.end(), refused);
  if (first == points.end()) return;
  throw InputError(
      fmt::format("the tendons are not to be trusted at {} of {} postures, first at {} ({}): {}",
                  std::count_if(first, points.end(), refused), points.size(),
                  angles_in_words(at, first->q), name_of(first->pull.status), warning_of(*first)));
}

void run_tendon_sweep(const TendonSweepArguments& options) {
  require_ending(options.output, {".csv", ".html"});
  if (!options.output.empty()) require_writable(options.output);
  const TendonCase at = find_tendons(options.question);
  const std::vector<DigitPoint> points = sweep_rows(at);
  if (points.empty()) throw Stopped("stopped before the first posture was done");

  if (!options.output.empty()) write(options, at, points);
  if (options.json)
    fmt::print("{}\n", json_text(json_of(at, points)));
  else if (options.output.empty())
    fmt::print("{}", csv_of(at, points));
  else
    fmt::print("wrote {}\n", options.output);
  warn_of(at, points);
  if (points.size() < at.grid.postures.size())
    throw Stopped(fmt::format("stopped after {} of {} postures; they are kept", points.size(),
                              at.grid.postures.size()));
  refuse_untrusted(at, points);
}

}  // namespace

void add_tendon_sweep(CLI::App& tendon) {
  auto options = std::make_shared<TendonSweepArguments>();  // lives as long as the callback
  CLI::App* command = tendon.add_subcommand("sweep", "The same over postures");
  add_options(*command, options->question);
  add_vary_option(*command, options->question.digit.vary)->required();
  command->add_option("-o,--output", options->output, "Page (.html) or table (.csv) to write");
  command->add_flag("--json", options->json, "Print JSON, not CSV");
  command->callback([options] { run_tendon_sweep(*options); });
}

}  // namespace thenar
