#include "posterior/study/thumb_experiment.h"

#include <array>
#include <cmath>

#include "base/error.h"
#include "base/units.h"
#include "kinematics_fit/force_jacobian.h"
#include "sampling/random_stream.h"

namespace thenar {
namespace {

constexpr std::uint32_t kDigitizing = 201;  // purpose of the random stream

/// Degrees at CMC flexion and abduction, MCP flexion and abduction, IP.
PostureRecord posture(const char* name, std::array<double, 5> degrees) {
  constexpr const char* kJoints[] = {"CMC1_FE", "CMC1_AA", "MCP1_FE", "MCP1_AA", "IP1"};
  PostureRecord record{name, {}};
  for (std::size_t j = 0; j < degrees.size(); ++j) record.angles[kJoints[j]] = radians(degrees[j]);
  return record;
}

}  // namespace

std::vector<PostureRecord> thumb_postures() {
  return {posture("key", {0, -10, 20, 0, 30}), posture("opposition", {-15, 15, 15, 5, 20}),
          posture("wide", {-30, 20, 0, -5, 40}), posture("hook", {5, 0, 30, 0, 55})};
}

Eigen::Matrix3Xd true_forces(const TendonDigit& truth, const Experiment& experiment) {
  const FitParameters parameters = choose_parameters(truth, {}, {});
  return force_values(truth, parameters, plan_experiment(truth, parameters, experiment),
                      Eigen::VectorXd());
}

Experiment pull_muscles(const TendonDigit& truth, const PullOptions& options) {
  const std::vector<PostureRecord> postures = thumb_postures();
  require(options.postures >= 1 && options.postures <= static_cast<int>(postures.size()),
          "there are 1 to {} postures, asked for {}", postures.size(), options.postures);
  Experiment experiment;
  experiment.name = "pulls";
  experiment.specimen = "made_up_thumb";
  experiment.species = "human";
  experiment.source = "made up";
  experiment.digit = "thumb";
  experiment.hold = TipHold::kPinned;
  experiment.force_segment = "DP1";
  experiment.postures.assign(postures.begin(), postures.begin() + options.postures);
  for (const PostureRecord& record : experiment.postures)
    for (const std::string& muscle : truth.names.muscles) {
      Trial trial;
      trial.posture = record.name;
      trial.tension = {{muscle, options.tension}};
      trial.sd = Eigen::Vector3d::Constant(options.floor);
      experiment.trials.push_back(trial);
    }
  const Eigen::Matrix3Xd force = true_forces(truth, experiment);
  for (std::size_t i = 0; i < experiment.trials.size(); ++i) {
    Trial& trial = experiment.trials[i];
    trial.force = force.col(static_cast<Eigen::Index>(i));
    const double sd = std::hypot(options.floor, options.noise * trial.force.norm());
    trial.sd = Eigen::Vector3d::Constant(sd);
    RandomStream random(options.seed, static_cast<std::uint32_t>(i), 0, kDigitizing);
    for (int k = 0; k < 3 && options.add_noise; ++k) trial.force[k] += sd * random.normal();
  }
  return experiment;
}

}  // namespace thenar
