// thenar pose SUBJECT|ROBOT [--digit D ...] [--posture JOINT=deg ...] [--frozen JOINT=deg ...]
// [--vary JOINT=from:to:step ...]
//
// Where joints, segments or links, and tips are at a posture or over a grid of them; of a subject,
// how the tips can move from there.

#include "apps/commands.h"
#include "apps/request_options.h"

namespace thenar {

void add_pose(CLI::App& app) {
  add_question_command(app,
                       {"pose",
                        "pose",
                        {"pose synek2019_middle --posture MCP3_FE=40 --vary PIP3=0:90:10 --csv",
                         "pose barrett --report out/barrett.html"}});
}

}  // namespace thenar
