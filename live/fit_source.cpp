#include "live/fit_source.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "api/fit.h"
#include "api/named/files.h"
#include "api/posterior.h"
#include "base/lists.h"
#include "kinematics_fit/specimen_prior.h"
#include "posterior/hand_posterior.h"
#include "posterior/run/posterior_file.h"
#include "posterior/run/predict_draws.h"

namespace thenar {
namespace {

FitSource source_of_fit(const std::string& path) {
  const Fit fit = read_fit(path);
  FitSource source{path,
                   "fit",
                   parse_subject(fit.inputs.subject.text, fit.inputs.subject.path),
                   fit.problem,
                   {},
                   predict_own(fit),
                   checksum_warnings(path)};
  // Accept a fit that did not converge, with a warning.
  if (fit.solution.status != Status::kSolved)
    source.warnings.push_back("the fit did not converge: " + convergence_word(fit.solution));
  // Collect the fitted parameters of each specimen.
  for (std::size_t s = 0; s < fit.problem.specimens().size(); ++s)
    source.specimens.push_back(
        {parameter_values<double>(
             fit.problem.parameters(),
             displacements(fit.problem.coordinates(), fit.solution.z, static_cast<int>(s))),
         {},
         {}});
  return source;
}

/// Selects the axes of one specimen.
std::vector<PosteriorAxes> axes_of(const std::vector<PosteriorAxes>& all, const FitProblem& problem,
                                   std::size_t specimen) {
  // A single specimen has no name here; with several specimens, no name means the population.
  const std::vector<std::string>& names = problem.specimens();
  const std::string whose = names.size() > 1 ? names[specimen] : "";
  std::vector<PosteriorAxes> own;
  std::copy_if(all.begin(), all.end(), std::back_inserter(own),
               [&](const PosteriorAxes& axes) { return axes.whose == whose; });
  return own;
}

FitSource source_of_posterior(const std::string& path) {
  const PosteriorRun run = read_posterior(path);
  const HandPosterior& posterior = *run.posterior;
  const FitProblem& problem = posterior.problem();
  FitSource source{path,
                   "posterior",
                   parse_subject(run.inputs.subject.text, run.inputs.subject.path),
                   problem,
                   {},
                   {},
                   checksum_warnings(path)};
  append_all(source.warnings, run.convergence.warnings);
  // Collect the means of all draws, and at most kMaxShownDraws draws at equal intervals.
  const PosteriorValues values = posterior.values(pooled(run.draws));
  const std::vector<int> moving = posterior.moving_parameters();
  const std::vector<PosteriorAxes> axes = posterior_axes(run);
  for (const Eigen::MatrixXd& draws : values.specimens) {
    SpecimenValues specimen{values_with(problem.parameters(), moving, draws.rowwise().mean()),
                            {},
                            axes_of(axes, problem, source.specimens.size())};
    const Eigen::Index shown = std::min<Eigen::Index>(draws.cols(), kMaxShownDraws);
    for (Eigen::Index k = 0; k < shown; ++k)
      specimen.draws.push_back(
          values_with(problem.parameters(), moving, draws.col(k * draws.cols() / shown)));
    source.specimens.push_back(std::move(specimen));
  }
  // Predict the forces of all experiments, as predict_by_draws() does.
  for (const Experiment& experiment : problem.experiments())
    source.predictions.push_back(
        summarise(predict_draws(run, experiment, find_specimen(problem, experiment.specimen),
                                PosteriorPredictRequest().draws)));
  return source;
}

}  // namespace

FitSource read_fit_source(const std::string& path) {
  require_kind(path, {"fit", "posterior"});
  return contents_of(path).kind == "posterior" ? source_of_posterior(path) : source_of_fit(path);
}

}  // namespace thenar
