// thenar pad press [--pad PAD] --object plane|sphere|cylinder|edge|MESH --force F | --depth D ...
// thenar pad fit PRESSES [--pad PAD] -o FITTED.toml
// thenar pad laws [--pad PAD] -o LAWS.toml
//
// Finger pads by themselves: pressed by a rigid object, fitted to measured presses, reduced to
// laws.

#include <filesystem>
#include <memory>
#include <string>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "api/named/data_folders.h"
#include "api/pads/calibrate_pad.h"
#include "api/pads/fit_pad.h"
#include "apps/commands.h"
#include "apps/options.h"
#include "apps/outputs.h"
#include "apps/request_options.h"
#include "apps/terminal.h"
#include "base/error.h"
#include "base/file_io.h"
#include "base/lists.h"
#include "base/progress_parts.h"
#include "report/pads/fit_answer.h"
#include "report/pads/laws_answer.h"

namespace thenar {
namespace {

/// Checks that an output does not overwrite its input.
void require_other_file(const std::string& output, const std::string& input) {
  std::error_code none;
  require(output.empty() || !std::filesystem::equivalent(output, input, none),
          "'{}' is what the answer comes from: wanted another file to write", output);
}

/// Delivers an answer, and its own file if there is a text for it.
/// @return message about a requested file that was not written
template <typename Result>
std::string deliver_with_file(Outputs outputs, const Result& found, const std::string& file,
                              const std::string& text) {
  const bool is_written = !file.empty() && !text.empty();
  if (is_written)
    write_file(file, text);
  else
    erase_where(outputs.files, [&](const std::string& each) { return each == file; });
  print_warnings(found.outcome.warnings);
  deliver(outputs, found);
  return file.empty() || is_written ? "" : fmt::format("; '{}' was not written", file);
}

struct PadFitArguments : Arguments<PadFitRequest> {
  bool no_mesh_check = false;
};

void run_pad_fit(PadFitArguments options) {
  options.request.check_mesh = !options.no_mesh_check;
  const std::string file = options.outputs.only_file(".toml");
  const FittedPad fitted = fit_pad(options.request, terminal_progress());
  const std::string refusal = refusal_of(fitted);
  // A pad is a file only where the search has come to its end.
  const bool is_pad = refusal.empty() && !fitted.outcome.stopped();
  const std::string text = is_pad && !file.empty() ? fitted_pad_text(fitted, file) : "";
  const std::string unwritten = deliver_with_file(options.outputs, fitted, file, text);
  require(refusal.empty(), "{}{}", refusal, unwritten);
  if (fitted.outcome.stopped())
    throw Stopped(fmt::format(
        "stopped: this is {}{}",
        fitted.fit.estimates.empty() ? "before there was an estimate" : "the best estimate by then",
        unwritten));
}

void add_pad_fit(CLI::App& pad) {
  auto options = std::make_shared<PadFitArguments>();  // lives as long as the callback
  CLI::App* command = pad.add_subcommand(
      "fit", "Fit constants of a pad to measured presses; say which the data do not determine");
  PadFitRequest& request = options->request;
  command
      ->add_option("presses", request.presses,
                   "Measured presses and the constants to fit: a name, or a file (TOML)")
      ->required();
  command
      ->add_option(
          "--pad", request.pad,
          "The pad to start from: its name, or its file (TOML); default: from the data file")
      ->default_str("");
  command->add_option("--points", request.points, "Number of points on the fitted pad's curves");
  command->add_flag("--no-mesh-check", options->no_mesh_check,
                    "Do not press the estimate on cells of half the size, which takes as long as "
                    "the search");
  command->add_flag("--allow-unconverged", request.allow_unconverged,
                    "Write the pad and exit without error though the search has not converged");
  add_data_option(*command, request.data);
  add_output_options(*command, options->outputs, {true, true, true, {".toml"}});
  add_examples(*command,
               {"pad fit index_published", "pad fit index_published --no-mesh-check --json",
                "pad fit PRESSES.toml -o fitted.toml --report fit.html"});
  command->callback([options] { run_pad_fit(*options); });
}

struct PadLawsArguments : Arguments<PadLawsRequest> {
  double error_percent = 4;
};

void run_pad_laws(PadLawsArguments options) {
  const std::string file = options.outputs.only_file(".toml");
  options.request.force_error = 0.01 * options.error_percent;
  const PadRequest& pad = options.request.pad;
  require_other_file(file, named_file("pad", pad.pad, "pads", ".toml", data_folders(pad.data)));
  const PadLaws found = calibrate_pad(options.request, terminal_progress());
  const std::string refusal = refusal_of(found);
  // Laws are a file only where all fits have come to their end.
  const bool are_laws = refusal.empty() && !found.outcome.stopped();
  const std::string unwritten =
      deliver_with_file(options.outputs, found, file, are_laws ? pad_laws_text(found) : "");
  require(refusal.empty(), "{}{}", refusal, unwritten);
  if (found.outcome.stopped())
    throw Stopped(fmt::format("stopped: these are the presses by then{}", unwritten));
}

void add_pad_laws(CLI::App& pad) {
  auto options = std::make_shared<PadLawsArguments>();  // lives as long as the callback
  CLI::App* command = pad.add_subcommand(
      "laws",
      "Fit a power law, a soft finger and a bed of springs to a pad's elements; takes minutes");
  PadLawsRequest& request = options->request;
  command->add_option("--pad", request.pad.pad, "A pad: its name, or its file (TOML)");
  command->add_option("--error", options->error_percent,
                      "Estimated error of the elements' force below which the mesh is not refined "
                      "[%]");
  command->add_option("--max-elements", request.max_elements,
                      "Number of elements at which refinement stops");
  add_data_option(*command, request.pad.data);
  add_output_options(*command, options->outputs, {true, true, true, {".toml"}});
  add_examples(*command, {"pad laws", "pad laws --pad index_fitted -o index_fitted_laws.toml",
                          "pad laws --pad PAD.toml -o laws/PAD.toml --report laws.html"});
  command->callback([options] { run_pad_laws(*options); });
}

}  // namespace

void add_pad(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "pad", "Press a finger pad, fit it to measured presses, reduce it to laws");
  command->require_subcommand(1);
  add_question_command(*command, {"press",
                                  "press",
                                  {"pad press --force 1 -o pad.html",
                                   "pad press --object sphere --radius 5 --depth 1.5 --angle 30",
                                   "pad press --depth 1 --rate 10 --hold 5 --csv"}});
  add_pad_fit(*command);
  add_pad_laws(*command);
}

}  // namespace thenar
