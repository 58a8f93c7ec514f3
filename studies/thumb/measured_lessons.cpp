#include "studies/thumb/measured_lessons.h"

#include <cmath>

#include <fmt/format.h>

#include "base/numbers.h"
#include "base/parallel_for.h"
#include "data/io/toml_node.h"
#include "posterior/run/posterior_quantities.h"
#include "studies/thumb/drawn_models.h"
#include "studies/thumb/thumb_experiment.h"

namespace thenar {
namespace {

constexpr double kOneDraw = 1 + 1e-6;  // an effective size below this is that of one draw [1]

/// Forces that a digit makes in all trials, with another hold, along the experiment's components
/// [N] (3 trials).
Eigen::VectorXd forces_with(const TendonDigit& digit, Experiment experiment, TipConstraint hold) {
  experiment.hold = hold;
  return true_forces(digit, experiment).reshaped();
}

/// Draws of a prior or a posterior, updated by each addition.
ReweightedDraws reweight_draws(const std::string& name, const HandPosterior& posterior,
                               const Eigen::MatrixXd& x, int chains, const MeasuredLessons& of,
                               const Progress& progress) {
  // Predict the measurements by every draw.
  ReweightedDraws draws;
  draws.name = name;
  const internal::DrawnModels drawn(posterior, x);
  draws.names = drawn.names(ParameterKind::kAxisDirection);
  draws.tilts = drawn.values(ParameterKind::kAxisDirection);
  draws.predicted =
      predict_measured(posterior.problem().digit(), drawn.all(), of.force, of.losses, progress);
  if (progress.stop()) return draws;

  // Draws weighed by them.
  for (const AddedData& added : additions_to_ask())
    draws.updates.push_back(update_tilts(
        added, draws.tilts, log_likelihood(draws.predicted, of.force, of.losses, added), chains));
  return draws;
}

}  // namespace

MeasuredThumbInputs measured_thumb_inputs(const std::string& data) {
  const auto read = [&](const char* file) {
    const std::string path = data + "/" + file;
    return SourceText{path, read_text_file(path)};
  };
  return {read("experiments/towles2004_fpl.toml"), read("studies/key_pinch_blocks.toml")};
}

std::vector<AddedData> additions_to_ask() {
  return {{"the force of FPL", true, false},
          {"the losses under nerve blocks", false, true},
          {"both", true, true},
          {"both, the force's sd halved", true, true, 0.5},
          {"both, the force's sd doubled", true, true, 2},
          {"both, the tip clamped", true, true, 1, true}};
}

MeasuredPredictions predict_measured(const TendonDigit& digit,
                                     const std::vector<TendonModel<double>>& models,
                                     const Experiment& force, const PinchLosses& losses,
                                     const Progress& progress) {
  // Room for every draw.
  const auto count = static_cast<Eigen::Index>(models.size()),
             rows = static_cast<Eigen::Index>(3 * force.trials.size());
  MeasuredPredictions out;
  out.force = out.clamped = Eigen::MatrixXd::Zero(rows, count);
  out.intact = Eigen::VectorXd::Zero(count);
  out.loss = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(losses.blocks.size()), count);
  out.undecided = Eigen::VectorXi::Zero(count);

  // Draw by draw, in parts between which progress is told.
  constexpr std::size_t kPartDraws = 100;  // Draws between two reports of progress
  for (std::size_t begin = 0; begin < models.size(); begin += kPartDraws) {
    progress(static_cast<double>(begin) / static_cast<double>(models.size()),
             "what measurements teach of a thumb");
    if (progress.stop()) return out;
    parallel_for(std::min(kPartDraws, models.size() - begin), [&](std::size_t i) {
      const auto k = static_cast<Eigen::Index>(begin + i);
      TendonDigit drawn = digit;
      drawn.model = models[begin + i];
      out.force.col(k) = forces_with(drawn, force, TipConstraint::kPinned);
      out.clamped.col(k) = forces_with(drawn, force, TipConstraint::kRigid);
      const PinchStrength pinch = measure_pinch(drawn, losses);
      out.intact[k] = pinch.intact;
      out.loss.col(k) = pinch.loss;
      out.undecided[k] = pinch.undecided;
    });
  }
  return out;
}

Eigen::VectorXd log_likelihood(const MeasuredPredictions& predicted, const Experiment& force,
                               const PinchLosses& losses, const AddedData& added) {
  const Eigen::Index draws = predicted.force.cols();
  Eigen::VectorXd log_l = Eigen::VectorXd::Zero(draws);
  // Forces, component by component.
  const Eigen::MatrixXd& f = added.clamped ? predicted.clamped : predicted.force;
  for (std::size_t i = 0; added.force && i < force.trials.size(); ++i) {
    const Eigen::Array3d sd = added.sd_factor * force_sd(force, force.trials[i]).array();
    for (Eigen::Index k = 0; k < draws; ++k)
      log_l[k] -=
          ((f.col(k).segment<3>(3 * static_cast<Eigen::Index>(i)) - force.trials[i].force).array() /
           sd)
              .square()
              .sum() /
          2;
  }
  // Losses; of a thumb without a pinch, or whose pinch is undecided, there are none.
  for (std::size_t b = 0; added.losses && b < losses.blocks.size(); ++b)
    for (Eigen::Index k = 0; k < draws; ++k) {
      const double loss = predicted.loss(static_cast<Eigen::Index>(b), k);
      const double off = (loss - losses.blocks[b].loss) / losses.blocks[b].sd;
      log_l[k] -= std::isnan(loss) ? kInfinity : off * off / 2;
    }
  return log_l;
}

DataUpdate update_tilts(const AddedData& added, const Eigen::Ref<const Eigen::MatrixXd>& tilts,
                        const Eigen::Ref<const Eigen::VectorXd>& log_likelihood, int chains) {
  // Draws that can say what was measured at all.
  DataUpdate update{added, "", {}, {}};
  if (!(log_likelihood.array() > -kInfinity).any()) {
    update.message = fmt::format("none of {} draws can have weight", tilts.cols());
    return update;
  }
  // A single draw has no spread.
  update.weights = importance_weights(log_likelihood, chains);
  if (update.weights.effective_size < kOneDraw)
    update.message = "one draw takes all the weight";
  else
    update.tilts = weighted_spread(tilts, update.weights.weight, chains);
  return update;
}

MeasuredLessons reweight_by_measurements(const MeasuredThumbInputs& inputs, const PosteriorRun& run,
                                         const TendonDigit& truth,
                                         const MeasuredLessonsSettings& settings) {
  // Read the measurements, and predict them by the thumb of the made-up data.
  MeasuredLessons out;
  out.inputs = inputs;
  out.force = parse_experiment(inputs.force.text, inputs.force.path);
  out.losses = parse_pinch_losses(inputs.losses.text, inputs.losses.path);
  out.truth = predict_measured(truth, {truth.model}, out.force, out.losses);

  // The prior, then the posterior of the made-up data.
  const HandPosterior& posterior = *run.posterior;
  const auto total = static_cast<double>(settings.prior_draws + settings.posterior_draws);
  const auto part = [&](double begin, long draws) {
    Progress one = settings.progress;
    one.report = [&, begin, draws](double fraction, const std::string& what) {
      settings.progress((begin + fraction * static_cast<double>(draws)) / total, what);
    };
    return one;
  };
  out.reweighted.push_back(reweight_draws("before any data", posterior,
                                          prior_draws(run, static_cast<int>(settings.prior_draws)),
                                          0, out, part(0, settings.prior_draws)));
  if (settings.progress.stop()) return out;
  const int chains = run.draws.chains();  // as many draws of each
  out.reweighted.push_back(reweight_draws(
      "after the made-up data", posterior,
      thinned(pooled(run.draws), settings.posterior_draws / chains * chains), chains, out,
      part(static_cast<double>(settings.prior_draws), settings.posterior_draws)));
  out.complete = !settings.progress.stop();
  return out;
}

}  // namespace thenar
