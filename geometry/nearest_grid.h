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

/// Tree of cubes around a mesh, small near the surface and large far from it. A cube of centre c
/// and half diagonal r lists the triangles that may be nearest to one of its points, the nearest to
/// c first. It excludes triangles with
///   d(c, triangle) > d(c, mesh) + 2 r,
/// and triangles that are farther than some point s of the mesh at all eight corners, and hence in
/// the whole cube:
///   d(p, triangle)^2 - |p - s|^2
/// is concave, since d^2 is the minimum of |p - x|^2 = |p|^2 - 2 p.x + |x|^2 over the triangle's
/// points x. A search of the list ends where d(c, triangle) - |p - c| exceeds the best distance so
/// far. Cubes with long lists store only the nearest to c, as a first guess for the tree; so do
/// those nearest to points outside of all cubes.
///
/// A cube is filled once queries of the tree, which answers until then, have cost as much as
/// filling will: the total is at most about twice the cost of the best choice. Cubes and tree find
/// the same triangle (NearestTriangle), so that no result depends on earlier queries. Queries from
/// several threads are allowed.
class NearestGrid {
 public:
  /// @param share  ratio of edge to distance from the mesh below which a cube is not divided:
  ///               smaller values make queries of far points faster and filling slower [1]
  explicit NearestGrid(const TriangleTree& tree, double share = 0.3);
  ~NearestGrid();
  NearestGrid(const NearestGrid&) = delete;
  NearestGrid& operator=(const NearestGrid&) = delete;

  /// Finds the nearest of all triangles. @param tree  tree from which the grid was built
  [[nodiscard]] NearestTriangle nearest(const Eigen::Vector3d& p, const TriangleTree& tree) const;

 private:
  /// A triangle in the list of a cube.
  struct Candidate {
    double distance;  // distance from the cube's centre [m]
    int triangle;
  };
  struct Divided;
  /// A cube: unfilled, with a list of candidates, or divided.
  struct Cell {
    std::atomic<int> count{kUnfilled};  // number of candidates, or a state below; set last
    std::atomic<int> queries{0};        // number of queries while it is unfilled
    union {
      const Candidate* candidates = nullptr;
      Divided* divided;
    };
  };
  /// Eight smaller cells that replace a cube that is too large.
  struct Divided {
    std::array<Cell, 8> cells;
    std::vector<int> triangles;  // triangles that may be nearest, the nearest to the centre first
  };
  struct Ball {  // bounding ball of a triangle
    Eigen::Vector3d centre;
    double radius;
  };
  /// A cube by its position and size.
  struct Block {
    Eigen::Vector3i low;  // lower corner, in smallest cubes
    int level;            // edge over that of the smallest cubes, as a power of 2
  };
  static constexpr int kGuess = -1, kDivided = -2, kUnfilled = -3;  // states of Cell::count

  static bool is_nearer(const Candidate& a, const Candidate& b);
  static Ball bounding_ball(const TriangleForm& form);
  bool fill_if_due(Cell& cell, const Block& block, const std::vector<int>& above,
                   const TriangleTree& tree) const;
  void fill(Cell& cell, const Block& block, const std::vector<int>& above,
            const TriangleTree& tree) const;
  [[nodiscard]] std::vector<Candidate> find_candidates(const Block& block,
                                                       const std::vector<int>& above,
                                                       const TriangleTree& tree) const;
  void remove_dominated(const Block& block, std::vector<Candidate>& here,
                        const TriangleTree& tree) const;
  [[nodiscard]] Eigen::Vector3d centre(const Block& block) const;

  Eigen::Vector3d origin_;         // lower corner of the root [m] (3)
  int levels_ = 0;                 // number of levels
  double share_;                   // parameter of the constructor [1]
  double cell_ = 0, inverse_ = 0;  // edge of the smallest cubes [m], 1 / edge [1/m]
  std::vector<Ball> balls_;        // bounding ball of each triangle
  std::vector<int> all_triangles_;

  // Filled on demand, without effect on results.
  mutable std::mutex filling_;
  mutable Cell root_;
  mutable std::vector<std::unique_ptr<Divided>> divided_;
  mutable std::vector<std::unique_ptr<Candidate[]>> candidates_;
};

}  // namespace thenar::internal
