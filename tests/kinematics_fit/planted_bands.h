#pragma once

/// A finger whose extensor hood is known but for some bands, slack lengths and lateral places: made
/// up truths, the forces that they make, and what both ways of telling bands say of them.

#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "data/io/net_description.h"
#include "kinematics_fit/bands/band_problems.h"
#include "kinematics_fit/bands/net_records.h"
#include "kinematics_fit/bands/rank_trials.h"
#include "kinematics_fit/specimen_prior.h"
#include "tendons/net/build_tendons.h"
#include "tests/kinematics_fit/fit_samples.h"

namespace thenar::planted {

inline constexpr double kFloor = 0.02, kRelative = 0.02;  // noise: [N], [1]

/// What may take the place of a band: slack lengths beside it and lateral places of attachments.
inline const std::string kSlackAndPlaces = R"(
[[parameter]]
match = "net/crossing_*/slack"
optional = "yes"
state = "free"
[[parameter]]
match = "net/transverse_*/slack"
optional = "yes"
state = "free"
[[parameter]]
match = "net/extensor_lateral_*/slack"
optional = "yes"
state = "free"
[[parameter]]
match = "net/dorsal_plate/radial"
optional = "yes"
state = "free"
[[parameter]]
match = "net/central_insertion_*/radial"
optional = "yes"
state = "free"
[[parameter]]
match = "hold/out_of_plane"
mean_mm = 39
)";

/// The same places and slack lengths known; the out-of-plane length stands in for a free number.
inline const std::string kKnown = R"(
[[parameter]]
match = "hold/out_of_plane"
state = "free"
mean_mm = 39
sd_mm = 0.01
between_sd_mm = 0
)";

/// Trials of the net's muscles in two postures.
inline Experiment experiment() {
  Experiment out = sample::experiment("H01");
  out.sd_floor = kFloor;
  out.sd_relative = kRelative;
  out.postures.resize(2);
  out.trials.clear();
  for (const PostureRecord& posture : out.postures)
    for (const auto& tension : std::vector<std::map<std::string, double>>{
             {{"EDC", 3}}, {{"EDC", 2}, {"UI", 3}}, {{"RI", 4}}, {{"RI", 3}, {"UI", 3}}}) {
      Trial trial;
      trial.posture = posture.name;
      trial.tension = tension;
      out.trials.push_back(trial);
    }
  return out;
}

inline TendonDigit digit() {
  const SourceText text = sample::source("subjects/an_chao_middle");
  const SourceText net = sample::source("nets/extensor_hood");
  const Subject subject = parse_subject(text.text, text.path);
  TendonOptions separate;
  separate.hood = Hood::kSeparate;
  TendonDigit digit = build_tendon_digit(subject, "middle", separate);
  digit.net =
      std::make_shared<const BuiltNet>(build_net(subject, digit, parse_net(net.text, net.path)));
  return digit;
}

inline BandProblems problems(const Experiment& experiment, const std::vector<std::string>& bands,
                             const std::string& rows = kSlackAndPlaces) {
  const TendonDigit built = digit();
  const FitSettings settings = sample::settings(rows);
  FitProblem all(built, choose_parameters(built, sample::postures_of(experiment), settings),
                 {experiment});
  return {std::move(all), settings, {}, bands};
}

/// A truth: which bands exist, where its parameters are, and the forces that it makes.
struct Truth {
  Topology bands;
  Eigen::VectorXd z;
};

/// Bands with chance 1/2 and parameters from their priors, until the net carries the loads.
inline Truth draw_truth(const BandProblems& problems, std::mt19937& random) {
  for (;;) {
    Truth truth;
    for (std::size_t b = 0; b < problems.bands().size(); ++b)
      truth.bands.push_back(std::bernoulli_distribution(0.5)(random));
    const FitProblem problem = problems.problem_with(truth.bands);
    truth.z = sample::normal(problem.size(), random);
    if (carries_loads(problem, truth.z)) return truth;
  }
}

/// Readings of a truth in the trials of an experiment, with noise.
inline Experiment measured(const BandProblems& problems, const Truth& truth, Experiment experiment,
                           std::mt19937& random) {
  const FitProblem problem = problems.problem_with(truth.bands);
  const ExperimentPlan plan = plan_experiment(problem.digit(), problem.parameters(), experiment);
  const Eigen::Matrix3Xd force = force_values(problem.digit(), problem.parameters(), plan,
                                              displacements(problem.coordinates(), truth.z, 0));
  for (std::size_t i = 0; i < experiment.trials.size(); ++i) {
    Trial& trial = experiment.trials[i];
    const Eigen::Vector3d exact = force.col(static_cast<Eigen::Index>(i));
    trial.sd = Eigen::Vector3d::Constant(std::hypot(kFloor, kRelative * exact.norm()));
    trial.force = exact + trial.sd->cwiseProduct(Eigen::Vector3d(sample::normal(3, random)));
  }
  return experiment;
}

/// Verdicts with slack lengths and places held: chi^2 with and without a band, as `tendon infer`
/// does without --free.
inline std::vector<BandVerdict> verdicts_when_held(const Experiment& experiment,
                                                   const std::vector<std::string>& bands) {
  const SourceText text = sample::source("subjects/an_chao_middle");
  const SourceText net = sample::source("nets/extensor_hood");
  TendonOptions options;
  options.hood = Hood::kFloatingNet;
  const NetDescription description = parse_net(net.text, net.path);
  const auto tendons =
      build_digit_tendons(parse_subject(text.text, text.path), "middle", options, &description);
  const auto& netted = dynamic_cast<const NetTendons&>(*tendons);
  CandidateNet candidate = candidate_of(netted);
  std::vector<CandidateBand> asked;
  for (const std::string& band : bands)
    for (const CandidateBand& each : candidate.candidates)
      if (candidate.net.bands[static_cast<std::size_t>(each.band)].name == band)
        asked.push_back(each);
  candidate.candidates = asked;
  BandFitter fitter(candidate, net_records(netted, experiment));
  FittedNets tried(fitter);
  const auto n = static_cast<Eigen::Index>(bands.size());
  (void)tried.fit(Topology(bands.size(), true), Eigen::VectorXd::Ones(n));
  return assess_bands(tried).verdicts;
}

}  // namespace thenar::planted
