#include "studies/questions/fit_study.h"

#include "base/error.h"
#include "kinematics_fit/fit_residuals.h"

namespace thenar {
namespace {

/// Progress of a part, as a share of the whole.
Progress part_of(const Progress& whole, double begin, double share) {
  Progress part;
  part.stop_requested = whole.stop_requested;
  part.report = [&whole, begin, share](double fraction, const std::string& what) {
    whole(begin + share * fraction, what);
  };
  return part;
}

std::vector<BaselinePrediction> baselines_of(const StudyInputs& inputs,
                                             const Experiment& experiment) {
  // Published subjects, used as they are.
  std::vector<BaselinePrediction> baselines;
  for (const NamedSubject& baseline : inputs.baselines)
    baselines.push_back(
        {baseline.name, "as published", predict_as_published(baseline.source, experiment)});
  // A prediction without any model.
  baselines.push_back(
      {"Mean of other postures", "other postures", mean_of_other_postures(experiment)});
  return baselines;
}

std::vector<SolverRun> run_solvers(const FitProblem& problem, const StudyInputs& inputs,
                                   const Progress& progress) {
  std::vector<SolverRun> runs;
  for (std::size_t k = 0; k < inputs.methods.size(); ++k) {
    // Every solver starts at the prior means.
    SolveOptions options;
    options.method = inputs.methods[k];
    options.progress = part_of(progress, static_cast<double>(k) / inputs.methods.size(),
                               1.0 / static_cast<double>(inputs.methods.size()));
    Solution solution =
        solve(least_squares(problem), Eigen::VectorXd::Zero(problem.size()), options);
    const ForceError error = predict_fitted(problem, solution.z, 0).error;
    runs.push_back({options.method, std::move(solution), error});
  }
  return runs;
}

std::vector<Profile> profiles_of(const Fit& fit, const Progress& progress) {
  constexpr std::size_t kMaxProfiles = 4;  // Most coordinates, from the best known on
  ProfileOptions options;
  options.solver.progress = progress;
  std::vector<Profile> profiles;
  for (const int i : sorted_by_sd(fit.covariance)) {
    if (profiles.size() == kMaxProfiles) break;
    profiles.push_back(profile_likelihood(fit.problem, fit.solution.z, i, options));
  }
  return profiles;
}

}  // namespace

SpecimenStudy study_specimen(const StudyInputs& inputs, const SourceText& experiment,
                             const Progress& progress) {
  // Fit of this specimen alone, and its predictions in sample.
  FitInputs one = inputs.specimen;
  one.experiments = {experiment};
  Fit fit = run_fit(one);
  const Experiment& measured = fit.problem.experiments().front();
  Prediction in_sample =
      predict_experiment(fit.problem, fit.solution.z, fit.covariance.C, measured, 0);

  // Postures and tendons left out, then profiles, other solvers and baselines.
  SolveOptions options;
  options.progress = part_of(progress, 0, 0.1);
  CrossValidation postures = cross_validate(fit.problem, LeaveOut::kPosture, options);
  CrossValidation tendons = cross_validate(fit.problem, LeaveOut::kTendon, options);
  std::vector<Profile> profiles = profiles_of(fit, part_of(progress, 0.1, 0.1));
  std::vector<SolverRun> runs = run_solvers(fit.problem, inputs, part_of(progress, 0.2, 0.8));
  std::vector<BaselinePrediction> baselines = baselines_of(inputs, measured);
  return {std::move(fit),  std::move(in_sample), std::move(postures), std::move(tendons),
          std::move(runs), std::move(profiles),  std::move(baselines)};
}

PopulationStudy study_population(const StudyInputs& inputs, const Progress& progress) {
  // Fit of all specimens together.
  FitInputs together = inputs.specimen;
  together.subject = inputs.population_subject;
  SolveOptions options;
  options.progress = part_of(progress, 0, 0.3);
  Fit fit = run_fit(together, options);

  // Predictions of each by its own parameters, and as if it had not been fitted.
  std::vector<Prediction> own, as_unseen;
  std::vector<UnseenSpecimen> unseen;
  const auto predict = [&](const Experiment& experiment, int specimen) {
    return predict_experiment(fit.problem, fit.solution.z, fit.covariance.C, experiment, specimen);
  };
  for (const Experiment& experiment : fit.problem.experiments()) {
    own.push_back(predict(experiment, find_specimen(fit.problem, experiment.specimen)));
    as_unseen.push_back(predict(experiment, kUnfittedSpecimen));
  }

  // Experiments that were not fitted.
  for (const SourceText& source : inputs.unseen) {
    const Experiment experiment = parse_experiment(source.text, source.path);
    unseen.push_back({experiment.specimen, predict(experiment, kUnfittedSpecimen),
                      baselines_of(inputs, experiment)});
  }

  // Refits without each specimen.
  options.progress = part_of(progress, 0.3, 0.7);
  CrossValidation specimens = cross_validate(fit.problem, LeaveOut::kSpecimen, options);
  return {std::move(fit), std::move(own), std::move(as_unseen), std::move(specimens),
          std::move(unseen)};
}

}  // namespace thenar
