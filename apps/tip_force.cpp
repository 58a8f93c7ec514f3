// thenar tip-force SUBJECT --digit D --posture ... --tension FDP=10 ... [--hold pinned|rigid]
// [--vary JOINT=from:to:step ...]
//
// The static force of one fingertip under given tendon tensions.

#include "api/tip_force.h"

#include <memory>

#include "apps/commands.h"
#include "apps/options.h"
#include "apps/outputs.h"
#include "apps/terminal.h"
#include "base/units.h"
#include "report/answers/tip_force.h"
#include "report/pages/digit_page.h"

namespace thenar {
namespace {

struct TipForceArguments {
  TipForceRequest request;
  std::string hold = "pinned";
  double hold_length_mm = TipForceRequest().hold_length / kMm;
  Outputs outputs;
};

void run_tip_force(const TipForceArguments& options) {
  TipForceRequest request = options.request;
  request.hold = options.hold == "rigid" ? TipHold::kRigid : TipHold::kPinned;
  request.hold_length = kMm * options.hold_length_mm;
  const TipForceAnswer answer =
      ask_tip_force(request, terminal_progress("postures that are done are kept"));
  const DigitSweep& about = answer.about;
  deliver_postures(options.outputs, answer, about.warnings, about.done, about.asked());
}

}  // namespace

void add_tip_force(CLI::App& app) {
  auto options = std::make_shared<TipForceArguments>();  // lives as long as the callback
  CLI::App* command = app.add_subcommand("tip-force", "Force of a fingertip from tendon tensions");
  add_digit_options(*command, options->request.digit);
  add_named_numbers(*command, "--tension", options->request.tension, "MUSCLE=newton",
                    "MUSCLE=newton ...; others are slack")
      ->required();
  command->add_option("--hold", options->hold, "pinned: no moment; rigid: clamped")
      ->check(CLI::IsMember({"pinned", "rigid"}));
  command->add_option("--hold-length", options->hold_length_mm,
                      "How the norm of a rigid hold weighs moments [mm]");
  add_vary_option(*command, options->request.digit.vary);
  add_output_options(*command, options->outputs, {true, true, true});
  add_examples(*command,
               {"tip-force synek2019_middle --posture MCP3_FE=40 PIP3=55 --tension FDP=10",
                "tip-force synek2019_middle --posture MCP3_FE=40 DIP3=20 --tension FDP=10 "
                "--vary PIP3=10:90:5 --report out/tip.html"});
  command->callback([options] { run_tip_force(*options); });
}

}  // namespace thenar
