// thenar pose SUBJECT [--digit D ...] [--posture JOINT=deg ...] [--frozen JOINT=deg ...] [--json]
//
// Where joints, segments and tips are at a posture, and how the tips can move from there.

#include <memory>

#include "apps/commands.h"
#include "apps/pose_report.h"
#include "apps/posture_options.h"
#include "base/error.h"

namespace thenar {
namespace {

struct Options {
  std::string subject;
  std::vector<std::string> digits, posture, frozen;
  bool json = false;
};

void run(const Options& options) {
  const Subject subject = read_subject(options.subject);
  require(!subject.joints.empty(),
          "subject '{}' has no joints to pose, only maps from tendon tensions to tip forces; ask "
          "tip-force or feasible-force",
          subject.name);
  const Skeleton skeleton =
      build_skeleton(subject, {options.digits, parse_frozen(subject, options.frozen)});
  const Eigen::VectorXd q = parse_posture(skeleton, options.posture);
  warn_of_limits(skeleton, q);
  const PoseReport report = pose_report(subject, skeleton, q);
  options.json ? print_json(report) : print_text(report);
}

}  // namespace

void add_pose(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("pose", "Joints, segments and tips at a posture");
  command->add_option("subject", options->subject, "Subject file (TOML)")->required();
  command->add_option("--digit", options->digits, "Digits to keep; all if left out");
  command->add_option("--posture", options->posture,
                      "JOINT=degrees ..., or degrees in joint order; others stay at 0");
  command->add_option("--frozen", options->frozen, "JOINT=degrees ...: joints welded there");
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([options] { run(*options); });
}

}  // namespace thenar
