// thenar feasible-force SUBJECT --digit D --posture ... [--direction x y z | --torque x y z]
// [--moments zero|free|N_m] [--forces zero|free|N] [--tolerance-deg a] [--without MUSCLE ...]
// [--weakened MUSCLE=newton ...] [--wrist held|free|pinch] [--stop JOINT=N_m ...] [--vary
// JOINT=from:to:step ...]
//
// The largest force or moment of a fingertip along a direction and what limits it, or all the
// forces it can make.

#include "api/feasible_force.h"

#include <memory>

#include "apps/commands.h"
#include "apps/options.h"
#include "apps/outputs.h"
#include "apps/terminal.h"
#include "base/error.h"
#include "base/numbers.h"
#include "base/units.h"
#include "report/answers/feasible_force.h"
#include "report/pages/digit_page.h"

namespace thenar {
namespace {

struct FeasibleForceArguments {
  FeasibleForceRequest request;
  std::vector<double> direction, torque;
  std::string moments = "zero", forces = "zero";  // beside what is asked for
  double tolerance_deg = 0;
  std::string axes = "world", wrist = "held";
  Outputs outputs;
};

WristLoad wrist_named(const std::string& name) {
  if (name == "held") return WristLoad::kHeld;
  return name == "free" ? WristLoad::kFree : WristLoad::kPinch;
}

/// "IP1=inf": the largest torque of stops, by joint; both signs may be infinite.
std::map<std::string, double> parse_stops(const std::vector<std::string>& texts) {
  std::map<std::string, double> stops;
  for (const std::string& text : texts) {
    const std::size_t sign = text.find('=');
    const std::string most = sign == std::string::npos ? "" : text.substr(sign + 1);
    const bool endless = sign > 0 && (most == "inf" || most == "-inf");
    const double infinite = most == "inf" ? kInfinity : -kInfinity;
    const auto [joint, torque] =
        endless ? std::make_pair(text.substr(0, sign), infinite)
                : std::pair<std::string, double>(*parse_named_numbers({text}, "JOINT=N_m").begin());
    require(stops.emplace(joint, torque).second, "'{}' is given twice", joint);
  }
  return stops;
}

/// "zero", "free", or the most of each component. @param what  "moments [N m]"
double most_of(const std::string& text, const std::string& what) {
  if (text == "zero") return 0;
  return text == "free" ? kInfinity : parse_number(text, "zero, free or " + what);
}

void run_feasible_force(const FeasibleForceArguments& options) {
  FeasibleForceRequest request = options.request;
  if (!options.direction.empty()) request.direction = Eigen::Vector3d(options.direction.data());
  if (!options.torque.empty()) {
    request.load = TipLoad::kMoment;
    request.direction = Eigen::Vector3d(options.torque.data());
  }
  request.most_other = request.load == TipLoad::kForce
                           ? most_of(options.moments, "the most about each axis [N m]")
                           : most_of(options.forces, "the most along each axis [N]");
  request.wrist = wrist_named(options.wrist);
  request.tolerance = options.tolerance_deg * kDegree;
  request.frame = options.axes == "tip" ? DirectionFrame::kTip : DirectionFrame::kWorld;
  const FeasibleForceAnswer answer =
      ask_feasible_force(request, terminal_progress("postures that are done are kept"));
  const DigitSweep& about = answer.about;
  deliver_postures(options.outputs, answer, about.warnings, about.done, about.asked());
}

}  // namespace

void add_feasible_force(CLI::App& app) {
  auto options = std::make_shared<FeasibleForceArguments>();  // lives as long as the callback
  CLI::App* command = app.add_subcommand(
      "feasible-force", "The largest force or moment of a fingertip, or all of them");
  add_digit_options(*command, options->request.digit);
  CLI::Option* direction =
      command->add_option("--direction", options->direction, "x y z of the wanted force")
          ->expected(3);
  CLI::Option* torque =
      command
          ->add_option("--torque", options->torque,
                       "x y z of the axis of the wanted moment about the tip, right-handed")
          ->expected(3)
          ->excludes(direction);
  command
      ->add_option("--moments", options->moments,
                   "Moments beside the force: zero (a pinned tip), free (a rigid hold), or the "
                   "most about each of the axes [N m]")
      ->excludes(torque);
  command
      ->add_option("--forces", options->forces,
                   "Forces beside the moment: zero, free, or the most along each of the axes [N]")
      ->needs(torque);
  command->add_option("--tolerance-deg", options->tolerance_deg,
                      "Half angle of the cone the force or moment may lie in [deg]");
  command
      ->add_option("--axes", options->axes,
                   "world: the subject's frame; tip: proximal, dorsal, radial")
      ->check(CLI::IsMember({"world", "tip"}));
  command->add_flag("--set", options->request.whole_set,
                    "The whole set, also beside a direction; of moments with --torque");
  command->add_option("--without", options->request.without,
                      "MUSCLE ...: paralysed, as under a nerve block; the loss is printed");
  add_named_numbers(*command, "--weakened", options->request.weakened, "MUSCLE=newton",
                    "MUSCLE=newton ...: can pull with so much at most; the loss is printed");
  command
      ->add_option("--wrist", options->wrist,
                   "held: welded; free: it moves and bears the load, with the muscles across it; "
                   "pinch: it moves, and the load ends within the hand")
      ->check(CLI::IsMember({"held", "free", "pinch"}));
  command->add_option_function<std::vector<std::string>>(
      "--stop",
      [options](const std::vector<std::string>& texts) {
        options->request.stops = parse_stops(texts);
      },
      "JOINT=N_m ...: a joint at the end of its range, whose ligaments give at most "
      "this torque; positive flexes, inf: any");
  add_vary_option(*command, options->request.digit.vary);
  add_output_options(*command, options->outputs, {true, true, true});
  add_examples(*command,
               {"feasible-force an_chao_index --posture MCP2_FE=45 PIP2=45 DIP2=10 --axes tip "
                "--direction 0 -1 0",
                "feasible-force synek2019_middle --posture MCP3_FE=20 DIP3=15 --axes tip "
                "--direction 0 -1 0 --vary PIP3=10:80:5 --report out/feasible.html",
                "feasible-force valero_cuevas_index --map JinvT_R --torque 1 0 0",
                "feasible-force arms_thumb --posture IP1=20 --axes tip --direction 0 -1 0 "
                "--moments 0.1",
                "feasible-force human_hand --digit thumb --posture CMC1_AA=10 MCP1_FE=26 IP1=-38.8 "
                "--axes tip --direction 0 -1 0 --without FPL --stop IP1=inf",
                "feasible-force human_hand --digit thumb --wrist pinch --posture CMC1_AA=10 "
                "MCP1_FE=26 IP1=-3.8 --axes tip --direction 0 -1 0"});
  command->callback([options] { run_feasible_force(*options); });
}

}  // namespace thenar
