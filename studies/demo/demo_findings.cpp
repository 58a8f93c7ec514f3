#include "studies/demo/demo_findings.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/units.h"
#include "posterior/hand_posterior.h"
#include "report/words.h"
#include "studies/pages/measured_lessons.h"
#include "studies/pages/thumb_recovery.h"

namespace thenar {
namespace {

const std::string& specimen_of(const SpecimenStudy& study) {
  return study.fit.problem.specimens().front();
}

/// "0.295 (H01) and 0.371 (H02)": a number for each specimen.
template <typename Value>
std::string of_each(const std::vector<SpecimenStudy>& studies, const Value& value) {
  return each_in_words(
      studies,
      [&](const SpecimenStudy& study) {
        return fmt::format("{:.3f} ({})", value(study), specimen_of(study));
      },
      " and ");
}

double left_out_error(const SpecimenStudy& study) {
  return study.postures.experiments.front().error.relative;
}

/// The best prediction without a fit by what was not calibrated on the specimen; null if none.
const BaselinePrediction* best_baseline(const SpecimenStudy& study) {
  const BaselinePrediction* best = nullptr;
  for (const BaselinePrediction& each : study.baselines)
    if (!each.prediction.calibrated_on_specimen &&
        (best == nullptr || each.prediction.error.relative < best->prediction.error.relative))
      best = &each;
  return best;
}

/// "all", "2 of 3", "none" of so many.
std::string share(std::size_t part, std::size_t whole) {
  if (part == whole) return whole == 1 ? "it" : "all";
  return part == 0 ? "none" : fmt::format("{} of {}", part, whole);
}

}  // namespace

SetPage page_for(const std::string& file, const std::string& title, const Finding& finding,
                 Json page, const char* figure) {
  Json shown = first_block(page, figure);
  return {file, title, finding.opening, finding.line, std::move(page), std::move(shown)};
}

Finding force_finding(const std::vector<SpecimenStudy>& studies) {
  // Count the fingers on which the fit beats the best prediction without a fit.
  std::size_t better = 0;
  std::vector<std::string> rivals;
  for (const SpecimenStudy& study : studies) {
    const BaselinePrediction* best = best_baseline(study);
    if (best == nullptr) continue;
    if (left_out_error(study) < best->prediction.error.relative) ++better;
    rivals.push_back(fmt::format("{:.3f} ({}, {})", best->prediction.error.relative,
                                 specimen_of(study), best->name));
  }
  const std::string seen =
      of_each(studies, [](const SpecimenStudy& s) { return s.in_sample.error.relative; });
  const std::string unseen = of_each(studies, left_out_error);
  return {{"How well does a finger that was fitted to fingertip forces predict forces that it has "
           "not seen?",
           fmt::format("{} middle fingers, whose six tendons were loaded one at a time in four "
                       "postures [Synek2019], were fitted by {} solvers. Postures and tendons were "
                       "left out one at a time, and predictions without a fit stand beside the "
                       "fits.",
                       studies.size(), studies.empty() ? 0 : studies.front().runs.size()),
           fmt::format("The relative error is {} in sample, and {} in a posture left out. The best "
                       "prediction that takes no fit and was not calibrated on these fingers has "
                       "{}: the fit beats it on {} of {} fingers.",
                       seen, unseen, fmt::join(rivals, " and "), better, studies.size())},
          fmt::format("Forces: in a posture that the fit has not seen, the relative error of "
                      "fingertip forces is {}; without a fit it is {}.",
                      unseen, fmt::join(rivals, " and "))};
}

Finding finger_finding(const std::vector<SpecimenStudy>& studies) {
  std::vector<std::string> open, best;
  for (const SpecimenStudy& study : studies) {
    open.push_back(fmt::format("{} of {} ({})", study.fit.covariance.null_directions.size(),
                               study.fit.problem.size(), specimen_of(study)));
    if (!study.profiles.empty())
      best.push_back(fmt::format("{} ({})", study.profiles.front().name, specimen_of(study)));
  }
  const std::string directions = fmt::format("{}", fmt::join(open, " and "));
  return {{"What do fingertip forces tell of joint axes, tendon paths and the hood, and what not?",
           "Each parameter has a prior from anatomy. Its interval after the fit stands beside the "
           "prior, the best known parameters are profiled, and directions in which no measured "
           "force changes are listed.",
           fmt::format("Along {} directions no measured force changes, and the prior alone decides "
                       "them. Best known are {}.",
                       directions, fmt::join(best, " and "))},
          fmt::format("Finger: no measured force changes along {} directions of the parameters; "
                      "there the prior decides.",
                      directions)};
}

Finding population_finding(const PopulationStudy& study) {
  // Errors of each finger predicted by the other, then of the bonobo.
  std::vector<std::string> left_out, unseen;
  for (std::size_t e = 0; e < study.specimens.experiments.size(); ++e)
    left_out.push_back(fmt::format("{:.3f} ({})", study.specimens.experiments[e].error.relative,
                                   study.fit.problem.experiments()[e].specimen));
  for (const UnseenSpecimen& each : study.unseen)
    unseen.push_back(
        fmt::format("{:.3f} ({}{})", each.prediction.error.relative, each.specimen,
                    each.prediction.error.covered
                        ? fmt::format(", {:.0f} % of its force components within the 95 % interval",
                                      100 * *each.prediction.error.covered)
                        : ""));
  return {{"Does what some hands taught carry over to another?",
           "Two fingers were fitted together as members of a population. Each was predicted by the "
           "other, and the finger of a bonobo (B01), which was never fitted, by the population "
           "alone.",
           fmt::format("The relative error of a finger left out is {}; of the bonobo's {}. The "
                       "subject from which the population starts has seen all of them, so that "
                       "these are not errors of unseen hands.",
                       fmt::join(left_out, " and "), fmt::join(unseen, " and "))},
          fmt::format("Population: a finger left out is predicted with a relative error of {}, a "
                      "bonobo's with {}.",
                      fmt::join(left_out, " and "), fmt::join(unseen, " and "))};
}

Finding posterior_finding(const std::vector<DemoPosterior>& posteriors) {
  // The worst R-hat decides about all chains; coverage is that of fingers that were never fitted.
  double worst = 0, least = 1, most = 0;
  std::size_t converged = 0;
  for (const DemoPosterior& posterior : posteriors) {
    worst = std::max(worst, posterior.run.convergence.worst_r_hat);
    if (posterior.run.convergence.warnings.empty()) ++converged;
    for (const Prediction& prediction : posterior.unseen) {
      least = std::min(least, prediction.error.covered.value_or(0));
      most = std::max(most, prediction.error.covered.value_or(0));
    }
  }
  const std::string covered = fmt::format("{:.0f} to {:.0f} %", 100 * least, 100 * most);
  return {{"How sure do the forces make us?",
           fmt::format("{} posteriors, of each finger alone and of both, were sampled by NUTS in "
                       "four chains each, and predict forces that were fitted and forces that were "
                       "not.",
                       posteriors.size()),
           fmt::format(
               "Runs that converged without a warning: {}; the worst R-hat is {:.4f}. Of the force "
               "components of a hand that was never fitted, {} lie within their 95 % interval.",
               share(converged, posteriors.size()), worst, covered)},
          fmt::format("Posteriors: the worst R-hat is {:.4f}; {} of a new specimen's force "
                      "components lie within their 95 % interval.",
                      worst, covered)};
}

Finding posterior_finding(const DemoPosterior& posterior) {
  const Convergence& convergence = posterior.run.convergence;
  return {
      {fmt::format("What do the forces of {} leave open, and may the draws be used?",
                   posterior.name),
       fmt::format("{} entries were sampled by NUTS in four chains; they are compared with the "
                   "forces, one trial left out at a time.",
                   posterior.run.posterior->size()),
       fmt::format("The worst R-hat is {:.4f}, the least bulk ESS {:.0f}, with {} divergent draws; "
                   "{} mode{} found. {}",
                   convergence.worst_r_hat, convergence.min_bulk_ess, convergence.divergent,
                   posterior.run.modes.size(), posterior.run.modes.size() == 1 ? " was" : "s were",
                   convergence.warnings.empty() ? "The sampler has converged."
                                                : "The sampler has NOT converged: see why below.")},
      ""};
}

Finding hood_finding(const DemoHood& hood) {
  // Name the best model of each experiment with its cost, and the finest one beside it.
  std::vector<std::string> best;
  for (const HoodComparison& comparison : hood.rungs) {
    if (comparison.rungs.empty()) continue;
    const auto less = [](const HoodRung& a, const HoodRung& b) {
      return a.prediction.error.relative < b.prediction.error.relative;
    };
    const HoodRung& least =
        *std::min_element(comparison.rungs.begin(), comparison.rungs.end(), less);
    const HoodRung& finest = comparison.rungs.back();
    best.push_back(fmt::format("{:.3f} of {} by {} in {:.3g} \u00b5s",
                               least.prediction.error.relative, comparison.experiment, least.name,
                               1e6 * least.seconds));
    if (&least != &finest)
      best.back() += fmt::format(" (the finest, {}: {:.3f} in {:.3g} \u00b5s)", finest.name,
                                 finest.prediction.error.relative, 1e6 * finest.seconds);
  }
  const std::string errors = fmt::format("{}", fmt::join(best, ", and "));
  return {{"How should the extensor hood be modelled: by separate tendons, by fixed fractions, or "
           "as a floating net?",
           "A middle finger was bent under constant tensions with a net that finds its own shape, "
           "and every model of the hood predicted the measured fingertip forces. Nothing was "
           "fitted here.",
           fmt::format("The least relative errors are {}.", errors)},
          fmt::format("Extensor hood: the least relative errors are {}.", errors)};
}

Finding thumb_finding(const ThumbStudy& study, const Json& page) {
  // Volumes of the feasible sets stand in the fourth column.
  const Json table = first_block({{"sections", Json::array({page})}}, "table");
  const auto volume = [&](std::size_t row) { return table["rows"][row][3].get<double>(); };
  const std::string volumes =
      fmt::format("{:.0f} N\u00b3 with orthogonal axes and {:.0f} N\u00b3 with skewed ones",
                  volume(0), volume(1));
  // Both models on the same made-up forces.
  std::vector<std::string> off;
  for (const ThumbFit& fit : study.fits) {
    if (!is_compared(fit.settings)) continue;
    off.push_back(fmt::format("{:.1f} % ({})", 100 * fit.relative_error,
                              fit.settings.skewed ? "skewed" : "orthogonal"));
  }
  const std::string errors = fmt::format("{}", fmt::join(off, " and "));
  return {{"What do skewed axes cost a thumb, and can forces tell that its axes are skewed?",
           "The largest forces of three thumbs that differ in their axes were found, and made-up "
           "forces of a skewed thumb were explained by a model with orthogonal and by one with "
           "skewed axes.",
           fmt::format("The set of forces that the thumbtip can make has a volume of {}. At 10 % "
                       "noise in two postures, fitted models miss the true forces by {}.",
                       volumes, errors)},
          fmt::format("Thumb: its feasible forces have a volume of {}; fitted to a skewed thumb, "
                      "models miss its forces by {}.",
                      volumes, errors)};
}

Finding thumb_recovery_finding(const ThumbRecoveryResult& result) {
  // The question, and what was done.
  const ThumbRecovery& recovery = result.recovery;
  Finding finding{
      {"Are the axes of a thumb found as [Miller2005] found them, from fingertip forces and muscle "
       "activity, and what do the few published measurements add?",
       fmt::format("Forces and muscle activity were made up with a thumb of known axes and "
                   "fitted by least squares and by chains with all {} axes free. Then measured "
                   "forces (trials: {}) and losses of pinch under nerve blocks (blocks: {}) were "
                   "added, to the prior and to the posterior, by weights on draws.",
                   recovery.axes.size(), result.lessons.force.trials.size(),
                   result.lessons.losses.blocks.size()),
       "It was stopped before it was finished."},
      "Thumb, fitted as in [Miller2005]: stopped before it was finished."};
  if (!recovery.complete || !result.lessons.complete) return finding;

  // Errors of directions, and what both kinds of data leave of their tilts.
  double fit = 0, drawn = 0;
  for (const RecoveredAxis& axis : recovery.axes) {
    fit = std::max(fit, axis.fit_error);
    drawn = std::max(drawn, axis.drawn_error);
  }
  const KeptAxes made_up = kept_axes(recovery);
  const ReweightedDraws& prior = result.lessons.reweighted.front();
  const DataUpdate& both = update_by_both(prior);
  std::string measured = fmt::format("is not known ({})", both.message);
  if (both.message.empty()) {
    const KeptShares kept = kept_shares(prior, both);
    measured = fmt::format("{:.0f} % (rms over {} tilts, of which {} keep more than {:.0f} %){}",
                           100 * kept.rms, prior.names.size(), kept.undecided,
                           100 * kUndecidedShare, doubt_of(both));
  }
  const std::string left = fmt::format(
      "made-up forces and muscle activity leave {:.0f} to {:.0f} % of the prior's sd of an axis, "
      "what was measured in people {}",
      100 * made_up.least, 100 * made_up.most, measured);
  const std::string doubts = recovery_doubts(recovery);
  finding.opening.learnt = fmt::format(
      "Least squares is off the true axes by {:.1f} degrees at most, the mean of the chains by "
      "{:.1f}; they differ by {:.2f} posterior sds (rms). In sds, {}.{}",
      degrees(fit), degrees(drawn), recovery.agreement.rms, left, doubts);
  finding.line = fmt::format("Thumb, fitted as in [Miller2005]: {}.{}", left, doubts);
  return finding;
}

}  // namespace thenar
