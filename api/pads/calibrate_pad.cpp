#include "api/pads/calibrate_pad.h"

#include <algorithm>
#include <chrono>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/error.h"
#include "base/lists.h"
#include "base/progress_parts.h"
#include "data/io/pad/law_file.h"
#include "data/io/pad/pad_digest.h"
#include "pads/pad_shape.h"

namespace thenar {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kMinFitted = 4,
                      kMinChecked = 1;  // smallest numbers of presses for fit_laws() [1]
constexpr double kFitShare = 0.01;      // estimated share of fits in the total time [1]

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

void check(const PadLawsRequest& request) {
  require_field("force_error", request.force_error > 0 && request.force_error < 1,
                "wanted an error of the elements' force above 0 and below 100 %, got {:g} %",
                100 * request.force_error);
  require(request.max_penetration > 0 && request.max_elements > 0,
          "wanted a penetration above 0 m and more than 0 elements, got {} m and {}",
          request.max_penetration, request.max_elements);
}

PadPressOptions press_options(const PadLawsRequest& request) {
  PadPressOptions options;
  options.force_error = request.force_error;
  options.max_penetration = request.max_penetration;
  options.max_elements = request.max_elements;
  return options;
}

void add_presses(PadLaws& out, const MeasuredPresses& measured, bool fitted) {
  for (const MeasuredPress& press : measured.presses)
    out.presses.push_back({fitted, press, std::nullopt});
  std::vector<std::string>& failures = out.calibration.failures;
  append_all(failures, measured.failures);
}

/// Laws beside each press.
void add_forces(PadLaws& out) {
  const CalibratedLaws& laws = out.calibration.laws;
  const PowerLaw power(laws.power);
  const SoftFinger finger(laws.soft_finger);
  // The bed of springs needs the thickness of the pad under every column.
  const FoundationBed bed(pad_columns(out.pad.model.shape, LawFitOptions{}.rings), laws.foundation);
  for (LawPress& press : out.presses) {
    const MeasuredPress& by = press.elements;
    // Evaluate all laws at the depth of the press that the elements solved.
    const BedContact contact = bed.press(*by.object, by.X_PO, 1);
    press.laws = LawForces{power.at_depth(by.gap, by.depth, 1).force,
                           finger.at_depth(by.gap, by.depth, 1).force, contact.force, contact.area,
                           contact.torsion};
  }
}

/// Returns the number of presses of the trials.
std::size_t count_of(const std::vector<PressTrial>& trials) {
  std::size_t count = 0;
  for (const PressTrial& trial : trials) count += trial.depths.size();
  return count;
}

/// Fits laws if there are presses enough: few of them say nothing of other objects and depths.
void add_laws(PadLaws& out, const LawTrials& trials, const MeasuredPresses& fit,
              const MeasuredPresses& check) {
  // At least half of the presses of each kind must be solved.
  const std::size_t to_fit = std::max(kMinFitted, (count_of(trials.fit) + 1) / 2);
  const std::size_t to_check = std::max(kMinChecked, (count_of(trials.check) + 1) / 2);
  if (fit.presses.size() < to_fit || check.presses.size() < to_check) {
    out.calibration.message =
        fmt::format("{} presses to fit and {} to check were solved, and laws need {} and {}",
                    fit.presses.size(), check.presses.size(), to_fit, to_check);
    return;
  }
  // Fit, and tie the laws to the pad by its digest, so that laws of another pad are refused.
  out.calibration = fit_laws(out.pad.model, fit, check, {});
  out.calibration.laws.name = out.pad.spec.name;
  out.calibration.laws.pad_digest = pad_digest(out.pad.spec);
  add_forces(out);
}

void add_warnings_of_laws(PadLaws& out) {
  if (const std::string assumed = assumption_of(out.pad.spec); !assumed.empty())
    out.outcome.warnings.push_back(assumed);
  for (const std::string& failure : out.calibration.failures)
    out.outcome.warnings.push_back(fmt::format("a press failed and was left out: {}", failure));
  // Report the largest error of any press, as it bounds all numbers of the calibration.
  double error = 0, penetration = 0;
  for (const LawPress& press : out.presses) {
    error = std::max(error, press.elements.force_error);
    penetration = std::max(penetration, press.elements.penetration);
  }
  if (penetration > out.request.max_penetration)
    out.outcome.warnings.push_back(
        fmt::format("objects are up to {:.2g} um inside faces of the elements, more than the "
                    "{:.2g} um asked for",
                    1e6 * penetration, 1e6 * out.request.max_penetration));
  if (error > out.request.force_error)
    out.outcome.warnings.push_back(fmt::format(
        "elements estimate errors of their force of up to {:.2g} %, above the {:.2g} % asked for: "
        "{}",
        100 * error, 100 * out.request.force_error,
        out.pad.model.element == HexElement::kQuadratic
            ? "quadratic elements are not refined"
            : "meshes have all elements they may have"));
  const auto alike = [](const ExponentialTerm& a, const ExponentialTerm& b) {
    return a.share == b.share && a.time == b.time;
  };
  // Laws relax like one tissue, the pulp, whereas elements relax layer by layer.
  const std::vector<ExponentialTerm>& pulp = out.pad.model.tissues.front().relaxation;
  for (const Tissue& tissue : out.pad.model.tissues)
    if (!std::equal(pulp.begin(), pulp.end(), tissue.relaxation.begin(), tissue.relaxation.end(),
                    alike))
      out.outcome.warnings.push_back(
          fmt::format("laws relax as the pulp does, and {} relaxes otherwise", tissue.name));
}

}  // namespace

PadLaws calibrate_pad(const PadLawsRequest& request, const Progress& progress) {
  check(request);
  PadLaws out;
  // Depths of the trials depend on how thick the pad is, unless they are stated.
  out.request = request;
  out.pad = open_pad(request.pad);
  const PadModel& model = out.pad.model;
  out.depths = request.depths.empty() ? trial_depths(model.shape) : request.depths;
  const LawTrials trials = standard_trials(model.shape, out.depths);

  // Presses: parts are as long as their trials are many.
  ProgressParts parts(progress, 1);
  const auto count = static_cast<double>(trials.fit.size() + trials.check.size());
  const auto share = [&](const std::vector<PressTrial>& of) {
    return (1 - kFitShare) * static_cast<double>(of.size()) / count;
  };
  const PadPressOptions options = press_options(request);
  const Clock::time_point began = Clock::now();
  const MeasuredPresses fit =
      measure_presses(model, trials.fit, options, parts.next(share(trials.fit)));
  add_presses(out, fit, true);
  MeasuredPresses check;
  const Progress of_check = parts.next(share(trials.check));
  if (fit.status != Status::kStopped)
    check = measure_presses(model, trials.check, options, of_check);
  add_presses(out, check, false);
  out.press_s = seconds_since(began);

  // Fits, which take less than a second and are not stopped.
  const Clock::time_point pressed = Clock::now();
  if (fit.status == Status::kStopped || check.status == Status::kStopped) {
    out.calibration.status = Status::kStopped;
    out.calibration.message = "presses were left out";
  } else {
    parts.next(kFitShare)(0, "fitting laws");
    add_laws(out, trials, fit, check);
  }
  out.fit_s = seconds_since(pressed);
  out.outcome.status = out.calibration.status;
  add_warnings_of_laws(out);
  return out;
}

std::string pad_laws_text(const PadLaws& found) {
  require(found.has_laws(), "a calibration without laws makes no file");
  std::string words = fmt::format("the pad '{}'", found.pad.spec.name);
  if (const std::vector<std::string> assumed = assumed_words(found.pad.spec); !assumed.empty())
    words += fmt::format(" (assumed in it: {})", fmt::join(assumed, ", "));
  const LawEvidence& evidence = found.calibration.laws.evidence;
  return laws_text(
      found.calibration.laws,
      fmt::format("Fitted to {} presses of finite elements of {} and checked on {} others",
                  evidence.fitted, words, evidence.checked));
}

std::string refusal_of(const PadLaws& found) {
  if (found.calibration.status == Status::kSolved || found.outcome.stopped()) return "";
  return fmt::format("laws were not found ({}: {})", name_of(found.calibration.status),
                     found.calibration.message);
}

}  // namespace thenar
