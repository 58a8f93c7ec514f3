#include "data/io/mesh/polygons.h"

#include <algorithm>
#include <charconv>
#include <set>

#include <Eigen/Geometry>

#include "base/error.h"
#include "data/io/mesh/text_lines.h"

namespace thenar {
namespace {

// Triangulation takes as many steps as the polygon has corners times reflex corners; a file of a
// million quadrangles needs 4e6 steps, a crafted one could need 1e15.
constexpr double kMaxSteps = 1e8;

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Corners in the plane along the polygon's own normal, counter-clockwise.
std::vector<Eigen::Vector2d> flattened(const std::vector<Eigen::Vector3d>& corner) {
  // Newell's method: twice the area vector, whatever the polygon's shape.
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < corner.size(); ++i)
    normal += (corner[i] - corner[0]).cross(corner[(i + 1) % corner.size()] - corner[0]);
  // Drop the axis nearest to the normal, and keep the sense of rotation.
  Eigen::Index away = 0;
  normal.cwiseAbs().maxCoeff(&away);
  const Eigen::Index x = (away + 1) % 3, y = (away + 2) % 3;
  const double side = normal[away] < 0 ? -1 : 1;
  std::vector<Eigen::Vector2d> flat;
  flat.reserve(corner.size());
  for (const Eigen::Vector3d& p : corner)
    flat.emplace_back(side * (p[x] - corner[0][x]), p[y] - corner[0][y]);
  return flat;
}

/// Triangulates polygons by ear clipping.
class Cutter {
 public:
  Cutter(const Polygons& polygons, const std::string& path) : polygons_(polygons), path_(path) {}

  TriangleSoup run() {
    const int* corners = polygons_.corners.data();
    for (face_ = 0; face_ < polygons_.sizes.size(); ++face_) {
      const int size = polygons_.sizes[face_];
      if (size >= 3) cut(std::vector<int>(corners, corners + size));
      corners += size;
    }
    return std::move(soup_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw DataError(path_, polygons_.lines[face_], what);
  }

  void append(int a, int b, int c) {
    if (soup_.corners.size() >= 3 * kMaxTriangles)
      fail(fmt::format("wanted at most {} triangles, got more", kMaxTriangles));
    for (const int corner : {a, b, c}) {
      soup_.corners.push_back(polygons_.vertices[corner]);
      soup_.vertices.push_back(corner);
    }
  }

  void cut(const std::vector<int>& face) {
    // Corners must exist.
    const int count = static_cast<int>(polygons_.vertices.size());
    for (const int corner : face)
      if (corner < 0 || corner >= count)
        fail(fmt::format("a face has corner {}, and there are {} vertices, counted from 0", corner,
                         count));
    // Triangles need no cutting.
    if (face.size() == 3) return append(face[0], face[1], face[2]);
    std::vector<Eigen::Vector3d> place;
    place.reserve(face.size());
    for (const int corner : face) place.push_back(polygons_.vertices[corner]);
    cut_ears(face, flattened(place));
  }

  /// Clips ears, one after the other.
  void cut_ears(const std::vector<int>& face, const std::vector<Eigen::Vector2d>& flat) {
    left_.resize(face.size());
    for (std::size_t i = 0; i < left_.size(); ++i) left_[i] = i;
    // Without reflex corners the polygon is convex.
    reflex_.clear();
    for (std::size_t i = 0; i < left_.size(); ++i)
      if (turn(flat, i) < 0) reflex_.push_back(i);
    if (reflex_.empty()) return fan(face);

    // Clip from the second corner on, until a triangle is left.
    std::size_t at = 1;
    while (left_.size() > 3) {
      // If there is no ear, as in polygons that cross themselves, clip any corner.
      std::size_t tried = 0;
      for (; tried < left_.size() && !is_ear(face, flat, at % left_.size()); ++tried) ++at;
      steps_ += static_cast<double>(tried + left_.size());
      if (steps_ > kMaxSteps)
        fail(fmt::format("wanted faces that are convex or have few corners, got one of {}",
                         face.size()));
      at %= left_.size();
      append(face[before(at)], face[left_[at]], face[after(at)]);
      left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(at));
    }
    append(face[left_[0]], face[left_[1]], face[left_[2]]);
  }

  // Corners that are left on either side of one.
  [[nodiscard]] std::size_t before(std::size_t i) const {
    return left_[(i + left_.size() - 1) % left_.size()];
  }
  [[nodiscard]] std::size_t after(std::size_t i) const { return left_[(i + 1) % left_.size()]; }

  /// Twice the signed area at a corner; negative: the corner is reflex.
  [[nodiscard]] double turn(const std::vector<Eigen::Vector2d>& flat, std::size_t i) const {
    const Eigen::Vector2d& here = flat[left_[i]];
    return cross(here - flat[before(i)], flat[after(i)] - here);
  }

  /// An ear is convex, and no reflex corner lies in its triangle.
  bool is_ear(const std::vector<int>& face, const std::vector<Eigen::Vector2d>& flat,
              std::size_t i) {
    if (!(turn(flat, i) > 0)) return false;
    const std::size_t a = before(i), b = left_[i], c = after(i);
    return std::none_of(reflex_.begin(), reflex_.end(), [&](std::size_t k) {
      ++steps_;
      if (k == a || k == b || k == c || face[k] == face[a] || face[k] == face[c]) return false;
      const Eigen::Vector2d& p = flat[k];
      return cross(flat[b] - flat[a], p - flat[a]) >= 0 &&
             cross(flat[c] - flat[b], p - flat[b]) >= 0 &&
             cross(flat[a] - flat[c], p - flat[c]) >= 0;
    });
  }

  void fan(const std::vector<int>& face) {
    for (std::size_t k = 1; k + 1 < face.size(); ++k) append(face[0], face[k], face[k + 1]);
  }

  const Polygons& polygons_;
  const std::string& path_;
  std::size_t face_ = 0;
  double steps_ = 0;
  std::vector<std::size_t> left_;    // corners of the face in work that are not clipped
  std::vector<std::size_t> reflex_;  // corners of it that were reflex at first
  TriangleSoup soup_;
};

}  // namespace

TriangleSoup triangulate_polygons(const Polygons& polygons, const std::string& path) {
  return Cutter(polygons, path).run();
}

namespace {

/// Vertex index of a corner "V", "V/T", "V//N" or "V/T/N", from 0; V counts from 1, or backwards
/// from the last vertex if it is negative.
int vertex_of(TextLines& lines, std::string_view corner, std::size_t count) {
  const std::string_view first = corner.substr(0, corner.find('/'));
  int number = 0;
  const auto [stop, error] = std::from_chars(first.data(), first.data() + first.size(), number);
  if (error != std::errc() || stop != first.data() + first.size() || number == 0)
    lines.fail(fmt::format("wanted the number of a vertex, got {}", in_quotes(corner)));
  if (number > 0) return number - 1;
  if (static_cast<std::size_t>(-static_cast<long>(number)) > count)
    lines.fail(
        fmt::format("corner {} of a face lies before the first of {} vertices", number, count));
  return static_cast<int>(count) + number;
}

}  // namespace

Polygons parse_obj(const std::string& text, const std::string& path) {
  TextLines lines(text, path);
  Polygons found;
  while (lines.next()) {
    // Vertices and faces; everything else is skipped.
    const std::string_view kind = lines.word();
    if (kind == "v") {
      found.vertices.push_back(lines.vector3());
    } else if (kind == "f") {
      const std::size_t first = found.corners.size();
      for (std::string_view corner; !(corner = lines.word()).empty();)
        found.corners.push_back(vertex_of(lines, corner, found.vertices.size()));
      found.sizes.push_back(static_cast<int>(found.corners.size() - first));
      found.lines.push_back(lines.line());
    }
  }
  return found;
}

namespace {

constexpr int kMaxPolygonCount = 100'000'000;  // Most corners, faces, or sides of a face

void go_on(TextLines& lines) {
  if (!lines.next()) lines.fail("the file ends before all corners and faces are listed");
}

}  // namespace

Polygons parse_off(const std::string& text, const std::string& path) {
  static const std::set<std::string_view> kinds{"OFF",   "COFF",   "NOFF",   "CNOFF",
                                                "STOFF", "STCOFF", "STNOFF", "STCNOFF"};
  TextLines lines(text, path);
  go_on(lines);
  const std::string_view kind = lines.word();
  if (kinds.count(kind) == 0)
    lines.fail(fmt::format("wanted an OFF in text, got {}", in_quotes(kind)));
  // The counts follow on the same or the next line.
  TextLines same = lines;
  if (same.word().empty()) go_on(lines);
  const int corners = lines.whole(0, kMaxPolygonCount), faces = lines.whole(0, kMaxPolygonCount);
  // "0 0 0" and a line end take 6 bytes, the shortest face takes 2.
  if (6.0 * corners + 2.0 * faces > static_cast<double>(lines.bytes_left()) + 1)
    lines.fail(fmt::format("{} corners and {} faces are promised, more than {} bytes can hold",
                           corners, faces, lines.bytes_left()));

  Polygons found;
  // Corners, then faces.
  for (int i = 0; i < corners; ++i) {
    go_on(lines);
    found.vertices.push_back(lines.vector3());
  }
  for (int i = 0; i < faces; ++i) {
    go_on(lines);
    const int sides = lines.whole(1, kMaxPolygonCount);
    for (int k = 0; k < sides; ++k) found.corners.push_back(lines.whole(0, corners - 1));
    found.sizes.push_back(sides);
    found.lines.push_back(lines.line());
  }
  return found;
}

}  // namespace thenar
