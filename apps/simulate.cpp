// thenar simulate SUBJECT --digit D --excitation FDP=0.1 ... | --excitation-file E.csv
//                 [--muscle bounds|rigid-tendon|elastic-tendon]
//                 [--hood separate|fractions|net] [--net NAME|NET.toml]
//
// How one digit moves when its muscles are excited.

#include "tendons/muscle/simulate.h"

#include <algorithm>
#include <memory>

#include "api/digits.h"
#include "api/files.h"
#include "api/posture.h"
#include "apps/commands.h"
#include "apps/motion_output.h"
#include "apps/options.h"
#include "apps/terminal.h"
#include "base/error.h"
#include "base/nearest_name.h"
#include "base/progress_parts.h"
#include "base/rung_names.h"
#include "report/json.h"
#include "report/table.h"
#include "tendons/net/build_tendons.h"

namespace thenar {
namespace {

struct SimulateArguments {
  DigitRequest digit;
  std::string excitation_file, output;
  std::vector<std::string> excitation, tendon_slack;
  Muscle muscle = Muscle::kRigidTendon;
  std::vector<double> gravity;
  double seconds = 1, sample_ms = 5, tolerance = 1e-6;
  double damping = JointResistance().damping, blend = kBlend;
  bool json = false;
};

/// Slack lengths of tendons that the subject does not state, or others.
void set_slack(Subject& subject, const std::vector<std::string>& texts) {
  std::vector<std::string> names;
  for (const MuscleUnit& muscle : subject.muscles) names.push_back(muscle.name);
  const std::map<std::string, double> slack = parse_named_numbers(texts, "MUSCLE=mm");
  (void)in_order(slack, names, "muscle");  // refuses unknown names
  for (MuscleUnit& muscle : subject.muscles) {
    const auto found = slack.find(muscle.name);
    if (found == slack.end()) continue;
    require(found->second > 0, "wanted a slack length > 0 of '{}', got {} mm", muscle.name,
            found->second);
    muscle.tendon_slack = 1e-3 * found->second;
  }
}

/// A net that is named means that the hood is one.
std::unique_ptr<DigitTendons> tendons_of(const Subject& subject, const SimulateArguments& options) {
  const DigitRequest& request = options.digit;
  TendonOptions rungs;
  const std::string name = net_meant(request.hood, request.net);
  rungs.hood = name.empty() ? request.hood.value_or(rungs.hood) : Hood::kFloatingNet;
  rungs.frozen = frozen_joints(subject, request.frozen);
  rungs.path = request.path.value_or(Path::kViaPoint);
  const std::string digit = choose_digit(subject, request.digit);
  if (name.empty()) return build_digit_tendons(subject, digit, rungs);
  const NetDescription net = find_net(name);
  return build_digit_tendons(subject, digit, rungs, &net);
}

Excitation excitation_of(const SimulateArguments& options,
                         const std::vector<std::string>& muscles) {
  require(options.excitation.empty() != options.excitation_file.empty(),
          "wanted either --excitation MUSCLE=0..1 ... or --excitation-file");
  if (!options.excitation_file.empty())
    return parse_excitation(read_source(options.excitation_file).text, options.excitation_file,
                            muscles);
  return constant_excitation(
      in_order(parse_named_numbers(options.excitation, "MUSCLE=0..1"), muscles, "muscle"));
}

Eigen::Vector3d gravity_of(const SimulateArguments& options) {
  if (options.gravity.empty()) return Eigen::Vector3d::Zero();
  return {options.gravity[0], options.gravity[1], options.gravity[2]};
}

Trajectory trajectory_of(const SimulateArguments& options, const Subject& subject,
                         const DigitTendons& tendons) {
  const TendonDigit& digit = tendons.digit();
  const std::vector<std::string>& muscles = digit.names.muscles;
  require(!muscles.empty(), "no muscle of subject '{}' crosses a free joint of this digit",
          subject.name);
  const Muscle rung = options.muscle;
  const auto contraction = build_contraction(musculotendons(subject, digit, rung), rung);
  MotionModel model{tendons, *contraction};
  model.gravity = gravity_of(options);
  model.resistance.damping = options.damping;
  model.blend = options.blend;

  const MotionStart start{posture_of(digit.skeleton, options.digit.posture),
                          {},
                          Eigen::VectorXd::Zero(static_cast<Eigen::Index>(muscles.size()))};
  print_warnings(limit_warnings(digit.skeleton, start.q));
  SimulateOptions how;
  how.seconds = options.seconds;
  how.sample = 1e-3 * options.sample_ms;
  how.tolerance = options.tolerance;
  how.progress = terminal_progress();
  return simulate(model, excitation_of(options, muscles), start, how);
}

/// Whether the integration ended early, other than on request and for want of progress.
bool is_stuck(const Trajectory& trajectory) {
  return trajectory.status == MotionStatus::kIntegratorFailed ||
         trajectory.status == MotionStatus::kLimit;
}

/// Refuses what has been printed or written already, but must not be taken for the answer.
void require_end(const Trajectory& trajectory) {
  const EnergyBalance& balance = trajectory.balance;
  require(!is_stuck(trajectory), "the motion is stuck: {}", trajectory.warning);
  require(trajectory.status != MotionStatus::kNoProgress, "the motion does not get on: {}",
          trajectory.warning);
  require(trajectory.status != MotionStatus::kUnbalanced,
          "energy does not balance: {:.2g} mJ of {:.4g} mJ turned over came of nothing",
          1e3 * balance.error, 1e3 * balance.turned_over);
}

void run_simulate(const SimulateArguments& options) {
  if (!options.output.empty()) require_motion_path(options.output);
  const SourceText source = subject_source(options.digit.subject, options.digit.data);
  Subject subject = parse_subject(source.text, source.path);
  set_slack(subject, options.tendon_slack);
  const std::unique_ptr<DigitTendons> tendons = tendons_of(subject, options);
  const Trajectory trajectory = trajectory_of(options, subject, *tendons);

  MotionAnswer motion{subject.name,
                      choose_digit(subject, options.digit.digit),
                      *tendons,
                      trajectory,
                      {{source.path, source.text}}};
  if (!options.excitation_file.empty())
    motion.inputs[options.excitation_file] = read_source(options.excitation_file).text;
  const std::string net_name = net_meant(options.digit.hood, options.digit.net);
  if (!net_name.empty()) {
    const SourceText net = net_source(net_name);
    motion.inputs[net.path] = net.text;
  }
  if (!options.output.empty()) write_motion(motion, options.output);
  if (options.json)
    fmt::print("{}\n", json_text(json_of(motion)));
  else
    print_text(motion);
  if (!options.output.empty() && !options.json) fmt::print("wrote {}\n", options.output);
  const bool told =
      is_stuck(trajectory) || trajectory.status == MotionStatus::kNoProgress;  // by require_end()
  if (!trajectory.warning.empty() && !told)
    fmt::print(stderr, "thenar: warning: {}\n", trajectory.warning);
  require_end(trajectory);
  if (trajectory.status == MotionStatus::kStopped)
    throw Stopped(fmt::format("stopped; all up to then is {}",
                              options.output.empty() ? "above" : "in " + options.output));
}

void add_rungs(CLI::App& command, SimulateArguments& options) {
  command.add_option_function<std::string>(
      "--muscle", [&options](const std::string& name) { options.muscle = muscle_named(name); },
      "Muscles: " + listed(muscle_names()) + "; rigid-tendon if left out");
  command.add_option("--tendon-slack", options.tendon_slack,
                     "MUSCLE=mm ...: slack lengths of tendons, for elastic ones");
  command
      .add_option("--damping", options.damping, "Of joints whose subject gives none [N m s/rad]")
      ->check(CLI::NonNegativeNumber);
  command
      .add_option("--blend", options.blend,
                  "Strain over which the bands of a net go from slack to taut")
      ->check(CLI::PositiveNumber);
  command
      .add_option("--gravity", options.gravity,
                  "x y z of free fall in the subject's frame [m/s^2]; none if left out")
      ->expected(3);
}

}  // namespace

void add_simulate(CLI::App& app) {
  auto options = std::make_shared<SimulateArguments>();  // lives as long as the callback
  CLI::App* command = app.add_subcommand("simulate", "How a digit moves when muscles are excited");
  add_tendon_options(*command, options->digit, "fractions");
  command->add_option("--excitation", options->excitation, "MUSCLE=0..1 ..., from the start on");
  command->add_option("--excitation-file", options->excitation_file,
                      "CSV time_s,MUSCLE,...: straight lines between its rows");
  command->add_option("--seconds", options->seconds, "How long [s]")->check(CLI::PositiveNumber);
  command->add_option("--sample-ms", options->sample_ms, "Between the instants kept [ms]")
      ->check(CLI::PositiveNumber);
  command->add_option("--tolerance", options->tolerance, "Error of one step, relative")
      ->check(CLI::PositiveNumber);
  add_rungs(*command, *options);
  command->add_option("-o,--output", options->output, "Table .csv, HDF5 .h5 or page .html");
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([options] { run_simulate(*options); });
}

}  // namespace thenar
