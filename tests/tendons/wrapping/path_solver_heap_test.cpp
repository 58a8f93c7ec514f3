// Tests that tendons/wrapping/path_solver.cpp uses no heap once it has seen a posture.

#include <gtest/gtest.h>

#include "tests/counted_heap.h"
#include "tests/tendons/wrapping/wrap_samples.h"

namespace thenar {
namespace {

TEST(PathSolverHeap, IsLeftAloneAfterTheFirstPosture) {
  for (const SurfaceShape shape : {SurfaceShape::kCylinder, SurfaceShape::kSphere,
                                   SurfaceShape::kEllipsoid, SurfaceShape::kCapsule}) {
    const PathSet set = sample::extensor(shape);
    const Tree<double> tree = sample::finger();
    const Eigen::Vector3d first(0.5, 0.7, 0.4), second(0.6, 0.5, 0.3);
    const TreeState<double> one = pose_tree(tree, first), two = pose_tree(tree, second);
    PathSolver solver(set);
    Eigen::MatrixXd R(1, 3);
    path_arms(tree, one, set, solver.solve(one), R);
    const std::size_t before = allocations;
    path_arms(tree, two, set, solver.solve(two), R);
    EXPECT_EQ(allocations, before);
  }
}

TEST(PathSolverHeap, IsCountedHere) {
  const std::size_t before = allocations;
  std::vector<double> block(100);
  EXPECT_GT(allocations, before) << block.size();
}

}  // namespace
}  // namespace thenar
