#pragma once

/// Digits, parameters and experiments of every kind that a force kernel must know.

#include "tests/kinematics_fit/fit_samples.h"

namespace thenar::sample {

/// What a force kernel is built from.
struct KernelCase {
  TendonDigit digit;
  FitParameters parameters;
  ExperimentPlan plan;
};

inline KernelCase kernel_case(const FitProblem& problem) {
  return {problem.digit(), problem.parameters(), problem.plans().front()};
}

/// Prior sd of every coordinate, of a specimen where the population has none [SI].
inline Eigen::VectorXd prior_sd(const KernelCase& c) {
  Eigen::VectorXd sd(c.parameters.coordinates());
  for (Eigen::Index k = 0; k < sd.size(); ++k) {
    const Parameter& p = c.parameters.all[c.parameters.leader[k]];
    sd[k] = std::hypot(p.sd, p.between_sd);
  }
  return sd;
}

/// A random u, `spread` prior sds from the means [SI].
inline Eigen::VectorXd displacement(const KernelCase& c, double spread, std::mt19937& rng) {
  const Eigen::VectorXd sd = prior_sd(c);
  return spread * sd.cwiseProduct(normal(sd.size(), rng));
}

inline bool moves(const KernelCase& c, ParameterKind kind) {
  for (std::size_t p = 0; p < c.parameters.all.size(); ++p)
    if (c.parameters.all[p].kind == kind && c.parameters.coordinate[p] >= 0) return true;
  return false;
}

inline KernelCase measured_finger(const std::string& subject, const std::string& specimen) {
  return kernel_case(build_problem(finger_inputs(subject, {specimen})));
}

/// The measured finger with these rows of settings, its forces stated in `segment`.
inline KernelCase finger_with(const std::string& rows, const std::string& segment = "DP3") {
  FitSetup setup = middle_finger(rows);
  Experiment experiment = setup.experiments.front();
  experiment.force_segment = segment;
  const ExperimentPlan plan = plan_experiment(setup.digit, setup.parameters, experiment);
  return {setup.digit, setup.parameters, plan};
}

inline std::string free_row(const std::string& glob, const std::string& more = "") {
  return "[[parameter]]\nmatch = '" + glob + "'\noptional = 'yes'\nstate = 'free'\n" + more;
}

inline KernelCase one_kind_free(const std::string& glob) { return finger_with(free_row(glob)); }

/// Friction and out-of-plane moments from means that are not zero, forces stated in another bone.
inline KernelCase everything_free() {
  return finger_with(free_row("*") +
                         "[[parameter]]\nmatch = 'friction/*'\nmean = 0.05\n"
                         "[[parameter]]\nmatch = 'hold/out_of_plane'\nmean_mm = 15\n",
                     "PP3");
}

/// How a thumb is held, and where its forces are stated.
struct Held {
  const char* name;
  TipConstraint hold;
  double out_of_plane;  // [mm]
  int force_link;       // -1: the base; -2: the tip's
};

inline std::vector<Held> ways_to_hold() {
  return {{"pinned", TipConstraint::kPinned, 0, -2},
          {"pinned, forces in the base", TipConstraint::kPinned, 0, -1},
          {"rigid", TipConstraint::kRigid, 0, -2},
          {"rigid, out of plane", TipConstraint::kRigid, 20, -2},
          {"rigid, forces between", TipConstraint::kRigid, 20, 1}};
}

/// A thumb of data/ with the thumb's settings and more, in two random postures, each muscle pulling
/// in each.
inline KernelCase held_thumb(const std::string& subject, const Held& held, std::mt19937& rng) {
  const SourceText text = source("subjects/" + subject), fits = source("fits/thumb");
  KernelCase c{build_tendon_digit(parse_subject(text.text, text.path), "thumb"), {}, {}};
  FitSettings rules = parse_fit_settings(fits.text, fits.path);
  for (const char* glob : {"friction/*", "gain/*", "tip/*", "sensor/*", "angle/*", "length/*"}) {
    ParameterRule rule;
    rule.match = glob;
    rule.state = ParameterState::kFree;
    rules.rules.push_back(rule);
  }
  ParameterRule out;
  out.match = "hold/out_of_plane";
  out.dimension = Dimension::kLength;
  out.mean = 1e-3 * held.out_of_plane;
  if (held.out_of_plane > 0) out.state = ParameterState::kFree;
  rules.rules.push_back(out);
  c.parameters = choose_parameters(c.digit, {"first"}, rules);

  const int n = c.digit.model.coordinates, muscles = static_cast<int>(c.digit.model.pulls.size());
  c.plan.hold = held.hold;
  c.plan.force_link = held.force_link == -2 ? c.digit.model.tip_link : held.force_link;
  c.plan.components << 0, 0, 1, -1, 0, 0, 0, 1, 0;
  for (int k = 0; k < 2; ++k) {
    std::uniform_real_distribution<double> angle(0.1, 0.6);
    c.plan.postures.emplace_back(Eigen::VectorXd::NullaryExpr(n, [&] { return angle(rng); }));
    c.plan.posture_key.push_back(k == 0 ? 0 : -1);
    for (int m = 0; m < muscles; ++m) {
      c.plan.posture_of_trial.push_back(k);
      c.plan.tension.emplace_back(10 * Eigen::VectorXd::Unit(muscles, m));
    }
  }
  c.plan.force = c.plan.sd = Eigen::Matrix3Xd::Zero(3, 2 * muscles);
  return c;
}

}  // namespace thenar::sample
