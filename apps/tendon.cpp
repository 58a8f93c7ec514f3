// thenar tendon solve|sweep|infer ...
//
// The tendons of one digit: the tension in every band of its extensor hood at one posture or over
// many, and which bands measured forces ask for.

#include <memory>

#include <fmt/format.h>

#include "apps/commands.h"
#include "apps/options.h"
#include "apps/outputs.h"
#include "apps/terminal.h"
#include "base/error.h"
#include "base/progress_parts.h"
#include "report/answers/tendon_infer.h"
#include "report/answers/tendon_solve.h"
#include "report/pages/tendons.h"

namespace thenar {
namespace {

struct TendonArguments {
  TendonRequest request;
  Outputs outputs;
};

struct InferArguments {
  InferNetRequest request;
  std::string method = "sparse";
  Outputs outputs;
};

/// Refuses what has been printed and written, but must not be taken for the answer.
void require_accepted(const std::string& refusal) { require(refusal.empty(), "{}", refusal); }

void run_solve(const TendonArguments& options) {
  const TendonSolveResult solution = solve_tendons(options.request, terminal_progress());
  print_warnings(solution.outcome.warnings);
  deliver(options.outputs, solution);
  require_accepted(refusal_of(solution));
}

void run_sweep(const TendonArguments& options) {
  const TendonSweepResult sweep = sweep_tendons(options.request, terminal_progress());
  if (sweep.points.empty()) tell_if_stopped(0, sweep.outcome.asked, sweep.outcome.part);
  print_warnings(sweep.outcome.warnings);
  // A table goes to the screen unless a file is written; people then read the summary.
  Outputs outputs = options.outputs;
  outputs.csv = outputs.csv || (!outputs.json && outputs.files.empty());
  deliver(outputs, sweep);
  tell_if_stopped(sweep.outcome.done, sweep.outcome.asked, sweep.outcome.part);
  require_accepted(refusal_of(sweep));
}

void run_infer(InferArguments options) {
  options.request.method = infer_method_named(options.method);
  const InferNetResult inference = infer_net(options.request, terminal_progress());
  require_accepted(refusal_of(inference));
  print_warnings(inference.outcome.warnings);
  deliver(options.outputs, inference);
  if (inference.outcome.stopped())
    throw Stopped("stopped: these are the verdicts of what was tried so far");
}

/// Adds the common options of solve and sweep.
void add_load_options(CLI::App& command, TendonRequest& request) {
  add_tendon_options(command, request.digit, "net");
  add_named_numbers(command, "--tension", request.tension, "MUSCLE=newton",
                    "MUSCLE=newton ...; others are slack")
      ->required();
}

void add_solve(CLI::App& tendon) {
  auto options = std::make_shared<TendonArguments>();  // lives as long as the callback
  CLI::App* command = tendon.add_subcommand("solve", "Bands, slips, torques and tip force");
  add_load_options(*command, options->request);
  add_output_options(*command, options->outputs, {true, true, true});
  add_examples(*command,
               {"tendon solve synek2019_middle --posture MCP3_FE=20 PIP3=30 --tension EDC=2.9 "
                "LU=0.4",
                "tendon solve an_chao_index --net chao_an --posture MCP2_FE=20 PIP2=30 --tension "
                "EDC=2.9 -o net.html"});
  command->callback([options] { run_solve(*options); });
}

void add_sweep(CLI::App& tendon) {
  auto options = std::make_shared<TendonArguments>();  // lives as long as the callback
  CLI::App* command = tendon.add_subcommand(
      "sweep", "The same over postures: a table (CSV) on the screen, unless a file is written");
  add_load_options(*command, options->request);
  add_vary_option(*command, options->request.digit.vary)->required();
  add_output_options(*command, options->outputs, {true, true, true});
  add_examples(*command,
               {"tendon sweep synek2019_middle --tension EDC=2.9 LU=0.4 --vary PIP3=0:60:10",
                "tendon sweep synek2019_middle --tension EDC=2.9 LU=0.4 --vary MCP3_FE=0:40:20 "
                "PIP3=0:60:10 -o net.html"});
  command->callback([options] { run_sweep(*options); });
}

void add_infer(CLI::App& tendon) {
  auto options = std::make_shared<InferArguments>();  // lives as long as the callback
  InferNetRequest& request = options->request;
  CLI::App* command =
      tendon.add_subcommand("infer", "Which bands of a hood measured fingertip forces ask for");
  command
      ->add_option("experiment", request.experiment, "An experiment: its name, or its file (TOML)")
      ->required();
  command->add_option("--subject", request.subject, "A subject: its name, or its file (TOML)")
      ->required();
  command->add_option("--net", request.net, "Net of all bands that may exist: name or file (TOML)");
  add_path_option(*command, request.path);
  command->add_option("--method", options->method,
                      "sparse: all bands at once, at a price; explore: a search among nets");
  command->add_option("--propose", request.propose, "Tests to propose, at most");
  command->add_option("--seed", request.seed, "Of --method explore, and of what --free samples");
  command->add_option(
      "--free", request.free,
      "slack, paths, stiffness or globs as of `thenar fit --free`: what may explain "
      "the forces in place of a band; bands then get probabilities");
  command->add_option("--bands", request.bands,
                      "With --free: bands in question, globs; default all");
  command->add_option("--settings", request.settings,
                      "With --free: settings with all priors, as of `thenar fit`; name or file");
  command->add_option("--sweeps", request.sets.sweeps,
                      "With --free and more than 7 bands: how often the sampling asks for each");
  add_data_option(*command, request.data);
  add_output_options(*command, options->outputs, {true, true, true});
  add_examples(
      *command,
      {"tendon infer synek2019_H01 --subject synek2019_middle --net winslow --propose 2",
       "tendon infer synek2019_H02 --subject synek2019_middle -o bands.html",
       "tendon infer synek2019_H01 --subject an_chao_middle --net extensor_hood --free slack "
       "paths --bands 'sagittal*' 'transverse*' triangular"});
  command->callback([options] { run_infer(*options); });
}

}  // namespace

void add_tendon(CLI::App& app) {
  CLI::App* command = app.add_subcommand("tendon", "Tension in every band of the extensor hood");
  command->require_subcommand(1);
  add_infer(*command);
  add_solve(*command);
  add_sweep(*command);
}

}  // namespace thenar
