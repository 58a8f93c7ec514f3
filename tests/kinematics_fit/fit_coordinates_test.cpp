// Tests for kinematics_fit/fit_coordinates.cpp: layout, names and bounds of the coordinates.

#include "kinematics_fit/fit_coordinates.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "base/units.h"
#include "tests/kinematics_fit/fit_samples.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using Eigen::VectorXd;
using sample::FitSetup;
using sample::kAxes;
using sample::middle_finger;

TEST(FitCoordinates, TwoSpecimensHaveAPopulationAndTwoDeviations) {
  FitSetup setup = middle_finger(kAxes);
  setup.experiments.push_back(sample::experiment("H02"));
  const FitProblem problem = setup.problem();
  EXPECT_EQ(problem.size(), 3 * setup.parameters.coordinates());
  EXPECT_EQ(problem.coordinates().names()[0], "axis/MCP3_FE/direction/1");
  EXPECT_EQ(problem.coordinates().names()[8], "H01: axis/MCP3_FE/direction/1");
  EXPECT_EQ(problem.coordinates().names()[16], "H02: axis/MCP3_FE/direction/1");
  VectorXd z = VectorXd::Zero(problem.size());
  z[0] = 1;
  z[16] = 2;
  EXPECT_NEAR(displacements(problem.coordinates(), z, -1)[0], 3 * kDegree, 1e-12);
  EXPECT_NEAR(displacements(problem.coordinates(), z, 0)[0], 3 * kDegree, 1e-12);
  EXPECT_NEAR(displacements(problem.coordinates(), z, 1)[0], (3 + 2 * 4) * kDegree, 1e-12);
}

// No other entry moves it, and the Jacobian says how far each does.
TEST(FitCoordinates, EntriesOfASpecimenAreAllThatMovesIt) {
  FitSetup setup = middle_finger(kAxes);
  setup.experiments.push_back(sample::experiment("H02"));
  const FitCoordinates coordinates = setup.problem().coordinates();
  const VectorXd z = VectorXd::Constant(coordinates.size(), 0.3);
  for (const int specimen : {-1, 0, 1}) {
    const Eigen::MatrixXd J = displacement_jacobian(coordinates, z, specimen);
    const std::vector<int> on = coordinates.entries_of_specimen(specimen);
    EXPECT_EQ(on.size(), specimen < 0 ? 8U : 16U);
    ASSERT_EQ(J.cols(), static_cast<Eigen::Index>(on.size()));
    for (int i = 0; i < coordinates.size(); ++i) {
      const auto at = std::find(on.begin(), on.end(), i);
      const VectorXd step = 1e-6 * VectorXd::Unit(z.size(), i);
      const VectorXd moved = displacements(coordinates, z + step, specimen) -
                             displacements(coordinates, z - step, specimen);
      if (at == on.end()) {
        EXPECT_TRUE(moved.isZero(0)) << specimen << " " << i;
        continue;
      }
      EXPECT_GT(moved.norm(), 0) << specimen << " " << i;
      EXPECT_TRUE(matrix_near(J.col(at - on.begin()), moved / 2e-6, 1e-9)) << specimen << " " << i;
    }
  }
}

TEST(FitCoordinates, NamesLoseTheirSpecimen) {
  FitSetup setup = middle_finger(kAxes);
  setup.experiments.push_back(sample::experiment("H02"));
  const std::vector<std::string> names = setup.problem().coordinates().names();
  EXPECT_EQ(without_specimen(names.front()), names.front());  // of the population
  EXPECT_EQ("H02: " + without_specimen(names.back()), names.back());
}

TEST(FitCoordinates, BoundsHoldWhereOnlySpecimensDiffer) {
  FitSetup setup = middle_finger(
      "[[parameter]]\nmatch='gain/LU'\nstate='free'\nsd=0\nbetween_sd=0.1\nrange=0.2\n");
  setup.experiments.push_back(sample::experiment("H02"));
  const FitProblem problem = setup.problem();
  ASSERT_EQ(problem.size(), 2);
  EXPECT_TRUE(matrix_near(problem.coordinates().lower(), Eigen::Vector2d(-2, -2), 1e-12));
  EXPECT_TRUE(matrix_near(problem.coordinates().upper(), Eigen::Vector2d(2, 2), 1e-12));
}

}  // namespace
}  // namespace thenar
