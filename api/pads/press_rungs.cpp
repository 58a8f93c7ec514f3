#include "api/pads/press_rungs.h"

#include <cmath>

#include <fmt/format.h>

#include "api/pads/press_pad.h"
#include "base/thread_seconds.h"

namespace thenar {
namespace {

/// One press to be tried.
struct RungTrial {
  HexElement element;
  int finer;     // even meshes: cells along each way, as many times those of the pad
  double error;  // meshes that refine: the error asked for [1]; 0: even
};

/// Elements on even meshes, then meshes that refine, the finest last.
std::vector<RungTrial> all_trials(double asked) {
  std::vector<RungTrial> trials;
  for (const HexElement element : {HexElement::kDisplacement, HexElement::kMeanDilatation,
                                   HexElement::kCentroidDilatation, HexElement::kQuadratic})
    for (const int finer : {1, 2}) trials.push_back({element, finer, 0});
  for (const double part : {4.0, 2.0, 1.0, 0.5, 0.25})
    trials.push_back({HexElement::kMeanDilatation, 1, part * asked});
  return trials;
}

PressRung try_rung(const PressedPad& pressed, const RungTrial& trial, double depth,
                   const Progress& progress) {
  // The pad without relaxation, on the trial's mesh.
  PadModel model = pressed.pad.model;
  for (Tissue& tissue : model.tissues) tissue.relaxation.clear();
  model.element = trial.element;
  model.cells.across *= trial.finer;
  model.cells.around *= trial.finer;
  model.cells.through *= trial.finer;
  PadPressOptions options;
  options.force_error = trial.error > 0 ? trial.error : HUGE_VAL;
  options.max_elements = pressed.request.max_elements;
  options.max_penetration = HUGE_VAL;
  options.step.stop = progress.stop_requested;
  // One step from the touch.
  const double began = thread_seconds();
  PadPress press(model, {pressed.object.shape, 0}, pressed.touch.X_PO, options);
  PressGoal goal;
  goal.X_PO = pressed.touch.X_PO;
  goal.X_PO.p += depth * pressed.touch.along;
  const PadPressResult result = press.step(goal);
  PressRung rung;
  rung.element = name_of(trial.element);
  rung.elements = result.elements;
  rung.refined = trial.error > 0;
  rung.mesh = trial.error > 0 ? fmt::format("refined to {:.3g} %", 100 * trial.error)
                              : fmt::format("{} even cells", result.elements);
  rung.force = pressed.touch.along.dot(result.push.force);
  rung.cpu = thread_seconds() - began;
  if (result.solved.status != Status::kSolved) rung.failure = result.solved.message;
  return rung;
}

}  // namespace

std::vector<PressRung> compare_rungs(const PressedPad& pressed, const Progress& progress) {
  const PressInstant* end = pressed.end_of_way();
  const double depth = end != nullptr ? end->depth : 0;
  const std::vector<RungTrial> trials = all_trials(pressed.request.force_error);
  std::vector<PressRung> rungs;
  for (std::size_t i = 0; i < trials.size() && !progress.stop(); ++i) {
    progress(static_cast<double>(i) / static_cast<double>(trials.size()), "comparing elements");
    rungs.push_back(try_rung(pressed, trials[i], depth, progress));
    if (progress.stop()) rungs.pop_back();  // it may have been cut off
  }
  // Errors against the last, if all were done and it was solved.
  if (rungs.size() < trials.size() || !rungs.back().failure.empty()) return rungs;
  rungs.back().finest = true;
  for (PressRung& rung : rungs)
    if (rung.failure.empty()) rung.error = std::abs(rung.force / rungs.back().force - 1);
  return rungs;
}

}  // namespace thenar
