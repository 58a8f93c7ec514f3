#include <algorithm>
#include <limits>

#include <Eigen/Geometry>

#include "base/lists.h"
#include "base/spatial.h"
#include "data/io/subject_parts.h"

namespace thenar::internal {
namespace {

using Eigen::Vector3d;

PointFrame read_frame(TomlTable& table, const SubjectDraft& draft) {
  PointFrame frame;
  frame.segment = segment_reference(table, "segment", draft);
  frame.origin = table.vector(Dimension::kLength, "origin");
  frame.unit =
      table.number_or(Dimension::kLength, "unit", draft.subject.reference_length, Range::kPositive);
  // Rows of an orthonormal frame.
  if (table.has("axes")) frame.axes = table.rows3("axes");
  const Eigen::Matrix3d gram = frame.axes * frame.axes.transpose();
  if ((gram - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() > 1e-6)
    table.fail("wanted 'axes' as three perpendicular unit vectors", "axes");
  table.done();
  return frame;
}

Strand read_strand(TomlTable& table, const SubjectDraft& draft) {
  Strand strand;
  strand.name = new_name(table, names_of(draft.subject.strands));
  // Path from insertion to origin.
  read_each(table, "path", strand.path, read_path_element, draft);
  check_path(table, strand, draft);
  // Constant moment arms.
  strand.arms = table.named(Dimension::kLength, "arms");
  for (const auto& [joint, arm] : strand.arms)
    check_reference(table, "arms", "joint", joint, names_of(draft.subject.joints));
  if (strand.path.empty() && strand.arms.empty())
    table.fail(fmt::format("strand '{}' needs a 'path' or 'arms_mm'", strand.name));
  return strand;
}

/// Strand that a muscle pulls: the one it names, or the one of its own name.
std::string read_pulled(TomlTable& table, const std::string& muscle, const Subject& subject) {
  const std::vector<std::string> strands = names_of(subject.strands);
  if (table.has("strand")) return reference(table, "strand", "strand", strands);
  if (strands.empty()) return "";
  check_reference(table, "name", "strand", muscle, strands);
  return muscle;
}

/// F0 [N] as stated, or as PCSA times specific tension; absent if neither is known.
std::optional<double> read_max_force(TomlTable& table, double pcsa, double specific_tension) {
  const double tension =
      table.number_or(Dimension::kStress, "specific_tension", specific_tension, Range::kPositive);
  if (table.has(Dimension::kForce, "max_force"))
    return table.number(Dimension::kForce, "max_force", Range::kNotNegative);
  return pcsa * tension > 0 ? std::optional<double>(pcsa * tension) : std::nullopt;
}

MuscleUnit read_muscle(TomlTable& table, const SubjectDraft& draft) {
  MuscleUnit muscle;
  muscle.name = new_name(table, names_of(draft.subject.muscles));
  muscle.strand = read_pulled(table, muscle.name, draft.subject);
  // Architecture, as far as it is known.
  muscle.pcsa = table.number_or(Dimension::kArea, "pcsa", 0, Range::kNotNegative);
  muscle.max_force = read_max_force(table, muscle.pcsa, draft.specific_tension);
  muscle.fibre_length = table.number_or(Dimension::kLength, "fibre_length", 0, Range::kNotNegative);
  muscle.tendon_slack = table.number_or(Dimension::kLength, "tendon_slack", 0, Range::kNotNegative);
  muscle.pennation = table.number_or(Dimension::kAngle, "pennation", 0, Range::kNotNegative);
  return muscle;
}

}  // namespace

void read_frames(TomlTable& top, SubjectDraft& draft) {
  for (TomlTable& table : top.tables("frame")) {
    const std::string name = table.text("name");
    if (!draft.frames.emplace(name, read_frame(table, draft)).second)
      table.fail(fmt::format("[[frame]] '{}' is given twice", name), "name");
  }
}

void read_strands(TomlTable& top, SubjectDraft& draft) {
  read_each(top, "strand", draft.subject.strands, read_strand, draft);
}

void read_muscles(TomlTable& top, SubjectDraft& draft) {
  read_each(top, "muscle", draft.subject.muscles, read_muscle, draft);
}

namespace {

/// Largest distance of an origin from the strand on which it rides [m]: two digitisations of one
/// landmark differ by as much.
constexpr double kRideReach = 1e-3;

/// Coordinates of a point in a frame [m] (3), from lengths or from multiples of the frame's unit.
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
  // In a published frame, or directly in the subject's.
  if (table.has("frame")) {
    const std::vector<std::string> names = map_keys(draft.frames);
    const PointFrame& frame = draft.frames.at(reference(table, "frame", "frame", names));
    point.segment = frame.segment;
    point.p = frame.origin + frame.axes.transpose() * read_coordinates(table, frame);
  } else {
    point.segment = segment_reference(table, "segment", draft);
    point.p = table.vector(Dimension::kLength, "point");
  }
  point.sd = table.number_or(Dimension::kLength, "point_sd", 0, Range::kNotNegative);
  // A point may ride on another strand.
  if (table.has("rides_on"))
    point.rides_on = reference(table, "rides_on", "strand", names_of(draft.subject.strands));
  return point;
}

PathPoint read_bend(TomlTable& table, const SubjectDraft& draft) {
  PathPoint bend;
  bend.surface = reference(table, "surface", "surface", names_of(draft.subject.surfaces));
  bend.segment = find_named(draft.subject.surfaces, bend.surface)->segment;
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
  return any_of(path, [](const PathPoint& point) { return !point.surface.empty(); });
}

/// Distance from a point to the straight lines between a path's points, at the reference posture
/// [m].
double distance_to_path(const Vector3d& p, const std::vector<PathPoint>& path) {
  double nearest = std::numeric_limits<double>::infinity();
  const PathPoint* last = nullptr;
  // Surfaces are passed over.
  for (const PathPoint& point : path) {
    if (!point.surface.empty()) continue;
    if (last) nearest = std::min(nearest, distance_to_run(p, last->p, point.p));
    last = &point;
  }
  return nearest;
}

/// Refuses an origin that cannot ride on its strand. Strands that bend over surfaces are measured
/// later.
void check_ride(const TomlTable& table, const Strand& strand, const SubjectDraft& draft) {
  const PathPoint& origin = strand.path.back();
  for (const Strand& carrier : draft.subject.strands) {
    if (carrier.name != origin.rides_on) continue;
    // The carrier needs a path of its own, at rest.
    if (carrier.path.empty())
      table.fail(
          fmt::format("'{}' rides on strand '{}', which has no path", strand.name, carrier.name));
    if (!carrier.path.back().rides_on.empty())
      table.fail(fmt::format("'{}' rides on strand '{}', which itself rides on '{}'", strand.name,
                             carrier.name, carrier.path.back().rides_on));
    // The origin must lie on it.
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
  return table.has("surface") ? read_bend(table, draft) : read_point(table, draft);
}

void check_path(const TomlTable& table, const Strand& strand, const SubjectDraft& draft) {
  if (strand.path.empty()) return;
  // A path runs from point to point.
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
  // Only the origin may ride.
  for (std::size_t k = 0; k + 1 < strand.path.size(); ++k)
    if (!strand.path[k].rides_on.empty())
      table.fail(
          fmt::format("only the origin of a strand, its last point, can ride on another; "
                      "point {} of strand '{}' does",
                      k + 1, strand.name));
  if (!strand.path.back().rides_on.empty()) check_ride(table, strand, draft);
}

namespace {

using Eigen::Matrix3d;

Vector3d read_size(TomlTable& table, SurfaceShape shape) {
  const auto positive = [&](const char* key) {
    return table.number(Dimension::kLength, key, Range::kPositive);
  };
  // Sizes by the shape's own keys.
  if (shape == SurfaceShape::kEllipsoid) {
    const std::vector<double> s =
        table.numbers(Dimension::kLength, "semi_axes", 3, Range::kPositive);
    return {s[0], s[1], s[2]};
  }
  const double radius = positive("radius");
  if (shape == SurfaceShape::kSphere) return {radius, 0, 0};
  if (shape == SurfaceShape::kTorus) return {radius, positive("ring_radius"), 0};
  if (shape == SurfaceShape::kCapsule) return {radius, positive("half_length"), 0};
  return {radius, table.number_or(Dimension::kLength, "half_length", 0, Range::kPositive), 0};
}

/// Reads `axis` alone, with any x and y across it, or `x_axis` and `z_axis` of an ellipsoid.
Matrix3d read_axes(TomlTable& table, SurfaceShape shape) {
  if (shape == SurfaceShape::kSphere) return Matrix3d::Identity();
  Matrix3d axes;
  if (shape != SurfaceShape::kEllipsoid) {
    const Vector3d z = read_direction(table, "axis");
    const Tangents across = tangents(z);
    axes << across.e1, across.e2, z;
    return axes;
  }
  // Right-handed axes from two perpendicular ones.
  const Vector3d x = read_direction(table, "x_axis"), z = read_direction(table, "z_axis");
  if (std::abs(x.dot(z)) > 1e-6) table.fail("wanted 'x_axis' perpendicular to 'z_axis'", "x_axis");
  const Vector3d y = z.cross(x).normalized();
  axes << y.cross(z), y, z;
  return axes;
}

Surface read_surface(TomlTable& table, const SubjectDraft& draft) {
  Surface surface;
  surface.name = new_name(table, names_of(draft.subject.surfaces));
  surface.segment = segment_reference(table, "segment", draft);
  // Shape and sizes, then pose.
  surface.shape = table.choice("shape", kSurfaceShapeNames);
  surface.size = read_size(table, surface.shape);
  // A ring narrower than its tube has no hole.
  if (surface.shape == SurfaceShape::kTorus && surface.size[1] <= surface.size[0])
    table.fail(
        fmt::format("a torus with a hole needs 'ring_radius' above 'radius', got {:g} and "
                    "{:g} m",
                    surface.size[1], surface.size[0]));
  surface.center = table.vector(Dimension::kLength, "center");
  surface.axes = read_axes(table, surface.shape);
  return surface;
}

}  // namespace

void read_surfaces(TomlTable& top, SubjectDraft& draft) {
  read_each(top, "surface", draft.subject.surfaces, read_surface, draft);
}

}  // namespace thenar::internal
