// thenar moment-arms SUBJECT --digit D --posture ... [--vary JOINT=from:to:step ...] [--path ...]
// thenar tip-force SUBJECT --digit D --posture ... --tension FDP=10 ... [--hold pinned|rigid]
// thenar feasible-force SUBJECT --digit D --posture ... [--direction x y z | --torque x y z]
//
// Questions about the tendons of one digit.

#include "apps/commands.h"
#include "apps/request_options.h"

namespace thenar {

void add_digit_commands(CLI::App& app) {
  add_question_command(
      app, {"moment-arms",
            "moment_arms",
            {"moment-arms synek2019_middle --posture MCP3_FE=20",
             "moment-arms mirakhorlo2016 --digit index --path wrapped --vary PIP2=0:90:5 "
             "--report out/arms.html"}});
  add_question_command(app,
                       {"tip-force",
                        "tip_force",
                        {"tip-force synek2019_middle --posture MCP3_FE=40 PIP3=55 --tension FDP=10",
                         "tip-force synek2019_middle --posture MCP3_FE=40 DIP3=20 --tension FDP=10 "
                         "--vary PIP3=10:90:5 --report out/tip.html"}});
  const auto [command, typed] = add_question_command(
      app, {"feasible-force",
            "feasible_force",
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
             "MCP1_FE=26 IP1=-3.8 --axes tip --direction 0 -1 0"}});
  // An axis of a moment is a direction of the other load.
  command
      ->add_option_function<std::vector<double>>(
          "--torque",
          [typed = typed](const std::vector<double>& axis) {
            typed->request["load"] = "moment";
            typed->request["direction"] = axis;
          },
          "Axis x y z of the wanted moment about the tip, right-handed")
      ->expected(3)
      ->excludes(command->get_option("--direction"));
}

}  // namespace thenar
