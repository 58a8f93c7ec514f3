#include "api/tendon_solve.h"

#include <utility>

#include "api/tendon_warnings.h"
#include "base/error.h"
#include "base/lists.h"
#include "tendons/net/net_tendons.h"

namespace thenar {
namespace {

/// Builds the digit, whose warnings begin those of an outcome.
LoadedDigit loaded_digit(const TendonRequest& request, Outcome& outcome) {
  DigitCase at = build_digit(request.digit, Hood::kFloatingNet);
  require_field("digit", at.map.empty(),
                "digit '{}' of '{}' has no bones, only tip map '{}': ask tip-force", at.digit,
                at.subject.name, at.map);
  const Eigen::VectorXd t = tensions(at, request.tension);
  outcome.warn(at.warnings);
  outcome.warn(overload_warnings(at.bones().names.muscles, at.bones().max_tension, t));
  return {at.subject.name, at.digit, at.tendons, t, std::move(at.grid), std::move(at.sources)};
}

}  // namespace

const NetTendons* LoadedDigit::net() const {
  return dynamic_cast<const NetTendons*>(tendons.get());
}

TendonSolveResult solve_tendons(const TendonRequest& request, const Progress& progress) {
  require_field("vary", request.digit.vary.empty(), "wanted one posture, got {} joints that vary",
                request.digit.vary.size());
  TendonSolveResult out;
  out.request = request;
  // Solve at one posture; the net starts from the straight finger.
  out.loaded = loaded_digit(request, out.outcome);
  progress(0, "one posture");
  const LoadedDigit& loaded = out.loaded;
  out.point = sweep_digit(*loaded.tendons, {loaded.grid.postures.front()}, loaded.t).front();
  out.outcome.count_parts(1, 1, "posture");
  if (!is_trusted(out.point.pull.status)) out.outcome.status = Status::kStalled;
  out.outcome.warn(tendon_warnings(loaded, out.point));
  return out;
}

TendonSweepResult sweep_tendons(const TendonRequest& request, const Progress& progress) {
  TendonSweepResult sweep;
  sweep.request = request;
  // Sweep row by row: each row begins with the straight finger, and follows the last joint.
  sweep.loaded = loaded_digit(request, sweep.outcome);
  const PostureGrid& grid = sweep.loaded.grid;
  const auto count = static_cast<double>(grid.postures.size());
  for (std::size_t begin = 0; begin < grid.postures.size() && !progress.stop(); begin += grid.row) {
    // One row, with its share of the progress.
    const auto from = grid.postures.begin() + static_cast<std::ptrdiff_t>(begin);
    const std::vector<Eigen::VectorXd> postures{from, from + static_cast<std::ptrdiff_t>(grid.row)};
    Progress row = progress;
    row.report = [&](double fraction, const std::string& what) {
      progress((static_cast<double>(begin) + fraction * static_cast<double>(grid.row)) / count,
               what);
    };
    for (DigitPoint& point : sweep_digit(*sweep.loaded.tendons, postures, sweep.loaded.t, row))
      sweep.points.push_back(std::move(point));
  }
  // Mark the sweep as unreliable if one posture is.
  Outcome& outcome = sweep.outcome;
  if (any_of(sweep.points, [](const DigitPoint& point) { return !is_trusted(point.pull.status); }))
    outcome.status = Status::kStalled;
  outcome.count_parts(sweep.points.size(), grid.postures.size(), "posture");
  outcome.warn(tendon_warnings(sweep.loaded, sweep.points));
  return sweep;
}

Eigen::Vector3d force_in_tip_axes(const LoadedDigit& loaded, const DigitPoint& point) {
  const TendonModel<double>& model = loaded.bones().model;
  Eigen::Matrix3d axes = model.tip_axes;
  if (model.tip_link >= 0)
    axes = pose_tree(model.tree, point.q)[static_cast<std::size_t>(model.tip_link)].X.R * axes;
  return axes.transpose() * point.tip.f_W;
}

}  // namespace thenar
