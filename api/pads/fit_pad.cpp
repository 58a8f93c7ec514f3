#include "api/pads/fit_pad.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "api/named/data_folders.h"
#include "api/named/files.h"
#include "base/error.h"
#include "base/file_io.h"
#include "base/outside_path.h"
#include "base/progress_parts.h"
#include "pads/pad_fit_problem.h"

namespace thenar {
namespace {

namespace fs = std::filesystem;

constexpr int kMaxCurvePoints = 1000;
constexpr double kForceByDepth = 2;      // power that spreads forces about evenly in depth [1]
constexpr double kSameLoad = 1e-6;       // difference of equal loads over the largest load [1]
constexpr double kCurveTimeShare = 0.1;  // share of curves in the total time [1]

/// A call whose complaints name the data file.
template <typename Call>
auto of_file(const PadData& data, const Call& call) {
  try {
    return call();
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", data.path, error.what()));
  }
}

/// The pad of the request; else that of the data file: beside it, or by name.
NamedPad open_pad_of(const PadFitRequest& request, const PadData& data) {
  PadRequest pad;
  pad.data = request.data;
  pad.pad = request.pad;
  if (!pad.pad.empty()) return open_pad(pad);
  return of_file(data, [&] {
    const std::string beside = linked_path(fs::path(data.path).parent_path().string(), data.pad);
    pad.pad = is_file(beside) ? beside : data.pad;
    return open_pad(pad);
  });
}

double imposed(const PressLoad& load) { return load.force.value_or(load.indentation); }

/// Returns a press with additional load points on its way, at the same pace.
PressCourse with_points(const PressCourse& course, int points) {
  // A course states its loads one after the other, each with the time that it takes.
  const double largest = imposed(course.loads.back());
  const bool by_force = course.loads.back().force.has_value();
  double time = 0;
  std::vector<double> loads;
  for (const PressLoad& load : course.loads) {
    loads.push_back(imposed(load));
    time += load.time;
  }
  // Replace points near a load of the data by that load.
  const std::size_t own = loads.size();
  for (int k = 1; k < points; ++k) {
    const double part = static_cast<double>(k) / points;
    const double load = largest * (by_force ? std::pow(part, kForceByDepth) : part);
    if (std::none_of(loads.begin(), loads.begin() + static_cast<std::ptrdiff_t>(own),
                     [&](double known) { return std::abs(known - load) < kSameLoad * largest; }))
      loads.push_back(load);
  }
  std::sort(loads.begin(), loads.end());
  PressCourse out = course;
  // Spread the time in proportion to the load, so that the rate stays that of the data.
  out.loads.clear();
  double before = 0;
  for (const double load : loads) {
    PressLoad next;
    if (by_force)
      next.force = load;
    else
      next.indentation = load;
    next.time = std::isinf(time) ? time : time * (load - before) / largest;
    before = load;
    out.loads.push_back(next);
  }
  return out;
}

/// Presses the initial pad, so that a press that fails there is reported with its
/// line.
/// @return whether it was not stopped
bool first_presses(const FittedPad& out, const Progress& progress) {
  progress(0, "pressing the pad as it is");
  // Each press of the data is tried with the initial law.
  const std::vector<PressCurves> curves =
      press_records(out.problem.pad, out.problem.records, progress);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (curves[i].status == Status::kStopped) return false;
    if (curves[i].status != Status::kSolved)
      throw DataError(out.data.path, out.data.presses[i].line,
                      fmt::format("press '{}' cannot be done where the search begins, {}",
                                  out.data.presses[i].name, curves[i].message));
  }
  return true;
}

void add_curves(FittedPad& out, const Progress& progress) {
  // Draw each measured press with the fitted law, at more loads than were measured.
  for (const PressRecord& record : out.problem.records) {
    progress(
        static_cast<double>(out.curves.size()) / static_cast<double>(out.problem.records.size()),
        "pressing the fitted pad");
    const PressCourse course = with_points(record.course, out.request.points);
    FittedCurve curve;
    for (const PressLoad& load : course.loads) curve.loads.push_back(imposed(load));
    // A press may fail at loads beyond the data, which costs the curve, not the fit.
    PressCurves pressed = press_curves({out.fit.pad}, course, {{}, progress.stop_requested});
    if (pressed.status == Status::kSolved)
      curve.points = std::move(pressed.points.at(0));
    else
      out.outcome.warnings.push_back(
          pressed.status == Status::kStopped
              ? fmt::format("there is no curve of '{}': it was stopped before", record.name)
              : fmt::format("there is no curve of '{}': it cannot be pressed {}", record.name,
                            pressed.message));
    out.curves.push_back(std::move(curve));
  }
}

}  // namespace

FittedPad fit_pad(const PadFitRequest& request, const Progress& progress) {
  // Read the data and open the pad that they name.
  require_field("points", request.points >= 1 && request.points <= kMaxCurvePoints,
                "wanted 1 to {} points of a curve, got {}", kMaxCurvePoints, request.points);
  FittedPad out;
  out.request = request;
  const std::string path = named_file("file of measured presses", request.presses, "presses",
                                      ".toml", data_folders(request.data));
  require_kind(path, {"presses of a pad"});
  out.data = read_pad_data(path);
  out.pad = open_pad_of(request, out.data);
  out.spec = out.pad.spec;
  out.problem = pad_fit_problem(out.data, out.spec);

  ProgressParts parts(progress, 1);
  const Progress of_fit = parts.next(1 - kCurveTimeShare);
  if (!first_presses(out, of_fit)) {
    out.fit.solution.status = out.outcome.status = Status::kStopped;
    return out;
  }
  // The fit refers to lines of the data file in its messages.
  out.fit = of_file(out.data, [&] {
    return fit_pad(out.problem, {PadFitOptions{}.tolerance, request.check_mesh, of_fit});
  });
  // A fit that was stopped or refused keeps its numbers, but is not marked as solved.
  if (out.fit.solution.status == Status::kStopped)
    out.outcome.status = Status::kStopped;
  else if (!refusal_of(out).empty())
    out.outcome.status = Status::kStalled;
  out.outcome.warnings = out.fit.warnings;
  if (out.fit.estimates.empty()) return out;
  // Write the fitted pad, and draw its curves.
  out.spec = fitted_pad(out.pad.spec, out.data, out.problem, out.fit);
  if (const std::string assumed = assumption_of(out.spec); !assumed.empty())
    out.outcome.warnings.push_back(assumed);
  add_curves(out, parts.next(kCurveTimeShare));
  return out;
}

std::string fitted_pad_text(const FittedPad& fitted, const std::string& path) {
  require(!fitted.fit.estimates.empty(), "a fit without estimates makes no pad");
  PadSpec spec = fitted.spec;
  spec.name = fs::path(path).stem().string();
  if (spec.skin && !spec.skin->mesh_file.empty()) {
    const fs::path mesh = fs::path(fitted.pad.path).parent_path() / spec.skin->mesh_file;
    spec.skin->mesh_file =
        fs::proximate(fs::absolute(mesh), fs::absolute(path).parent_path()).string();
  }
  return pad_toml(spec, fit_comment(fitted.data, fitted.problem, fitted.fit));
}

std::string refusal_of(const FittedPad& fitted) {
  const Solution& solution = fitted.fit.solution;
  if (solution.converged() || fitted.outcome.stopped() || fitted.request.allow_unconverged)
    return "";
  return fmt::format("the search did not converge ({}: {})", convergence_word(solution),
                     solution.message);
}

}  // namespace thenar
