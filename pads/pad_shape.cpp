#include "pads/pad_shape.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.h"
#include "base/spatial.h"
#include "base/units.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

constexpr double kQuarterTurn = 1.5707963267948966;  // pi / 2
constexpr double kInnerHalfSide = 0.5;  // half side of the square in the middle of the disc [1]

/// Returns a point of a half ellipsoid whose polar angle is proportional to the radius on the disc.
Vector3d dome(double a, double b, const Vector3d& half_axes) {
  const double r = std::hypot(a, b), polar = kQuarterTurn * r;
  const double side = r > 1e-12 ? std::sin(polar) / r : kQuarterTurn;
  return {half_axes[0] * side * a, half_axes[1] * side * b, half_axes[2] * std::cos(polar)};
}

}  // namespace

PadChart::PadChart(PadShape shape) : shape_(std::move(shape)) {
  const PadShape& s = shape_;
  for (const double length :
       {s.length, s.width, s.height, s.bone_length, s.bone_width, s.bone_height})
    require(length > 0 && std::isfinite(length), "a pad needs lengths above 0, got {} m", length);
  require(s.bone_length < s.length && s.bone_width < s.width && s.bone_height < s.height,
          "the bone of a pad must lie within its skin");
  double layers = 0;
  for (const SkinLayer& layer : s.layers) {
    require(layer.thickness > 0, "a layer of skin needs a thickness above 0, got {} m",
            layer.thickness);
    layers += layer.thickness;
  }
  // Check on a grid that the layers fit everywhere.
  for (int i = -8; i <= 8; ++i)
    for (int j = -8; j <= 8; ++j) {
      const double a = i / 8.0, b = j / 8.0;
      if (std::hypot(a, b) > 1) continue;
      require(thickness(a, b) > layers,
              "layers of skin, {:g} mm, do not fit above the bone: {:g} mm", layers * 1e3,
              thickness(a, b) * 1e3);
    }
}

Vector3d PadChart::bone_point(double a, double b) const {
  return dome(a, b, {shape_.bone_length / 2, shape_.bone_width / 2, shape_.bone_height});
}

Vector3d PadChart::skin_point(double a, double b) const {
  Vector3d outer = dome(a, b, {shape_.length / 2, shape_.width / 2, shape_.height});
  if (!shape_.skin) return outer;
  // Trace the ray from the bone in steps as long as the distance, which cross no surface.
  const Vector3d from = bone_point(a, b), along = (outer - from).normalized();
  double t = 0, depth = -shape_.skin->distance(from);
  require(depth > 0, "the bone of a pad leaves its skin at ({:g}, {:g}, {:g}) mm", from[0] * 1e3,
          from[1] * 1e3, from[2] * 1e3);
  for (int k = 0; k < 1000 && depth > 1e-9; ++k) {
    t += depth;
    depth = -shape_.skin->distance(from + t * along);
  }
  require(depth <= 1e-9, "a ray from the bone of a pad does not end on its skin");
  return from + t * along;
}

double PadChart::thickness(double a, double b) const {
  return (skin_point(a, b) - bone_point(a, b)).norm();
}

/// Returns the distance of a level from the bone where the soft tissue has a given thickness [m].
double PadChart::level_depth(double w, double thickness) const {
  // Sum the layers of skin.
  double skin = 0;
  for (const SkinLayer& layer : shape_.layers) skin += layer.thickness;
  const auto count = static_cast<double>(shape_.layers.size());
  if (count == 0) return w * thickness;
  // The inner half of the levels is the pulp, the outer half the layers, as in pad_mesh().
  if (w <= 0.5) return 2 * w * (thickness - skin);
  double depth = thickness, at = (1 - w) * 2 * count;  // number of layers from the outside
  for (const SkinLayer& layer : shape_.layers) {
    const double part = std::min(1.0, at);
    depth -= part * layer.thickness;
    at -= part;
  }
  return depth;
}

Vector3d PadChart::place(const Vector3d& c) const {
  // Place the point on the segment from bone to skin, at the depth of the level.
  const Vector3d bone = bone_point(c[0], c[1]), skin = skin_point(c[0], c[1]);
  const double all = (skin - bone).norm();
  return bone + level_depth(c[2], all) / all * (skin - bone);
}

Vector3d PadChart::middle(const Vector3d& a, const Vector3d& b) const {
  Vector3d out = 0.5 * (a + b);
  if (on_rim(a) && on_rim(b)) out.head<2>().normalize();
  return out;
}

Vector3d PadChart::middle_of_face(const std::array<Vector3d, 4>& corners,
                                  const Vector3d& mean) const {
  Vector3d out = mean;
  if (std::all_of(corners.begin(), corners.end(), on_rim)) out.head<2>().normalize();
  return out;
}

HexMesh pad_mesh(const PadShape& shape, const PadCells& cells) {
  require(cells.across > 0 && cells.around > 0 && cells.through > 0,
          "a pad's mesh needs at least one cell each way");
  // Create the nodes and quadrilaterals of the square in the middle of the disc.
  std::vector<Eigen::Vector2d> disc;
  std::vector<std::array<int, 4>> quads;  // bits 1, 2: along the axes
  const int n = cells.across;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i)
      disc.emplace_back(kInnerHalfSide * (2.0 * i / n - 1), kInnerHalfSide * (2.0 * j / n - 1));
  const auto inner = [&](int i, int j) { return j * (n + 1) + i; };
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      quads.push_back({inner(i, j), inner(i + 1, j), inner(i, j + 1), inner(i + 1, j + 1)});
  // List the border of the square, counterclockwise.
  std::vector<int> ring;
  for (int i = 0; i < n; ++i) ring.push_back(inner(i, 0));
  for (int j = 0; j < n; ++j) ring.push_back(inner(n, j));
  for (int i = n; i > 0; --i) ring.push_back(inner(i, n));
  for (int j = n; j > 0; --j) ring.push_back(inner(0, j));
  const std::vector<int> square = ring;
  // Add rings from the square's border to the rim of the disc.
  for (int layer = 1; layer <= cells.around; ++layer) {
    std::vector<int> next;
    const double part = static_cast<double>(layer) / cells.around;
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Eigen::Vector2d from = disc[square[k]];
      // Interpolate to equal angles on the rim.
      const double angle = (static_cast<double>(k) / n - 1.5) * kQuarterTurn;
      next.push_back(static_cast<int>(disc.size()));
      disc.emplace_back((1 - part) * from +
                        part * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    }
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const std::size_t after = (k + 1) % ring.size();
      quads.push_back({ring[k], next[k], ring[after], next[after]});
    }
    ring = next;
  }
  // Set the levels of the pulp, then of the layers of skin, and copy the disc to each level.
  const auto layers = static_cast<int>(shape.layers.size());
  std::vector<double> levels;
  for (int k = 0; k <= cells.through; ++k)
    levels.push_back((layers > 0 ? 0.5 : 1.0) * k / cells.through);
  for (int k = 1; k <= layers; ++k) levels.push_back(0.5 + 0.5 * k / layers);
  const auto per_level = static_cast<int>(disc.size());
  Eigen::Matrix3Xd points(3, per_level * static_cast<Eigen::Index>(levels.size()));
  for (std::size_t k = 0; k < levels.size(); ++k)
    for (int i = 0; i < per_level; ++i)
      points.col(static_cast<Eigen::Index>(k) * per_level + i) << disc[i], levels[k];
  // Create the cells between two levels; the pulp is region 0, layers follow from the inside out.
  std::vector<HexCell> list;
  for (int k = 0; k + 1 < static_cast<int>(levels.size()); ++k)
    for (const std::array<int, 4>& quad : quads) {
      HexCell cell;
      cell.region = k < cells.through ? 0 : k - cells.through + 1;
      for (std::size_t c = 0; c < 4; ++c) {
        cell.corners[c] = k * per_level + quad[c];
        cell.corners[c + 4] = (k + 1) * per_level + quad[c];
      }
      list.push_back(cell);
    }
  return {std::make_shared<PadChart>(shape), points, std::move(list)};
}

std::vector<bool> skin_nodes(const HexMesh& mesh) {
  std::vector<bool> out;
  for (int node = 0; node < mesh.nodes(); ++node)
    out.push_back(PadChart::on_skin(mesh.chart_point(node)));
  return out;
}

std::vector<bool> held_by_bone(const HexMesh& mesh) {
  std::vector<bool> held(static_cast<std::size_t>(mesh.nodes()));
  for (int node = 0; node < mesh.nodes(); ++node)
    held[node] =
        PadChart::on_bone(mesh.chart_point(node)) || PadChart::on_rim(mesh.chart_point(node));
  return held;
}

FoundationColumns pad_columns(const PadShape& shape, int rings) {
  require(rings > 0, "a bed of springs needs at least one ring, got {}", rings);
  const PadChart chart(shape);
  const auto at = [&](double r, double angle, double level) {
    return chart.place({r * std::cos(angle), r * std::sin(angle), level});
  };
  std::vector<Eigen::Vector3d> skin, normal;
  std::vector<double> thickness, area;
  const double width = 1.0 / rings;
  for (int ring = 0; ring < rings; ++ring) {
    // Divide the ring into cells that are about as long as wide.
    const double r = (ring + 0.5) * width;
    const int count = static_cast<int>(std::lround(2 * kPi * (ring + 0.5)));
    const double turn = 2 * kPi / count;
    for (int k = 0; k < count; ++k) {
      const double angle = (k + 0.5) * turn;
      const Eigen::Vector3d middle = at(r, angle, 1);
      // Compute the area from the two middle lines of the cell, chords of arcs.
      const Eigen::Vector3d side =
          (at(r + width / 2, angle, 1) - at(r - width / 2, angle, 1))
              .cross(at(r, angle + turn / 2, 1) - at(r, angle - turn / 2, 1));
      skin.push_back(middle);
      area.push_back(side.norm() * turn / 2 / std::sin(turn / 2));
      // Compute the thickness down to the bone, and the normal away from it.
      const Eigen::Vector3d up = middle - at(r, angle, 0);
      thickness.push_back(up.norm());
      normal.push_back(side.normalized());
      if (normal.back().dot(up) < 0) normal.back() *= -1;
    }
  }
  // Collect the columns in matrices.
  FoundationColumns out;
  const auto count = static_cast<Eigen::Index>(skin.size());
  out.skin = as_columns(skin);
  out.normal = as_columns(normal);
  out.thickness = Eigen::Map<const Eigen::VectorXd>(thickness.data(), count);
  out.area = Eigen::Map<const Eigen::VectorXd>(area.data(), count);
  return out;
}

}  // namespace thenar
