#pragma once

/// Grid of cubes that list the triangles nearest to their points.

#include <array>
#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

#include <Eigen/Core>

#include "geometry/triangle_tree.h"

namespace thenar::internal {

/// A tree of cubes around a mesh, small near the surface and large far off. A cube of centre c and
/// half diagonal r lists the triangles that may be nearest to one of its points, the nearest to c
/// first. It leaves out triangles with
///   d(c, triangle) > d(c, mesh) + 2 r,
/// and triangles that are farther than some point s of the mesh at all eight corners, hence in the
/// whole cube:
///   d(p, triangle)^2 - |p - s|^2
/// is concave, since d^2 is the least of |p - x|^2 = |p|^2 - 2 p.x + |x|^2 over the triangle's
/// points x. A search of the list ends where d(c, triangle) - |p - c| exceeds the best distance so
/// far. Cubes whose lists would be long hold the nearest to c only, as a first guess for the tree;
/// so do those nearest to points beyond all cubes.
///
/// Cubes are filled when they have been asked so often that the tree, which answers until then, has
/// cost as much as filling will: in total at most about twice the cost of the best choice. Cubes
/// and tree find the same triangle (NearestTriangle), so that no answer depends on earlier
/// questions. May be asked from several threads at once.
class NearestGrid {
 public:
  /// @param share  of its distance from the mesh, an edge that need not be divided: less makes far
  ///               points quick and filling slow [1]
  explicit NearestGrid(const TriangleTree& tree, double share = 0.3);
  ~NearestGrid();
  NearestGrid(const NearestGrid&) = delete;
  NearestGrid& operator=(const NearestGrid&) = delete;

  /// The nearest triangle of all. @param tree  that the grid was built from
  [[nodiscard]] NearestTriangle nearest(const Eigen::Vector3d& p, const TriangleTree& tree) const;

 private:
  struct Candidate {
    double distance;  // from the cube's centre [m]
    int triangle;
  };
  struct Divided;
  struct Cell {
    std::atomic<int> count{kUnfilled};  // of candidates, or one of those below; set last
    std::atomic<int> asked{0};          // while it is unfilled
    union {
      const Candidate* candidates = nullptr;
      Divided* divided;
    };
  };
  /// Eight smaller cells that replace a cube that is too large.
  struct Divided {
    std::array<Cell, 8> cells;
    std::vector<int> triangles;  // that may be nearest, the nearest to the centre first
  };
  struct Ball {  // around a triangle
    Eigen::Vector3d centre;
    double radius;
  };
  struct Block {
    Eigen::Vector3i low;  // in smallest cubes
    int level;            // its edge is 2^level of them
  };
  static constexpr int kGuess = -1, kDivided = -2, kUnfilled = -3;

  static bool nearer(const Candidate& a, const Candidate& b);
  static Ball ball_of(const TriangleForm& form);
  bool fill_if_due(Cell& cell, const Block& block, const std::vector<int>& above,
                   const TriangleTree& tree) const;
  void fill(Cell& cell, const Block& block, const std::vector<int>& above,
            const TriangleTree& tree) const;
  [[nodiscard]] std::vector<Candidate> near(const Block& block, const std::vector<int>& above,
                                            const TriangleTree& tree) const;
  void drop_beaten(const Block& block, std::vector<Candidate>& here,
                   const TriangleTree& tree) const;
  [[nodiscard]] Eigen::Vector3d centre(const Block& block) const;

  Eigen::Vector3d origin_;
  int levels_ = 0;
  double share_;
  double cell_ = 0, inverse_ = 0;  // edge of the smallest cubes [m], 1 / edge [1/m]
  std::vector<Ball> balls_;        // of each triangle
  std::vector<int> every_;         // triangle

  // Filled on demand: answers do not depend on them.
  mutable std::mutex filling_;
  mutable Cell root_;
  mutable std::vector<std::unique_ptr<Divided>> divided_;
  mutable std::vector<std::unique_ptr<Candidate[]>> candidates_;
};

}  // namespace thenar::internal
