#include "report/pages/posterior.h"

#include <algorithm>
#include <cctype>
#include <numeric>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "kinematics_fit/prediction.h"
#include "posterior/hand_posterior.h"
#include "posterior/run/predict_draws.h"
#include "report/draws/chains.h"
#include "report/pages/prediction.h"
#include "report/parameter_words.h"
#include "report/sampling_advice.h"

namespace thenar {
namespace {

const char* const kNotConverged = "This run has NOT converged";

/// "H01: what was learnt", or "What was learnt" where there is but one posterior.
std::string titled(const PosteriorPicture& picture, std::string text) {
  if (!picture.title.empty()) return picture.title + ": " + text;
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

void add(const PosteriorPicture& picture, const std::string& id, const std::string& title,
         const std::string& text, Json blocks, Json& sections) {
  if (blocks.empty()) return;
  // A reader may come by a link to any section.
  if (!sections.empty() && !picture.convergence.warnings.empty()) {
    const Json warning{{"type", "banner"}, {"ok", false}, {"title", kNotConverged}};
    blocks.insert(blocks.begin(), warning);
  }
  sections.push_back(section(id, titled(picture, title), text, std::move(blocks)));
}

/// A banner of warnings, if there are any.
void add_doubts(const std::string& title, const std::vector<std::string>& warnings, Json& blocks) {
  if (!warnings.empty()) blocks.push_back(banner_block(title, warnings));
}

Json convergence_blocks(const PosteriorPicture& picture) {
  // Convergence first: without it no number below may be used.
  Json blocks = Json::array({convergence_banner(picture.convergence, picture.run)});
  for (const std::string& advice : picture.advice) blocks.push_back(text_block(advice));
  if (!picture.warnings.empty()) blocks.push_back(caution_banner(picture.warnings));
  if (picture.quantities.empty()) return blocks;
  // Show the chains themselves, the largest R-hat first.
  blocks.push_back(chains_block(
      picture.quantities,
      "Chains after warm-up, the largest R-hat first. Left: the draws in order. Right: how many of "
      "each chain's ranks among all draws fall into each twentieth, over the band that holds 95 % "
      "of such counts. Below: how long a chain remembers"));
  blocks.push_back(
      estimate_table(picture.quantities,
                     "Estimates with their Monte Carlo standard errors, the largest R-hat "
                     "first"));
  return blocks;
}

Json learnt_blocks(const PosteriorPicture& picture) {
  Json blocks = Json::array();
  Json forest = forest_block(
      picture.quantities,
      "50 % (thick) and 90 % (thin) intervals in prior sds over the prior's (grey), the best known "
      "first. At the right mean and sd; learnt is by how much the sd shrank");
  if (!forest["rows"].empty()) blocks.push_back(std::move(forest));
  if (picture.quantities.size() > 1)
    blocks.push_back(corner_block(
        picture.quantities,
        "Densities of single quantities and of pairs: regions that hold 50 and 90 % of the draws, "
        "and the draws outside"));
  return blocks;
}

Json axis_blocks(const PosteriorPicture& picture) {
  if (!picture.digit || picture.clouds.empty()) return Json::array();
  return Json::array({axis_cloud_picture(
      *picture.digit, picture.posture, picture.clouds, {},
      "Every line is an axis at one draw, through the point nearest to the bones; the axes before "
      "the fit are named")});
}

Json forces_blocks(const PosteriorPicture& picture) {
  // Predicted beside measured forces of every experiment.
  Json blocks = list_of_each(picture.predicted, predictive_block);
  // Show Pareto k, which marks unreliable leave-one-out estimates.
  if (picture.left_out) {
    const std::vector<std::string>& doubts = picture.left_out->result.warnings;
    add_doubts("Leaving observations out is doubtful", doubts, blocks);
    if (!doubts.empty()) {
      blocks.back()["caution"] = true;
      blocks.back()["text"] =
          "Only this estimate of how forces would be predicted unseen is in doubt, not the draws. "
          "A fit "
          "with --cross-validate leaves postures, tendons or specimens out for good";
    }
    blocks.push_back(pareto_chart(*picture.left_out));
  }
  return blocks;
}

Json mode_blocks(const PosteriorPicture& picture) {
  Json blocks = Json::array();
  add_doubts("The shares of the modes are not to be trusted", picture.modes->warnings, blocks);
  blocks.push_back(mode_table(*picture.modes, picture.quantities));
  return blocks;
}

constexpr long kPredictiveDraws = 2000;
constexpr std::size_t kDoubtfulQuantities = 8;  // Most quantities shown for their R-hat

/// Selects the quantities to show, in their order: those with the largest R-hat, and those that the
/// data determine best.
std::vector<std::size_t> chosen(const std::vector<PosteriorQuantity>& quantities,
                                const std::vector<Estimate>& estimates, std::size_t most) {
  std::vector<std::size_t> order(quantities.size());
  std::iota(order.begin(), order.end(), 0);
  if (order.size() <= most) return order;
  // Sort by R-hat, then keep of the rest what the data determine best.
  const auto sort_from = [&](std::size_t first, auto&& figure) {
    std::stable_sort(order.begin() + static_cast<std::ptrdiff_t>(first), order.end(),
                     [&](std::size_t a, std::size_t b) { return figure(a) < figure(b); });
  };
  sort_from(0, [&](std::size_t i) { return -estimates[i].r_hat; });
  sort_from(std::min(kDoubtfulQuantities, most),
            [&](std::size_t i) { return estimates[i].sd / prior_sd(quantities[i]); });
  order.resize(most);
  std::sort(order.begin(), order.end());
  return order;
}

/// Adds the quantities, and says which of all they are.
void add_quantities(const PosteriorRun& run, const PictureOptions& options,
                    PosteriorPicture& picture) {
  // Quantities in display units, with their prior and meaning.
  const std::vector<PosteriorQuantity> read = posterior_quantities(run);
  const std::vector<Estimate> estimates = estimates_of(read, run.draws.group);
  for (std::string& warning : noise_warnings(read, estimates))
    picture.warnings.push_back(std::move(warning));
  const TendonDigit& digit = run.posterior->problem().digit();
  for (const std::size_t i : chosen(read, estimates, options.max_quantities)) {
    picture.quantities.push_back({read[i].name,
                                  read[i].unit,
                                  read[i].draws,
                                  run.draws.group,
                                  estimates[i],
                                  read[i].prior,
                                  {},
                                  meaning_of(read[i].name, digit)});
  }
  // Say which quantities are shown, if not all are.
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
  const FitProblem& problem = run.posterior->problem();
  return transformed(problem.experiments(), [&](const Experiment& experiment) {
    const int specimen = find_specimen(problem, experiment.specimen);
    return PredictedForces{experiment,
                           predict_draws(run, experiment, specimen, kPredictiveDraws).replicated,
                           experiment.name + ", in sample" +
                               (calibrated_on_specimen(problem.digit(), experiment)
                                    ? "; the subject of the prior has seen this specimen"
                                    : "")};
  });
}

}  // namespace

PosteriorPicture posterior_picture(const PosteriorRun& run, const PictureOptions& options) {
  const FitProblem& problem = run.posterior->problem();
  // Convergence and advice, then quantities, axes, forces and modes.
  PosteriorPicture picture;
  picture.title = options.title;
  picture.convergence = run.convergence;
  picture.warnings = problem.warnings();
  for (const SamplingAdvice& one : advise(run))
    picture.advice.push_back("What may help: " + one.remedy +
                             (one.command.empty() ? "" : ": " + one.command));
  add_quantities(run, options, picture);
  picture.digit = problem.digit();
  picture.posture = problem.plans().front().postures.front();
  picture.clouds = clouds_of(run);
  picture.predicted = predicted_of(run);
  picture.modes = run.mode_table;
  picture.left_out = leave_out_observations(run);
  return picture;
}

Json convergence_banner(const Convergence& convergence, const std::string& run) {
  const std::string figures =
      fmt::format("Largest R-hat {:.4f}, least bulk ESS {:.0f}, least tail ESS {:.0f}. {}",
                  convergence.worst_r_hat, convergence.min_bulk_ess, convergence.min_tail_ess, run);
  // Chains that disagree void all numbers; cautions do not.
  if (!convergence.warnings.empty())
    return with(
        banner_block(kNotConverged, convergence.warnings),
        {{"text",
          "No number of this posterior may be relied on: chains that disagree, or remember too "
          "long, do not describe the distribution that they sample. " +
              run}});
  const Json banner =
      with(banner_block("The chains agree", convergence.cautions, true), {{"text", figures}});
  if (convergence.cautions.empty()) return banner;
  return with(banner, {{"title", "The chains agree, with a caution"}, {"caution", true}});
}

Json posterior_sections(const PosteriorPicture& picture) {
  // From doubts to results: convergence, modes, parameters, axes, forces.
  Json sections = Json::array();
  add(picture, "convergence", "has the sampler converged?", "", convergence_blocks(picture),
      sections);
  if (picture.modes) add(picture, "modes", "modes", "", mode_blocks(picture), sections);
  add(picture, "learnt", "what was learnt", "", learnt_blocks(picture), sections);
  add(picture, "axes", "axes in space", "", axis_blocks(picture), sections);
  add(picture, "predictions", "measured and predicted forces", "", forces_blocks(picture),
      sections);
  return sections;
}

Json page_of(const PosteriorResult& result) {
  const PosteriorRun& run = result.run;
  const FitProblem& problem = run.posterior->problem();
  Json provenance = fit_provenance(run.inputs, {}, problem.digit().fidelity, run.run);
  provenance["seed"] = fmt::format("{}", run.settings.run.sampler.seed);
  return {{"title", fmt::format("thenar: posterior of {}", fmt::join(problem.specimens(), ", "))},
          {"subtitle", describe_run(run)},
          {"opening",
           opening_json("Which digits agree with the measured forces, and how sure are we?",
                        describe_run(run) + ".",
                        run.convergence.warnings.empty()
                            ? fmt::format("The chains agree: the worst R-hat is {:.3f}, the least "
                                          "effective sample {:.0f}.",
                                          run.convergence.worst_r_hat, run.convergence.min_bulk_ess)
                            : "The chains have not converged: do not use these draws.")},
          {"provenance", provenance},
          {"sections", posterior_sections(posterior_picture(run))}};
}

Json page_of(const PosteriorPrediction& result) {
  const PosteriorRun& run = result.posterior.run;
  Json page = page_of(result.predicted);
  Json& blocks = page["sections"][0]["blocks"];
  blocks.insert(blocks.begin(), convergence_banner(run.convergence, describe_run(run)));
  return page;
}

}  // namespace thenar
