#include "posterior/run/posterior_groups.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <type_traits>

#include "kinematics_fit/prediction.h"
#include "posterior/hand_posterior.h"
#include "posterior/run/posterior_quantities.h"
#include "posterior/run/predict_draws.h"

namespace thenar::internal {
namespace {

constexpr long kPredictedDraws = 1000;  // maximum number of replicated draws of each chain
// Maximum number of replicated draws of all chains, with at least one of each
constexpr long kAllPredicted = 20000;

/// Returns the largest number of components of a force that any experiment fits.
int largest_component_count(const FitProblem& problem) {
  int max_components = 0;
  for (const ExperimentPlan& plan : problem.plans())
    max_components = std::max(max_components, plan.measured);
  return max_components;
}

std::vector<std::string> component_names(const FitProblem& problem) {
  const std::vector<std::string> names{"first", "second", "third"};
  return {names.begin(), names.begin() + largest_component_count(problem)};
}

/// Returns the components that any experiment fits, NaN where the trial's own experiment does not.
/// @param all  three numbers of every trial of every experiment in turn (3 trials, columns)
Eigen::MatrixXd fitted_components(const FitProblem& problem, const Eigen::MatrixXd& all) {
  const int components = largest_component_count(problem);
  Eigen::MatrixXd kept(all.rows() / 3 * components, all.cols());
  Eigen::Index from = 0, to = 0;
  for (const ExperimentPlan& plan : problem.plans())
    for (Eigen::Index i = 0; i < plan.force.cols(); ++i, from += 3, to += components) {
      kept.middleRows(to, components) = all.middleRows(from, components);
      kept.middleRows(to + plan.measured, components - plan.measured)
          .setConstant(std::numeric_limits<double>::quiet_NaN());
    }
  return kept;
}

/// Flattens `values`, stored chain by chain, to an array over chains, draws and rows.
/// @param values  (rows, chains * draws)
std::vector<double> by_draw(const Eigen::MatrixXd& values) {
  return {values.data(),
          values.data() + values.size()};  // column by column: the last index varies fastest
}

void add_draws(InferenceGroup& group, int chains, long draws) {
  group.lengths["chain"] = static_cast<std::size_t>(chains);
  group.lengths["draw"] = static_cast<std::size_t>(draws);
}

void add_names(InferenceGroup& group, const std::string& dimension,
               const std::vector<std::string>& names) {
  group.lengths[dimension] = names.size();
  group.coordinates[dimension] = names;
}

/// Returns the rows of `all` of one family, in display units.
Eigen::MatrixXd family_rows(const Eigen::MatrixXd& all, const std::vector<Eigen::Index>& rows,
                            double scale) {
  Eigen::MatrixXd picked(static_cast<Eigen::Index>(rows.size()), all.cols());
  for (Eigen::Index i = 0; i < picked.rows(); ++i) picked.row(i) = scale * all.row(rows[i]);
  return picked;
}

/// Parameters of one kind, which share a unit.
struct Family {
  std::string name, unit;
  double scale = 1;
  std::vector<std::string> members;
  std::vector<Eigen::Index> rows;  // rows of PosteriorValues::population
};

/// Groups the moving parameters by kind.
std::vector<Family> families(const HandPosterior& posterior) {
  std::vector<Family> found;
  const std::vector<int> moving = posterior.moving_parameters();
  for (std::size_t row = 0; row < moving.size(); ++row) {
    // Convert kinds to names of variables.
    const Parameter& p = posterior.problem().parameters().all[moving[row]];
    std::string name = name_of(p.kind);
    std::replace(name.begin(), name.end(), '/', '_');
    // Find or add the family of this kind.
    auto family =
        std::find_if(found.begin(), found.end(), [&](const Family& f) { return f.name == name; });
    if (family == found.end())
      family = found.insert(found.end(), {name, display_unit(p), display_scale(p), {}, {}});
    family->members.push_back(p.name);
    family->rows.push_back(static_cast<Eigen::Index>(row));
  }
  return found;
}

/// Stacks the specimens within each draw (specimens * rows, points).
Eigen::MatrixXd stacked(const std::vector<Eigen::MatrixXd>& specimens, const Family& family) {
  const auto rows = static_cast<Eigen::Index>(family.rows.size());
  Eigen::MatrixXd all(rows * static_cast<Eigen::Index>(specimens.size()), specimens[0].cols());
  for (std::size_t s = 0; s < specimens.size(); ++s)
    all.middleRows(static_cast<Eigen::Index>(s) * rows, rows) =
        family_rows(specimens[s], family.rows, family.scale);
  return all;
}

void add_factors(InferenceGroup& group, const std::string& name, const std::string& dimension,
                 const std::vector<std::string>& names, const Eigen::MatrixXd& factors,
                 const std::string& description) {
  if (factors.rows() == 0) return;
  add_names(group, dimension, names);
  group.arrays[name] = {by_draw(factors), {"chain", "draw", dimension}, "1", description};
}

/// Adds a number of every component of every trial, from the plans of the experiments.
void add_readings(const FitProblem& problem, const std::string& name,
                  Eigen::Matrix3Xd ExperimentPlan::*readings, const std::string& description,
                  InferenceGroup& group) {
  // Set the dimensions, and concatenate all experiments.
  add_names(group, "trial", observation_names(problem, Observed::kForces));
  add_names(group, "component", component_names(problem));
  Eigen::VectorXd all(0);
  for (const ExperimentPlan& plan : problem.plans()) {
    const Eigen::VectorXd own = (plan.*readings).reshaped();
    all.conservativeResize(all.size() + own.size());
    all.tail(own.size()) = own;
  }
  group.arrays[name] = {
      by_draw(fitted_components(problem, all)), {"trial", "component"}, "N", description};
}

}  // namespace

InferenceGroup parameter_group(const HandPosterior& posterior, const Eigen::MatrixXd& x,
                               int chains) {
  // Compute values in display units.
  InferenceGroup group;
  add_draws(group, chains, x.cols() / chains);
  const PosteriorValues values = posterior.values(x);
  add_names(group, "specimen", posterior.problem().specimens());
  for (const Family& family : families(posterior)) {
    const std::string dimension = family.name + "_parameter";
    add_names(group, dimension, family.members);
    // A single specimen determines its population's values, but not their uncertainty.
    if (values.specimens.size() > 1)
      group.arrays[family.name] = {
          by_draw(family_rows(values.population, family.rows, family.scale)),
          {"chain", "draw", dimension},
          family.unit,
          "of the population"};
    group.arrays[family.name + "_specimen"] = {by_draw(stacked(values.specimens, family)),
                                               {"chain", "draw", "specimen", dimension},
                                               family.unit,
                                               "of each specimen"};
  }
  // Add factors of noise and between specimens if they are inferred.
  if (posterior.options().learn_noise)
    add_factors(group, "noise", "experiment", experiment_names(posterior.problem()), values.noise,
                "factor on the stated sd of the forces");
  add_factors(group, "spread", "spread_kind", posterior.specimen_scale_kinds(),
              values.specimen_scale, "factor on the sd between specimens");
  return group;
}

InferenceGroup coordinate_group(const PosteriorRun& run) {
  InferenceGroup group;
  add_draws(group, run.draws.chains(), run.draws.draws());
  add_names(group, "coordinate", run.posterior->names());
  group.arrays["x"] = {by_draw(pooled(run.draws)),
                       {"chain", "draw", "coordinate"},
                       "1",
                       "as sampled: unbounded, in prior sds"};
  return group;
}

InferenceGroup statistics_group(const PosteriorRun& run) {
  InferenceGroup group;
  add_draws(group, run.draws.chains(), run.draws.draws());
  // Add one array over all chains for each field.
  const auto add = [&](const std::string& name, const std::string& description,
                       const std::function<double(const StepStats&)>& pick) -> InferenceArray& {
    std::vector<double> values;
    for (const std::vector<StepStats>& chain : run.draws.stats)
      for (const StepStats& step : chain) values.push_back(pick(step));
    return group.arrays[name] = {std::move(values), {"chain", "draw"}, "1", description};
  };

  // Densities.
  add("lp", "log posterior", [](const StepStats& s) { return s.log_prior + s.log_likelihood; });
  each_step_field([&](const char* name, const char* description, auto StepStats::*field) {
    InferenceArray& array = add(name, description, [&](const StepStats& s) { return s.*field; });
    using Value = std::decay_t<decltype(StepStats().*field)>;
    array.integer = std::is_same_v<Value, int>;
    array.boolean = std::is_same_v<Value, bool>;
  });
  return group;
}

InferenceGroup likelihood_group(const PosteriorRun& run) {
  InferenceGroup group;
  add_draws(group, run.draws.chains(), run.draws.draws());
  // Trials.
  const Eigen::MatrixXd pointwise = run.posterior->pointwise(pooled(run.draws));
  const std::vector<std::string> trials =
      observation_names(run.posterior->problem(), Observed::kForces);
  const auto count = static_cast<Eigen::Index>(trials.size());
  add_names(group, "trial", trials);
  group.arrays["force"] = {by_draw(pointwise.topRows(count)),
                           {"chain", "draw", "trial"},
                           "1",
                           "log likelihood of the components of a trial together"};
  if (pointwise.rows() == count) return group;
  // Rows of muscle activations follow the trials.
  const std::vector<std::string> all = observation_names(run.posterior->problem());
  add_names(group, "activation_row", {all.begin() + count, all.end()});
  group.arrays["activation"] = {by_draw(pointwise.bottomRows(pointwise.rows() - count)),
                                {"chain", "draw", "activation_row"},
                                "1",
                                "log likelihood of a row of muscle activations"};
  return group;
}

InferenceGroup predictive_group(const PosteriorRun& run) {
  InferenceGroup group;
  // Use fewer draws of each chain if there are many chains.
  const long draws_per_chain = std::clamp(kAllPredicted / run.draws.chains(), 1L, kPredictedDraws);
  const Eigen::MatrixXd x = thinned(pooled(run.draws), draws_per_chain * run.draws.chains());
  const long draws = x.cols() / run.draws.chains();
  add_draws(group, run.draws.chains(), draws);
  add_names(group, "trial", observation_names(run.posterior->problem(), Observed::kForces));
  const FitProblem& problem = run.posterior->problem();
  add_names(group, "component", component_names(problem));
  group.arrays["force"] = {
      by_draw(fitted_components(
          problem, replicated_forces(*run.posterior, x, run.settings.run.sampler.seed))),
      {"chain", "draw", "trial", "component"},
      "N",
      "what a repeated measurement would read; draws evenly thinned"};
  return group;
}

InferenceGroup observed_group(const PosteriorRun& run) {
  InferenceGroup group;
  add_readings(run.posterior->problem(), "force", &ExperimentPlan::force, "measured", group);
  return group;
}

InferenceGroup noise_group(const PosteriorRun& run) {
  InferenceGroup group;
  add_readings(run.posterior->problem(), "force_sd", &ExperimentPlan::sd, "as stated", group);
  return group;
}

InferenceGroup mode_group(const PosteriorRun& run) {
  InferenceGroup group;
  // Store modes as columns, with the results of the search.
  Eigen::MatrixXd x(run.posterior->size(), static_cast<Eigen::Index>(run.modes.size()));
  std::vector<double> cost, hits, mass;
  for (std::size_t m = 0; m < run.modes.size(); ++m) {
    x.col(static_cast<Eigen::Index>(m)) = run.posterior->from_fit_coordinates(run.modes[m].z);
    cost.push_back(run.modes[m].cost);
    hits.push_back(run.modes[m].hits);
    mass.push_back(run.modes[m].laplace_mass);
  }
  group.lengths["mode"] = run.modes.size();
  add_names(group, "coordinate", run.posterior->names());
  group.arrays["x"] = {by_draw(x), {"mode", "coordinate"}, "1", "where the mode is"};
  group.arrays["cost"] = {cost, {"mode"}, "1", "half the sum of squares there"};
  group.arrays["hits"] = {hits, {"mode"}, "1", "searches that ended there", true};
  group.arrays["laplace_mass"] = {mass, {"mode"}, "1", "share by Laplace's approximation"};
  return group;
}

}  // namespace thenar::internal
