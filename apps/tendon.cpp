// thenar tendon solve|sweep|infer ...
//
// The tendons of one digit: the tension in every band of its extensor hood at one posture or over
// many, and which bands measured forces require.

#include "apps/commands.h"
#include "apps/request_options.h"

namespace thenar {
namespace {

void add_sweep(CLI::App& tendon) {
  const auto [command, typed] = add_question_command(
      tendon, {"sweep",
               "tendon_sweep",
               {"tendon sweep synek2019_middle --tension EDC=2.9 LU=0.4 --vary PIP3=0:60:10",
                "tendon sweep synek2019_middle --tension EDC=2.9 LU=0.4 --vary MCP3_FE=0:40:20 "
                "PIP3=0:60:10 -o net.html"}});
  command->description(
      "Solve the extensor hood over a grid of postures; prints CSV unless a file is written");
  command->get_option("--vary")->required();
  // A sweep without a file prints a table, as a text of every posture would be endless.
  command->callback([typed = typed] {
    Outputs& outputs = typed->outputs;
    outputs.csv = outputs.csv || (!outputs.json && outputs.files.empty());
    ask_and_deliver(*typed);
  });
}

}  // namespace

void add_tendon(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("tendon", "Compute the tension in every band of the extensor hood");
  command->require_subcommand(1);
  add_question_command(
      *command,
      {"infer",
       "bands",
       {"tendon infer synek2019_H01 --subject synek2019_middle --net winslow --propose 2",
        "tendon infer synek2019_H02 --subject synek2019_middle -o bands.html",
        "tendon infer synek2019_H01 --subject an_chao_middle --net extensor_hood --free slack "
        "paths --bands 'sagittal*' 'transverse*' triangular"}});
  add_question_command(
      *command, {"solve",
                 "tendons",
                 {"tendon solve synek2019_middle --posture MCP3_FE=20 PIP3=30 --tension EDC=2.9 "
                  "LU=0.4",
                  "tendon solve an_chao_index --net chao_an --posture MCP2_FE=20 PIP2=30 --tension "
                  "EDC=2.9 -o net.html"}});
  add_sweep(*command);
}

}  // namespace thenar
