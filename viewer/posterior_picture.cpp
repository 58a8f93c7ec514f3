#include "viewer/posterior_picture.h"

#include "kinematics_fit/prediction.h"
#include "posterior/run/predict_draws.h"
#include "posterior/run/run_quantities.h"
#include "sampling/diagnostics/psis.h"

namespace thenar {
namespace {

constexpr long kPredictiveDraws = 2000;

std::vector<Quantity> quantities_of(const PosteriorRun& run,
                                    const std::map<std::string, double>& truth) {
  const std::vector<ReadQuantity> read = read_quantities(run);
  const std::vector<Estimate> estimates = estimates_of(read, run.draws.group);
  std::vector<Quantity> quantities;
  for (std::size_t i = 0; i < read.size(); ++i) {
    quantities.push_back({read[i].name,
                          read[i].unit,
                          read[i].draws,
                          run.draws.group,
                          estimates[i],
                          read[i].prior,
                          {}});
    if (const auto known = truth.find(read[i].name); known != truth.end())
      quantities.back().truth = known->second;
  }
  return quantities;
}

std::vector<AxisCloud> clouds_of(const PosteriorRun& run) {
  const FitProblem& problem = run.posterior->problem();
  const PosteriorValues values = run.posterior->values(pooled(run.draws));
  const std::vector<int> moving = run.posterior->moving_parameters();
  std::vector<AxisCloud> clouds;
  const auto add = [&](const std::string& name, const Eigen::MatrixXd& drawn) {
    clouds.push_back(axis_cloud(name, problem.digit(), problem.parameters(), moving, drawn));
  };
  if (problem.specimens().size() > 1) add("population", values.population);
  for (std::size_t s = 0; s < problem.specimens().size(); ++s)
    add(problem.specimens()[s], values.specimens[s]);
  return clouds;
}

std::vector<PredictedForces> predicted_of(const PosteriorRun& run) {
  std::vector<PredictedForces> predicted;
  for (const Experiment& experiment : run.posterior->problem().experiments()) {
    const int specimen = find_specimen(run.posterior->problem(), experiment.specimen);
    predicted.push_back({experiment,
                         predict_draws(run, experiment, specimen, kPredictiveDraws).replicated,
                         experiment.name + ", in sample"});
  }
  return predicted;
}

std::optional<LeftOut> left_out_of(const PosteriorRun& run) {
  const Eigen::MatrixXd pointwise = run.posterior->pointwise(pooled(run.draws));
  if (run.draws.draws() < 4 || !pointwise.allFinite()) return {};
  return LeftOut{leave_one_out(pointwise, run.draws.chains()),
                 observation_names(run.posterior->problem())};
}

}  // namespace

PosteriorPicture posterior_picture(const PosteriorRun& run, const std::string& title,
                                   const std::map<std::string, double>& truth) {
  const FitProblem& problem = run.posterior->problem();
  PosteriorPicture picture;
  picture.title = title;
  picture.quantities = quantities_of(run, truth);
  picture.convergence = run.convergence;
  picture.run = describe_run(run);
  picture.digit = problem.digit();
  picture.posture = problem.plans().front().postures.front();
  picture.clouds = clouds_of(run);
  picture.predicted = predicted_of(run);
  picture.modes = run.mode_table;
  picture.left_out = left_out_of(run);
  return picture;
}

}  // namespace thenar
