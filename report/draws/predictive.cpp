#include "report/draws/predictive.h"

#include <fmt/format.h>

#include "base/error.h"
#include "report/blocks.h"
#include "report/words.h"
#include "sampling/diagnostics/order_statistics.h"

namespace thenar {
namespace {

/// "dorsal" of a component that is one direction of the digit, else its number.
std::string component_name(const Experiment& experiment, int component) {
  const Eigen::RowVector3i row = experiment.axes_of_digit.row(component);
  if (row.cwiseAbs().sum() == 1) return direction_word(row);
  return fmt::format("component {}", component + 1);
}

/// Muscles that a trial loads.
std::string loads_of(const Trial& trial) {
  std::string text;
  for (const auto& [muscle, tension] : trial.tension)
    if (tension != 0) text += (text.empty() ? "" : " + ") + muscle;
  return text.empty() ? "no load" : text;
}

/// Numbers of measured components: all, and those within the 50 % and 95 % intervals of replicated
/// ones.
struct Counts {
  int all = 0, within_50 = 0, within_95 = 0;
};

Json value_of(double measured, const Eigen::VectorXd& replicated, Counts& coverage) {
  const Eigen::VectorXd rising = sorted(replicated);
  Eigen::VectorXd q(6);
  q << measured, quantile(rising, 0.025), quantile(rising, 0.25), quantile(rising, 0.5),
      quantile(rising, 0.75), quantile(rising, 0.975);
  ++coverage.all;
  if (measured >= q[2] && measured <= q[4]) ++coverage.within_50;
  if (measured >= q[1] && measured <= q[5]) ++coverage.within_95;
  const Json r = rounded(q, 1);
  return {{"measured", r[0]}, {"low", r[1]},        {"inner_low", r[2]},
          {"median", r[3]},   {"inner_high", r[4]}, {"high", r[5]}};
}

}  // namespace

Json predictive_block(const PredictedForces& predicted) {
  const Experiment& experiment = predicted.experiment;
  const auto trials = static_cast<Eigen::Index>(experiment.trials.size());
  require(predicted.replicated.rows() == 3 * trials && predicted.replicated.cols() > 0,
          "{} trials want {} rows of replicated forces, got {} x {}", trials, 3 * trials,
          predicted.replicated.rows(), predicted.replicated.cols());
  // Count how many components lie within their intervals.
  Counts coverage;
  Json groups = Json::array();
  for (Eigen::Index i = 0; i < trials; ++i) {
    const Trial& trial = nth(experiment.trials, i);
    Json values = Json::array();
    for (int c = 0; c < experiment.components; ++c)
      values.push_back(value_of(trial.force[c], predicted.replicated.row(3 * i + c), coverage));
    entry_named(groups, "name", trial.posture, "rows")["rows"].push_back(
        {{"name", loads_of(trial)}, {"values", values}});
  }
  Json components = Json::array();
  for (int c = 0; c < experiment.components; ++c)
    components.push_back(component_name(experiment, c));
  return {
      {"type", "predictive"},
      {"caption",
       fmt::format("{}. Measured force components (dots) over posterior predictive 50 % (thick) "
                   "and 95 % (thin) intervals, noise included. Of {} components {} lie within "
                   "50 %, {} within 95 %",
                   predicted.what, coverage.all, coverage.within_50, coverage.within_95)},
      {"unit", "N"},
      {"components", components},
      {"groups", groups}};
}

}  // namespace thenar
