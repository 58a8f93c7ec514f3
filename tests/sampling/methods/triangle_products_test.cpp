// Tests for sampling/methods/triangle_products.cpp.

#include "sampling/methods/triangle_products.h"

#include <gtest/gtest.h>

#include "base/random_stream.h"
#include "tests/matrix_near.h"

namespace thenar::internal {
namespace {

// Sizes below, at and above whole blocks of columns and rows, against Eigen's products.
TEST(TriangleProducts, AreThoseOfTheWholeMatrix) {
  for (const int n : {1, 2, 3, 4, 5, 8, 11, 20, 63, 64, 65, 71, 82})
    for (const Shape shape : {Shape::kFull, Shape::kLower}) {
      RandomStream random(1, 0, static_cast<std::uint32_t>(n));
      const auto draw = [&random] { return random.normal(); };
      Eigen::MatrixXd F = Eigen::MatrixXd::NullaryExpr(n, n, draw);
      if (shape == Shape::kLower) F = F.triangularView<Eigen::Lower>().toDenseMatrix();
      const Eigen::VectorXd y = Eigen::VectorXd::NullaryExpr(n, draw),
                            before = Eigen::VectorXd::NullaryExpr(n, draw);
      Eigen::VectorXd x = before, out;
      add_product(F, shape, y, x);
      EXPECT_TRUE(matrix_near(x, before + F * y, 1e-13)) << n;
      transposed_product(F, shape, y, out);
      EXPECT_TRUE(matrix_near(out, F.transpose() * y, 1e-13)) << n;
    }
}

}  // namespace
}  // namespace thenar::internal
