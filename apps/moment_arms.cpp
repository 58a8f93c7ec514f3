// thenar moment-arms SUBJECT --digit D --posture ... [--vary JOINT=from:to:step ...] [--path ...]
//
// Moment arms of every muscle of a digit about every joint, and its length changes.

#include "api/moment_arms.h"

#include <memory>

#include "apps/commands.h"
#include "apps/options.h"
#include "apps/outputs.h"
#include "apps/terminal.h"
#include "report/answers/moment_arms.h"
#include "report/pages/digit_page.h"

namespace thenar {
namespace {

struct MomentArmArguments {
  DigitRequest request;
  Outputs outputs;
};

void run_moment_arms(const MomentArmArguments& options) {
  const MomentArmAnswer answer =
      ask_moment_arms(options.request, terminal_progress("postures that are done are kept"));
  const DigitSweep& about = answer.about;
  deliver_postures(options.outputs, answer, about.warnings, about.done, about.asked());
}

}  // namespace

void add_moment_arms(CLI::App& app) {
  auto options = std::make_shared<MomentArmArguments>();  // lives as long as the callback
  CLI::App* command =
      app.add_subcommand("moment-arms", "Moment arms and length changes of a digit's tendons");
  add_digit_options(*command, options->request);
  add_hood_option(*command, options->request.hood, "fractions");
  add_vary_option(*command, options->request.vary);
  add_output_options(*command, options->outputs, {true, true, true});
  add_examples(*command,
               {"moment-arms synek2019_middle --posture MCP3_FE=20",
                "moment-arms mirakhorlo2016 --digit index --path wrapped --vary PIP2=0:90:5 "
                "--report out/arms.html"});
  command->callback([options] { run_moment_arms(*options); });
}

}  // namespace thenar
