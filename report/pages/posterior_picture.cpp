#include "report/pages/posterior_picture.h"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "kinematics_fit/prediction.h"
#include "posterior/run/posterior_summary.h"
#include "posterior/run/predict_draws.h"

namespace thenar {
namespace {

constexpr long kPredictiveDraws = 2000;
constexpr std::size_t kDoubtful = 8;  // quantities shown for their R-hat

/// Which quantities to show, in their order: the most doubtful, and those most was learnt about.
std::vector<std::size_t> chosen(const std::vector<PosteriorQuantity>& quantities,
                                const std::vector<Estimate>& estimates, std::size_t most) {
  std::vector<std::size_t> order(quantities.size());
  std::iota(order.begin(), order.end(), 0);
  if (order.size() <= most) return order;
  const auto sort_from = [&](std::size_t first, auto&& figure) {
    std::stable_sort(order.begin() + static_cast<std::ptrdiff_t>(first), order.end(),
                     [&](std::size_t a, std::size_t b) { return figure(a) < figure(b); });
  };
  sort_from(0, [&](std::size_t i) { return -estimates[i].r_hat; });
  sort_from(std::min(kDoubtful, most),
            [&](std::size_t i) { return estimates[i].sd / prior_sd(quantities[i]); });
  order.resize(most);
  std::sort(order.begin(), order.end());
  return order;
}

/// Adds the quantities, and says which of all they are.
void add_quantities(const PosteriorRun& run, const PictureOptions& options,
                    PosteriorPicture& picture) {
  const std::vector<PosteriorQuantity> read = posterior_quantities(run);
  const std::vector<Estimate> estimates = estimates_of(read, run.draws.group);
  for (const std::size_t i : chosen(read, estimates, options.most)) {
    picture.quantities.push_back({read[i].name,
                                  read[i].unit,
                                  read[i].draws,
                                  run.draws.group,
                                  estimates[i],
                                  read[i].prior,
                                  {}});
    if (const auto known = options.truth.find(read[i].name); known != options.truth.end())
      picture.quantities.back().truth = known->second;
  }
  picture.run = describe_run(run);
  if (picture.quantities.size() < read.size())
    picture.run += fmt::format(
        ". Of {} quantities the {} are shown that most was learnt about, or that have the largest "
        "R-hat",
        read.size(), picture.quantities.size());
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
                         experiment.name + ", in sample" +
                             (calibrated_on_specimen(run.posterior->problem().digit(), experiment)
                                  ? "; the subject of the prior has seen this specimen"
                                  : "")});
  }
  return predicted;
}

}  // namespace

PosteriorPicture posterior_picture(const PosteriorRun& run, const PictureOptions& options) {
  const FitProblem& problem = run.posterior->problem();
  PosteriorPicture picture;
  picture.title = options.title;
  picture.prefix = options.prefix;
  picture.convergence = run.convergence;
  picture.warnings = problem.warnings();
  add_quantities(run, options, picture);
  picture.digit = problem.digit();
  picture.posture = problem.plans().front().postures.front();
  picture.clouds = clouds_of(run);
  picture.predicted = predicted_of(run);
  picture.modes = run.mode_table;
  picture.left_out = leave_out_observations(run);
  return picture;
}

}  // namespace thenar
