// Tests for kinematics_fit/kernel/: every backend of this processor gives the same bits.

#include <cstring>

#include <gtest/gtest.h>

#include "kinematics_fit/kernel/batch.h"
#include "kinematics_fit/kernel/compile.h"
#include "tests/kinematics_fit/kernel/kernel_cases.h"
#include "tests/posterior/thumb_scene.h"

namespace thenar {
namespace {

using kernel::SimdBackend;

/// Forces, then the gradient, of some points.
struct Bits {
  Eigen::MatrixXd forces, gradient;
};

bool same_bits(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return a.rows() == b.rows() && a.cols() == b.cols() &&
         std::memcmp(a.data(), b.data(), sizeof(double) * static_cast<std::size_t>(a.size())) == 0;
}
bool operator==(const Bits& a, const Bits& b) {
  return same_bits(a.forces, b.forces) && same_bits(a.gradient, b.gradient);
}

/// A case compiled, with points and weights.
struct KernelScene {
  explicit KernelScene(const sample::KernelCase& c, Eigen::Index points) {
    kernel::compile(c.digit, c.parameters, c.plan, program);
    std::mt19937 rng(7);
    u.resize(program.fit_coordinates, points);
    w.resize(3 * program.trials, points);
    for (Eigen::Index k = 0; k < points; ++k) {
      u.col(k) = sample::displacement(c, 0.4, rng);
      w.col(k) = sample::normal(w.rows(), rng);
    }
  }
  [[nodiscard]] Bits through(const std::vector<SimdBackend>& simd_backends, Eigen::Index first,
                             Eigen::Index count) const {
    kernel::Batch batch = kernel::run_batch(program, simd_backends, u.middleCols(first, count),
                                            kernel::KeepTape::kYes);
    const Eigen::MatrixXd gradient =
        kernel::adjoint_batch(program, batch, w.middleCols(first, count));
    return {std::move(batch.forces), gradient};
  }

  kernel::Program program;
  Eigen::MatrixXd u, w;
};

class KernelUnits : public testing::TestWithParam<const char*> {
 protected:
  [[nodiscard]] static KernelScene scene() {
    return KernelScene(std::string(GetParam()) == "thumb"
                           ? sample::kernel_case(sample::thumb_problem())
                           : sample::everything_free(),
                       19);
  }
};

TEST_P(KernelUnits, GiveTheSameBits) {
  const KernelScene s = scene();
  const Bits scalar = s.through({kernel::simd_backends().back()}, 0, 19);
  ASSERT_TRUE(scalar.forces.allFinite() && scalar.gradient.allFinite());
  for (const SimdBackend& backend : kernel::simd_backends())
    EXPECT_TRUE(s.through({backend}, 0, 19) == scalar) << backend.name;
  EXPECT_TRUE(s.through(kernel::simd_backends(), 0, 19) == scalar);
}

TEST_P(KernelUnits, GiveAPointAloneWhatItHasInABatch) {
  const KernelScene s = scene();
  const Bits all = s.through(kernel::simd_backends(), 0, 19);
  for (const Eigen::Index k : {0, 3, 7, 8, 17, 18}) {
    const Bits alone{all.forces.col(k), all.gradient.col(k)};
    EXPECT_TRUE(s.through(kernel::simd_backends(), k, 1) == alone) << k;
    EXPECT_TRUE(s.through({kernel::simd_backends().front()}, k, 1) == alone) << k;
  }
}

// A neighbour that breaks is no concern of the other lanes.
TEST_P(KernelUnits, KeepLanesApart) {
  KernelScene s = scene();
  const Bits before = s.through(kernel::simd_backends(), 0, 8);
  s.u.col(2).setConstant(std::numeric_limits<double>::quiet_NaN());
  s.u.col(5).setConstant(1e300);
  const Bits after = s.through(kernel::simd_backends(), 0, 8);
  EXPECT_TRUE(after.forces.col(2).array().isNaN().all());
  for (const Eigen::Index k : {0, 1, 3, 4, 6, 7}) {
    EXPECT_TRUE(same_bits(after.forces.col(k), before.forces.col(k))) << k;
    EXPECT_TRUE(same_bits(after.gradient.col(k), before.gradient.col(k))) << k;
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, KernelUnits, testing::Values("thumb", "everything"));

}  // namespace
}  // namespace thenar
