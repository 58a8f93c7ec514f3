// thenar pose SUBJECT|ROBOT [--digit D ...] [--posture JOINT=deg ...] [--frozen JOINT=deg ...]
// [--json]
//
// Where joints, segments or links, and tips are at a posture; of a subject, how the tips can move
// from there.

#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "api/data_folders.h"
#include "api/hands.h"
#include "api/posture.h"
#include "apps/commands.h"
#include "apps/options.h"
#include "apps/pose_report.h"
#include "apps/robot_pose.h"
#include "apps/terminal.h"
#include "base/error.h"
#include "base/file_io.h"
#include "data/io/file_kind.h"
#include "data/io/robot/import_robot.h"

namespace thenar {
namespace {

struct PoseArguments {
  std::string subject, data;
  std::vector<std::string> digits, posture;
  PostureRequest frozen;
  bool json = false;
};

/// The robot that a name or a file stands for; empty: it is no robot, but a subject.
std::string robot_of(const PoseArguments& options) {
  namespace fs = std::filesystem;
  if (!is_file(options.subject)) return robot_file(options.subject, data_folders(options.data));
  if (fs::path(options.subject).extension() != ".toml") return options.subject;
  return find_file_kind(options.subject) == FileKind::kRobot ? options.subject : "";
}

void run_robot(const std::string& file, const PoseArguments& options) {
  require(options.digits.empty() && options.frozen.empty(),
          "--digit and --frozen are for subjects, '{}' is a robot", file);
  const RobotPose pose = pose_robot(import_robot(file), options.posture);
  print_warnings(pose.warnings);
  options.json ? print_json(pose) : print_text(pose);
}

void run_pose(const PoseArguments& options) {
  if (const std::string robot = robot_of(options); !robot.empty()) return run_robot(robot, options);
  const SourceText source = subject_source(options.subject, options.data);
  const Subject subject = parse_subject(source.text, source.path);
  require(!subject.joints.empty(),
          "subject '{}' has no joints to pose, only maps from tendon tensions to tip forces; ask "
          "tip-force or feasible-force",
          subject.name);
  const Skeleton skeleton =
      build_skeleton(subject, {options.digits, frozen_joints(subject, options.frozen)});
  const Eigen::VectorXd q = posture_of(skeleton, parse_posture(options.posture));
  print_warnings(limit_warnings(skeleton, q));
  const PoseReport report = pose_report(subject, skeleton, q);
  options.json ? print_json(report) : print_text(report);
}

}  // namespace

void add_pose(CLI::App& app) {
  auto options = std::make_shared<PoseArguments>();
  CLI::App* command =
      app.add_subcommand("pose", "Joints, segments or links, and tips at a posture");
  command
      ->add_option("subject", options->subject, "Subject file (TOML), or a robot: a name or a file")
      ->required();
  command->add_option("--digit", options->digits, "Digits to keep; all if left out");
  command->add_option("--posture", options->posture,
                      "JOINT=degrees ..., or degrees in joint order; others stay at 0. Of a robot "
                      "degrees of freedom or joints, slides in mm");
  add_frozen_option(*command, options->frozen);
  add_data_option(*command, options->data);
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([options] { run_pose(*options); });
}

}  // namespace thenar
