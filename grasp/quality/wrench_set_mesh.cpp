#include "grasp/quality/wrench_set_mesh.h"

#include <map>
#include <tuple>
#include <vector>

#include "base/error.h"

namespace thenar {
namespace {

using GridPoint = std::tuple<int, int, int>;  // on the octahedron |x| + |y| + |z| = pieces

/// Directions, and triangles between them, counter-clockwise from outside.
struct Sphere {
  std::vector<GridPoint> places;
  std::vector<Eigen::Vector3i> triangles;
};

/// Subdivided octahedron.
class Octahedron {
 public:
  explicit Octahedron(int pieces) : pieces_(pieces) {
    for (int octant = 0; octant < 8; ++octant)
      add_face((octant & 1) ? -1 : 1, (octant & 2) ? -1 : 1, (octant & 4) ? -1 : 1);
  }
  [[nodiscard]] const Sphere& sphere() const { return sphere_; }

 private:
  /// Barycentric grid of one face; mirrored faces reverse their triangles.
  void add_face(int x, int y, int z) {
    const auto at = [&](int i, int j) { return vertex({x * i, y * j, z * (pieces_ - i - j)}); };
    const auto add = [&](int a, int b, int c) {
      if (x * y * z > 0)
        sphere_.triangles.emplace_back(a, b, c);
      else
        sphere_.triangles.emplace_back(a, c, b);
    };
    for (int i = 0; i < pieces_; ++i)
      for (int j = 0; i + j < pieces_; ++j) {
        add(at(i, j), at(i + 1, j), at(i, j + 1));
        if (i + j + 1 < pieces_) add(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
      }
  }

  int vertex(const GridPoint& place) {
    const auto [found, is_new] = numbers_.try_emplace(place, static_cast<int>(numbers_.size()));
    if (is_new) sphere_.places.push_back(place);
    return found->second;
  }

  int pieces_;
  Sphere sphere_;
  std::map<GridPoint, int> numbers_;
};

/// Rows that select the coordinates; for a slice the other coordinates follow.
Eigen::MatrixXd picture_rows(const std::array<int, 3>& coordinates, PictureKind kind) {
  // Selected coordinates first.
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(kind == PictureKind::kSlice ? 6 : 3, 6);
  std::array<bool, 6> seen{};
  for (int i = 0; i < 3; ++i) {
    const int coordinate = coordinates[i];
    require(coordinate >= 0 && coordinate < 6 && !seen[coordinate],
            "wanted three different coordinates of 0..5, got {}, {}, {}", coordinates[0],
            coordinates[1], coordinates[2]);
    seen[coordinate] = true;
    rows(i, coordinate) = 1;
  }
  // A slice holds the other coordinates at zero.
  for (int coordinate = 0, row = 3; kind == PictureKind::kSlice && coordinate < 6; ++coordinate)
    if (!seen[coordinate]) rows(row++, coordinate) = 1;
  return rows;
}

}  // namespace

WrenchSetMesh wrench_set_mesh(const ForceSet& forces, const std::array<int, 3>& coordinates,
                              PictureKind kind, int pieces) {
  require(pieces >= 1, "wanted one piece or more of each edge, got {}", pieces);
  const Eigen::MatrixXd rows = picture_rows(coordinates, kind);
  const Octahedron octahedron(pieces);
  const Sphere& sphere = octahedron.sphere();
  WrenchSetMesh picture;
  picture.mesh.vertices.resize(3, sphere.places.size());
  // Boundary point of the set along each direction.
  for (std::size_t i = 0; i < sphere.places.size(); ++i) {
    const auto [x, y, z] = sphere.places[i];
    Eigen::VectorXd way = Eigen::VectorXd::Zero(rows.rows());
    way.head<3>() = Eigen::Vector3d(x, y, z).normalized();
    const WrenchSupport reach =
        support_along(forces, rows, Eigen::VectorXd::Zero(rows.rows()), way);
    const bool found = reach.status == Status::kSolved;
    picture.failed += found ? 0 : 1;
    picture.mesh.vertices.col(i) = (found ? reach.value : 0.0) * way.head<3>();
  }
  picture.mesh.triangles = as_columns(sphere.triangles);
  return picture;
}

}  // namespace thenar
