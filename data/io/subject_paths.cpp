#include <algorithm>
#include <limits>

#include "data/io/subject_parts.h"

namespace thenar::internal {
namespace {

using Eigen::Vector3d;

/// How far an origin may lie from the strand that it rides on [m]: what two digitisations of one
/// landmark differ by.
constexpr double kRideReach = 1e-3;

/// Coordinates of a point in a frame, from lengths or from multiples of the frame's unit [m].
Vector3d read_coordinates(TomlTable& table, const PointFrame& frame) {
  if (!table.has(Dimension::kNumber, "point_ratio"))
    return table.vector(Dimension::kLength, "point");
  if (frame.unit <= 0)
    table.fail("'point_ratio' needs 'unit_mm' in its frame or 'reference_length_mm' at the top",
               "point_ratio");
  return frame.unit * table.vector(Dimension::kNumber, "point_ratio");
}

PathPoint read_point(TomlTable& table, const SubjectDraft& draft) {
  PathPoint point;
  if (table.has("frame")) {
    std::vector<std::string> names;
    for (const auto& [name, unused] : draft.frames) names.push_back(name);
    const PointFrame& frame = draft.frames.at(reference(table, "frame", "frame", names));
    point.segment = frame.segment;
    point.p = frame.origin + frame.axes.transpose() * read_coordinates(table, frame);
  } else {
    point.segment = segment_reference(table, "segment", draft);
    point.p = table.vector(Dimension::kLength, "point");
  }
  point.sd = table.number_or(Dimension::kLength, "point_sd", 0, Range::kNotNegative);
  if (table.has("rides_on"))
    point.rides_on = reference(table, "rides_on", "strand", names_of(draft.subject.strands));
  return point;
}

PathPoint read_bend(TomlTable& table, const SubjectDraft& draft) {
  PathPoint bend;
  bend.surface = reference(table, "surface", "surface", names_of(draft.subject.surfaces));
  for (const Surface& surface : draft.subject.surfaces)
    if (surface.name == bend.surface) bend.segment = surface.segment;
  bend.p = table.vector(Dimension::kLength, "side");
  return bend;
}

double distance_to_run(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
  const Vector3d run = b - a;
  const double length2 = run.squaredNorm();
  const double along = length2 > 0 ? std::clamp((p - a).dot(run) / length2, 0.0, 1.0) : 0;
  return (a + along * run - p).norm();
}

bool bends(const std::vector<PathPoint>& path) {
  return std::any_of(path.begin(), path.end(),
                     [](const PathPoint& point) { return !point.surface.empty(); });
}

/// From a point to a path drawn straight through its points, at the reference posture [m].
double distance_to_path(const Vector3d& p, const std::vector<PathPoint>& path) {
  double nearest = std::numeric_limits<double>::infinity();
  const PathPoint* last = nullptr;
  for (const PathPoint& point : path) {
    if (!point.surface.empty()) continue;
    if (last) nearest = std::min(nearest, distance_to_run(p, last->p, point.p));
    last = &point;
  }
  return nearest;
}

/// A carrier that bends over surfaces is measured when its path is built.
void check_ride(const TomlTable& table, const Strand& strand, const SubjectDraft& draft) {
  const PathPoint& origin = strand.path.back();
  for (const Strand& carrier : draft.subject.strands) {
    if (carrier.name != origin.rides_on) continue;
    if (carrier.path.empty())
      table.fail(
          fmt::format("'{}' rides on strand '{}', which has no path", strand.name, carrier.name));
    if (!carrier.path.back().rides_on.empty())
      table.fail(fmt::format("'{}' rides on strand '{}', which itself rides on '{}'", strand.name,
                             carrier.name, carrier.path.back().rides_on));
    const double off = distance_to_path(origin.p, carrier.path);
    if (!bends(carrier.path) && off > kRideReach)
      table.fail(
          fmt::format("the origin of strand '{}' rides on '{}' but lies {:.3g} mm from it, "
                      "more than {:.3g} mm",
                      strand.name, carrier.name, 1e3 * off, 1e3 * kRideReach));
  }
}

}  // namespace

PathPoint read_path_element(TomlTable& table, const SubjectDraft& draft) {
  const PathPoint element =
      table.has("surface") ? read_bend(table, draft) : read_point(table, draft);
  table.done();
  return element;
}

void check_path(const TomlTable& table, const Strand& strand, const SubjectDraft& draft) {
  if (strand.path.empty()) return;
  const auto points = std::count_if(strand.path.begin(), strand.path.end(),
                                    [](const PathPoint& p) { return p.surface.empty(); });
  if (points < 2)
    table.fail(fmt::format("the path of strand '{}' needs at least 2 points, got {}", strand.name,
                           points));
  if (!strand.path.front().surface.empty() || !strand.path.back().surface.empty())
    table.fail(
        fmt::format("the path of strand '{}' must begin and end with a point, not with a "
                    "surface",
                    strand.name));
  for (std::size_t k = 0; k + 1 < strand.path.size(); ++k)
    if (!strand.path[k].rides_on.empty())
      table.fail(
          fmt::format("only the origin of a strand, its last point, can ride on another; "
                      "point {} of strand '{}' does",
                      k + 1, strand.name));
  if (!strand.path.back().rides_on.empty()) check_ride(table, strand, draft);
}

}  // namespace thenar::internal
