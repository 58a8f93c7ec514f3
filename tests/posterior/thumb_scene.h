#pragma once

/// The posterior that samplers are timed on: a thumb of five skewed axes, whose 20 numbers are
/// sought from 54 forces of 9 muscles in 2 postures.

#include <array>
#include <random>

#include "base/units.h"
#include "kinematics_fit/fit_problem.h"
#include "kinematics_fit/force_jacobian.h"
#include "tendons/tendon_model.h"

namespace thenar::sample {

inline constexpr std::array<const char*, 5> kThumbJoints{"CMC1_FE", "CMC1_AA", "MCP1_FE", "MCP1_AA",
                                                         "IP1"};

/// Made up after the published thumbs: places and arms of the right size, no axis along another.
/// x is radial, y dorsal, z distal.
inline Subject skewed_thumb() {
  constexpr std::array<const char*, 6> kSegments{"TZ",        "CMC1_link", "MC1",
                                                 "MCP1_link", "PP1",       "DP1"};
  const std::array<Eigen::Vector3d, 5> directions{
      {{0.9, 0.2, 0.3}, {-0.3, 0.8, 0.5}, {0.95, 0.1, 0.2}, {0.1, 0.9, 0.3}, {1, 0.05, -0.1}}};
  constexpr std::array<double, 6> kAlong{0, 0.012, 0.045, 0.048, 0.080, 0.105};  // [m]
  Subject thumb;
  thumb.name = "skewed_thumb";
  thumb.side = "right";
  thumb.base = kSegments[0];
  for (std::size_t i = 0; i < kSegments.size(); ++i) {
    Segment bone;
    bone.name = kSegments[i];
    bone.proximal = {0, 0, i == 0 ? 0 : kAlong[i - 1]};
    bone.distal = {0, 0, kAlong[i]};
    thumb.segments.push_back(bone);
  }
  for (std::size_t i = 0; i < kThumbJoints.size(); ++i) {
    JointAxis joint;
    joint.name = kThumbJoints[i];
    joint.parent = kSegments[i];
    joint.child = kSegments[i + 1];
    joint.direction = directions[i].normalized();
    joint.point = {0, 0, kAlong[i]};
    thumb.joints.push_back(joint);
  }
  // Moment arms at the joints in turn, flexion and abduction positive [mm].
  struct Tendon {
    const char* name;
    std::array<double, 5> arms;
  };
  const std::array<Tendon, 9> tendons{{{"FPL", {14, -1, 11, 0, 7}},
                                       {"EPL", {-8, -9, -8, -2, -5}},
                                       {"EPB", {-13, 3, -7, 1, 0}},
                                       {"APL", {-9, 11, 0, 0, 0}},
                                       {"APB", {4, 10, 3, 6, -2}},
                                       {"FPB", {12, 3, 6, 4, 0}},
                                       {"OPP", {11, 5, 0, 0, 0}},
                                       {"ADP", {20, -13, 8, -6, -2}},
                                       {"FDI", {9, -10, 0, 0, 0}}}};
  for (const Tendon& tendon : tendons) {
    Strand strand;
    strand.name = tendon.name;
    for (std::size_t j = 0; j < kThumbJoints.size(); ++j)
      strand.arms[kThumbJoints[j]] = 1e-3 * tendon.arms[j];
    thumb.strands.push_back(strand);
    MuscleUnit muscle;
    muscle.name = muscle.strand = tendon.name;
    thumb.muscles.push_back(muscle);
  }
  Digit digit;
  digit.name = "thumb";
  digit.tip_segment = kSegments.back();
  digit.tip = {0, 0, kAlong.back()};
  digit.proximal = {0, 0, -1};
  digit.dorsal = {0, 1, 0};
  digit.radial = digit.proximal.cross(digit.dorsal);
  thumb.digits.push_back(digit);
  return thumb;
}

/// Key and opposition pinch, 10 N on one muscle after the other, tip pinned. Forces are zero yet.
inline Experiment pinches(double noise) {
  Experiment experiment;
  experiment.name = experiment.specimen = "pinches";
  experiment.digit = "thumb";
  experiment.hold = TipConstraint::kPinned;
  experiment.force_segment = "DP1";
  experiment.sd_floor = noise;
  const auto posture = [](const char* name, std::array<double, 5> degrees) {
    PostureRecord record;
    record.name = name;
    for (std::size_t j = 0; j < 5; ++j) record.angles[kThumbJoints[j]] = degrees[j] * kDegree;
    return record;
  };
  experiment.postures = {posture("key", {10, 5, 25, 3, 35}),
                         posture("opposition", {20, 15, 20, 0, 28})};
  for (const PostureRecord& record : experiment.postures)
    for (const char* muscle : {"FPL", "EPL", "EPB", "APL", "APB", "FPB", "OPP", "ADP", "FDI"}) {
      Trial trial;
      trial.posture = record.name;
      trial.tension = {{muscle, 10.0}};
      experiment.trials.push_back(trial);
    }
  return experiment;
}

/// What is known beforehand, and how good the load cell is. Places of the axes as from a scan,
/// directions hardly at all: so the Hessian of the whitened posterior has eigenvalues from 3 to 8e7
/// at its mode, a condition of 2e7, as published for thumbs.
struct ThumbScene {
  double tilt_sd = 60 * kDegree;  // of axis directions beforehand [rad]
  double shift_sd = 0.0005;       // of axis points beforehand [m]
  double noise = 0.002;           // of every force component, sd [N]
  double spread = 0.2;            // of the true axes about the prior means, in prior sds [1]
  unsigned seed = 1;              // of truth and noise
};

inline ParameterRule free_axes(const char* match, Dimension dimension, double sd, double range) {
  ParameterRule rule;
  rule.match = match;
  rule.dimension = dimension;
  rule.state = ParameterState::kFree;
  rule.sd = sd;
  rule.between_sd = 0;
  rule.range = range;
  return rule;
}

/// The posterior's problem: 20 coordinates, forces of a thumb that differs from the prior means.
inline FitProblem thumb_problem(const ThumbScene& scene = {}) {
  const TendonDigit digit = build_tendon_digit(skewed_thumb(), "thumb");
  FitSettings settings;
  settings.rules = {free_axes("axis/*/direction/*", Dimension::kAngle, scene.tilt_sd, kPi / 2),
                    free_axes("axis/*/point/?", Dimension::kLength, scene.shift_sd, 0.2)};
  const FitParameters parameters = choose_parameters(digit, {}, settings);
  Experiment experiment = pinches(scene.noise);

  std::mt19937 rng(scene.seed);
  std::normal_distribution<double> normal;
  Eigen::VectorXd truth(parameters.coordinates());
  for (Eigen::Index c = 0; c < truth.size(); ++c)
    truth[c] = scene.spread * parameters.all[parameters.leader[c]].sd * normal(rng);
  const Eigen::Matrix3Xd force =
      force_values(digit, parameters, plan_experiment(digit, parameters, experiment), truth);
  for (std::size_t i = 0; i < experiment.trials.size(); ++i)
    for (int k = 0; k < 3; ++k)
      experiment.trials[i].force[k] =
          force(k, static_cast<Eigen::Index>(i)) + scene.noise * normal(rng);
  return {digit, parameters, {experiment}};
}

}  // namespace thenar::sample
