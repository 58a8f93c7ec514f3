#pragma once

/// Which triangles may be nearest to the points of a small cube.

#include <vector>

#include <Eigen/Core>

#include "base/shapes/triangle_tree.h"

namespace thenar::internal {

/// A cubic grid around a mesh. A cell of centre c and half diagonal r lists the triangles with
///   d(c, triangle) <= d(c, mesh) + 2 r,
/// the nearest to c first: no other can be nearest to one of its points. A search of the list ends
/// where d(c, triangle) - |p - c| reaches the best distance so far. Cells far from the surface,
/// whose lists would be long, hold the nearest to c only, as a first guess for the tree.
class NearestGrid {
 public:
  explicit NearestGrid(const TriangleTree& tree);

  /// The nearest triangle of all.
  [[nodiscard]] NearestTriangle nearest(const Eigen::Vector3d& p, const TriangleTree& tree) const;

 private:
  struct Candidate {
    double distance;  // from the cell's centre [m]
    int triangle;
  };
  struct Cell {
    int first;
    int count;  // of candidates; -1: a guess only
  };
  struct Ball {  // around a triangle
    Eigen::Vector3d centre;
    double radius;
  };
  struct Block {
    Eigen::Vector3i low;
    int edge;  // in cells, a power of two
  };
  static Ball ball_of(const TriangleForm& form);
  void refine(const Block& block, const std::vector<Candidate>& above, const TriangleTree& tree);
  void fill(const Block& block, const Cell& cell);
  [[nodiscard]] Eigen::Vector3d centre(const Block& block) const;

  Eigen::Vector3d origin_;
  Eigen::Vector3i size_;
  double cell_ = 0, inverse_ = 0;  // edge [m], 1 / edge [1/m]
  std::vector<Cell> cells_;
  std::vector<Candidate> candidates_;
  std::vector<Ball> balls_;  // of each triangle, while the grid is built
};

}  // namespace thenar::internal
