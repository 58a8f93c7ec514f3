#include "api/pads/press_rungs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "api/pads/press_pad.h"
#include "base/file_io.h"
#include "base/outside_path.h"
#include "base/thread_seconds.h"
#include "base/units.h"
#include "data/io/pad/law_file.h"
#include "pad_laws/foundation_bed.h"
#include "pads/pad_press.h"
#include "pads/skin_gap.h"

namespace thenar {
namespace {

constexpr int kBedRings = 18;  // rings of a bed, equal to those of LawFitOptions [1]

/// The laws of a pad, or why there are none.
struct LawsFound {
  std::optional<CalibratedLaws> laws;
  std::string missing;
};

LawsFound find_laws(const PressResult& pressed) {
  const PadRequest& asked = pressed.request.pad;
  const std::string& name = pressed.pad.spec.name;
  // Laws belong to one tissue, shape and relaxation: refuse them for any other.
  if (!asked.law.empty() || asked.exponent)
    return {{}, "laws are calibrated for the tissue of the pad's file, and another was asked for"};
  const std::filesystem::path file =
      std::filesystem::path(pressed.pad.path).parent_path() / "laws" / (name + ".toml");
  if (outside_fault(name, OutsideUse::kInside) || !is_file(file.string()))
    return {{},
            fmt::format("no laws were calibrated for '{}': there is no laws/{}.toml", name, name)};
  CalibratedLaws laws = read_laws(file.string());
  if (laws.name != name)
    return {{}, fmt::format("laws/{}.toml is of another pad, '{}'", name, laws.name)};
  // Terms of relaxation have to be the same, share by share.
  const auto alike = [](const auto& a, const auto& b) {
    return a.share == b.share && a.time == b.time;
  };
  const auto& relaxation = pressed.pad.model.tissues.front().relaxation;
  if (!std::equal(laws.relaxation.begin(), laws.relaxation.end(), relaxation.begin(),
                  relaxation.end(), alike))
    return {{}, fmt::format("laws/{}.toml relax otherwise than this pad", name)};
  return {std::move(laws), ""};
}

/// Processor time of one call, the median of 21 batches [s].
template <typename Call>
double seconds_of_call(int calls, const Call& call) {
  std::array<double, 21> seconds{};
  // Write each value to a volatile, and take the median of 21 batches.
  volatile double kept = 0;  // prevents the removal of calls
  for (double& each : seconds) {
    const double began = thread_seconds();
    for (int i = 0; i < calls; ++i) kept = call();
    each = (thread_seconds() - began) / calls;
  }
  (void)kept;
  std::nth_element(seconds.begin(), seconds.begin() + 10, seconds.end());
  return seconds[10];
}

PressRung law_rung(const std::string& name, const std::string& message) {
  PressRung rung;
  rung.element = name;
  rung.mesh = "law";
  rung.reduced = true;
  rung.message = message;
  return rung;
}

/// Returns the rung of the hard point, which has either the requested force and no patch, or no
/// force.
PressRung hard_point(const PressResult& pressed) {
  PressRung rung =
      law_rung("hard point", pressed.request.force
                                 ? "rigid: any force at depth 0, area 0; none at this depth"
                                 : "rigid: no depth, so no force belongs to the one asked for");
  if (pressed.request.force) rung.area = rung.torsion = 0;
  return rung;
}

/// Every reduced law at a depth, from the simplest on.
std::vector<PressRung> law_rungs(const PressResult& pressed, double depth) {
  std::vector<PressRung> rungs{hard_point(pressed)};
  const LawsFound found = find_laws(pressed);
  if (!found.laws) {
    for (const char* name : {"power law", "soft finger", "elastic foundation", "foundation bed"})
      rungs.push_back(law_rung(name, found.missing));
    return rungs;
  }
  const CalibratedLaws& laws = *found.laws;
  const Shape& object = *pressed.object.shape;
  const double friction = pressed.request.friction;
  // Move the object from first touch by the depth of the press.
  Pose<double> X_PO = pressed.touch.X_PO;
  X_PO.p += depth * pressed.touch.along;
  std::string note = fmt::format("calibrated for '{}'", laws.name);
  if (depth > laws.evidence.depth)
    note += fmt::format(" to {:.3g} mm only", laws.evidence.depth / kMm);

  // Evaluate the laws by curvatures of the gap at the deepest point of the skin.
  const PadShape& shape = pressed.pad.model.shape;
  const DeepestSkin deepest = deepest_skin(PadChart(shape), object, X_PO);
  const RelativeCurvatures gap = skin_gap(*skin_solid(shape), object, X_PO, deepest.place);
  const auto add = [&](PressRung rung, double force, double area, double torsion, double cpu) {
    rung.force = force;
    rung.area = area;
    rung.torsion = torsion;
    rung.cpu = cpu;
    rung.note = note;
    rungs.push_back(std::move(rung));
  };
  const auto add_law = [&](const std::string& name, const ContactLaw& law) {
    const LawContact contact = law.at_depth(gap, depth, friction);
    add(law_rung(name, ""), contact.force, contact.area, contact.patch.torsion,
        seconds_of_call(1000, [&] { return law.at_depth(gap, depth, friction).force; }));
  };
  add_law("power law", PowerLaw(laws.power));
  add_law("soft finger", SoftFinger(laws.soft_finger));
  add_law("elastic foundation", ElasticFoundation(laws.foundation));

  // By springs over the skin.
  const FoundationBed bed(pad_columns(shape, kBedRings), laws.foundation);
  const BedContact contact = bed.press(object, X_PO, friction);
  add(law_rung("foundation bed", contact.behind ? "the object is too thin for it" : ""),
      pressed.touch.along.dot(contact.push.force), contact.area, contact.torsion,
      seconds_of_call(20, [&] { return bed.press(object, X_PO, friction).force; }));
  return rungs;
}

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

PressRung try_rung(const PressResult& pressed, const RungTrial& trial, double depth,
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
  rung.area = result.area;
  rung.cpu = thread_seconds() - began;
  if (result.solved.status != Status::kSolved) rung.message = result.solved.message;
  return rung;
}

}  // namespace

std::string laws_warning(const PressResult& pressed) {
  const LawsFound found = find_laws(pressed);
  return found.laws ? version_doubt(*found.laws, pressed.pad.spec) : "";
}

std::vector<PressRung> compare_rungs(const PressResult& pressed, const Progress& progress) {
  // Every rung goes to the depth that the press reached.
  const PressInstant* end = pressed.end_of_motion();
  const double depth = end != nullptr ? end->depth : 0;
  const std::vector<RungTrial> trials = all_trials(pressed.request.force_error);
  std::vector<PressRung> rungs = law_rungs(pressed, depth);
  const std::size_t all = rungs.size() + trials.size();
  for (std::size_t i = 0; i < trials.size() && !progress.stop(); ++i) {
    progress(static_cast<double>(i) / static_cast<double>(trials.size()), "comparing elements");
    rungs.push_back(try_rung(pressed, trials[i], depth, progress));
    if (progress.stop()) rungs.pop_back();  // possibly incomplete
  }
  // Errors against the last, if all were done and it was solved.
  if (rungs.size() < all || !rungs.back().message.empty()) return rungs;
  rungs.back().finest = true;
  for (PressRung& rung : rungs)
    if (rung.message.empty()) rung.error = std::abs(rung.force / rungs.back().force - 1);
  return rungs;
}

}  // namespace thenar
