// thenar pose SUBJECT|ROBOT [--digit D ...] [--posture JOINT=deg ...] [--frozen JOINT=deg ...]
// [--vary JOINT=from:to:step ...]
//
// Where joints, segments or links, and tips are at a posture or over a grid of them; of a subject,
// how the tips can move from there.

#include "api/pose.h"

#include <memory>
#include <type_traits>
#include <variant>

#include "apps/commands.h"
#include "apps/options.h"
#include "apps/outputs.h"
#include "apps/terminal.h"
#include "report/answers/pose.h"
#include "report/pages/digit_page.h"

namespace thenar {
namespace {

struct PoseArguments {
  PoseRequest request;
  Outputs outputs;
};

void run_pose(const PoseArguments& options) {
  const PoseAnswer answer =
      ask_pose(options.request, terminal_progress("postures that are done are kept"));
  std::visit(
      [&](const auto& poses) {
        using Poses = std::decay_t<decltype(poses)>;
        const std::shared_ptr<const Poses> kept(std::shared_ptr<const Poses>(), &poses);
        deliver(options.outputs, answer_of(kept, poses.outcome));
      },
      answer);
}

}  // namespace

void add_pose(CLI::App& app) {
  auto options = std::make_shared<PoseArguments>();  // lives as long as the callback
  PoseRequest& request = options->request;
  CLI::App* command =
      app.add_subcommand("pose", "Joints, segments or links, and tips at a posture");
  command->add_option("model", request.model, "A subject or a robot: its name, or its file")
      ->required();
  command->add_option("--digit", request.digits, "Digits of a subject to keep; all if left out");
  add_posture_option(*command, request.posture,
                     "JOINT=degrees ..., or degrees in joint order; others stay at 0. Robots: "
                     "degrees of freedom or joints, slides in mm");
  add_frozen_option(*command, request.frozen);
  add_vary_option(*command, request.vary);
  add_data_option(*command, request.data);
  add_output_options(*command, options->outputs, {true, true, true});
  add_examples(*command, {"pose synek2019_middle --posture MCP3_FE=40 --vary PIP3=0:90:10 --csv",
                          "pose barrett --report out/barrett.html"});
  command->callback([options] { run_pose(*options); });
}

}  // namespace thenar
