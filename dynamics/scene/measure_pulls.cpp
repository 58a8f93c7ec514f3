#include "dynamics/scene/measure_pulls.h"

#include <fmt/format.h>

#include "dynamics/human/digit_pull.h"
#include "dynamics/mechanism/tree_motion.h"

namespace thenar {
namespace {

/// Appends the muscles of one digit.
/// @param first_z  index of the first state of the element
void add_digit(DigitPull& pull, Eigen::Index first_z, const SceneRun& run,
               const TreeMotion<double>& motion, RunPulls& out) {
  // Append the muscles, with zeros for all instants.
  const std::size_t first = out.muscles.size();
  const auto instants = static_cast<Eigen::Index>(run.samples.size());
  const Eigen::VectorXd zeros = Eigen::VectorXd::Zero(instants);
  for (std::size_t m = 0; m < pull.muscles().size(); ++m)
    out.muscles.push_back({pull.name() + "/" + pull.muscles()[m],
                           pull.contracts(static_cast<int>(m)), zeros, zeros, zeros, zeros});
  // Warn of excursions at the start that are not reliable.
  const std::string at_start = pull.start_warning(run.samples.front().q);
  if (!at_start.empty())
    out.warnings.push_back(fmt::format("{}, on the way to the start: {}", pull.name(), at_start));
  bool warned = false;
  // Evaluate the instants in order, because a net is warm-started from the one before.
  for (Eigen::Index i = 0; i < instants; ++i) {
    const SceneSample& sample = run.samples[i];
    const ElementInput at{sample.t, sample.t, sample.q, sample.v, sample.z, motion, first_z};
    pull.accept_step(at);
    const PullState now = pull.state_at(at);
    for (std::size_t m = 0; m < pull.muscles().size(); ++m) {
      PullMeasure& muscle = out.muscles[first + m];
      muscle.tension[i] = now.tension[m];
      muscle.excitation[i] = now.excitation[m];
      muscle.activation[i] = now.activation[m];
      muscle.excursion[i] = now.excursion[m];
    }
    // Keep the first warning of the run.
    if (warned || now.warning.empty()) continue;
    warned = true;
    out.warnings.push_back(
        fmt::format("{}, first at {:.4g} s: {}", pull.name(), sample.t, now.warning));
  }
}

}  // namespace

RunPulls measure_pulls(const MovingScene& scene, const SceneRun& run) {
  RunPulls out;
  const TreeModel model = tree_model(scene.mechanism);
  const TreeMotion<double> motion(model);  // not used by DigitPull, which reads q and v alone
  Eigen::Index first_z = 0;
  // The states of consecutive elements are consecutive.
  for (const std::shared_ptr<const ForceElement>& element : scene.elements) {
    if (const auto* pull = dynamic_cast<const DigitPull*>(element.get())) {
      DigitPull own = *pull;
      add_digit(own, first_z, run, motion, out);
    }
    first_z += static_cast<Eigen::Index>(element->state_names().size());
  }
  return out;
}

}  // namespace thenar
