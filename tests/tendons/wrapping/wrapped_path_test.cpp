// Tests for tendons/wrapping/wrapped_path.cpp: what becomes of a subject's strands.

#include "tendons/wrapping/wrapped_path.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/matrix_near.h"
#include "tests/tendons/wrapping/path_wrenches.h"
#include "tests/tendons/wrapping/wrap_samples.h"

namespace thenar {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

Subject hand() { return read_subject(THENAR_DATA_DIR "/subjects/mirakhorlo2016.toml"); }

/// Moment arms of all paths at one posture.
Eigen::MatrixXd arms_of(const Skeleton& skeleton, const PathSet& set, const VectorXd& q) {
  const TreeState<double> state = pose_tree(skeleton.tree, q);
  PathSolver solver(set);
  Eigen::MatrixXd R(set.paths.size(), q.size());
  path_arms(skeleton.tree, state, set, solver.solve(state), R);
  return R;
}

TEST(WrappedPath, NamesThePointInsideASurface) {
  Subject subject = hand();
  subject.surfaces[5].size[0] = 0.0145;  // MCP3_head, with EDC3 13.40 mm from its axis
  ASSERT_EQ(subject.surfaces[5].name, "MCP3_head");
  try {
    (void)build_paths(subject, build_skeleton(subject));
    FAIL() << "expected InputError";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "point 5 of strand 'EDC3' lies 1.1 mm inside surface 'MCP3_head'");
  }
}

// A knuckle that bent by 172 degrees would take the extensor's next point round the far side.
TEST(WrappedPath, RefusesRangesThatTakeAPointRoundTheFarSide) {
  Subject subject = hand();
  for (JointAxis& joint : subject.joints)
    if (joint.name == "MCP3_FE") joint.upper = 3;
  try {
    (void)build_paths(subject, build_skeleton(subject));
    FAIL() << "expected InputError";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("goes round the far side of surface 'MCP3_head'"),
              std::string::npos)
        << error.what();
  }
}

TEST(WrappedPath, RefusesAnOriginOffItsCarrier) {
  Subject subject = hand();
  for (Strand& strand : subject.strands)
    if (strand.name == "LU1") strand.path.back().p.z() += 0.01;
  EXPECT_THROW((void)build_paths(subject, build_skeleton(subject)), InputError);
}

TEST(WrappedPath, BringsTheCarrierOfARiderAlong) {
  const Subject subject = hand();
  const PathSet set = build_paths(subject, build_skeleton(subject), {"LU1"});
  ASSERT_EQ(set.paths.size(), 2U);
  EXPECT_EQ(set.paths[1].carrier, 0);
  EXPECT_EQ(set.paths[0].name, "FDP2");
}

// From digitised points: FDP2 from its insertion to the lumbrical's origin, through five points.
TEST(WrappedPath, MeasuresWhereTheRiderSits) {
  const Subject subject = hand();
  const PathSet set = build_paths(subject, build_skeleton(subject), {"LU1"});
  const std::vector<PathPoint>& flexor =
      std::find_if(subject.strands.begin(), subject.strands.end(), [](const Strand& strand) {
        return strand.name == "FDP2";
      })->path;
  double way = 0;
  for (std::size_t k = 0; k < 6; ++k) way += (flexor[k + 1].p - flexor[k].p).norm();
  EXPECT_NEAR(set.paths[1].ride, way, 1e-15);
}

// A ladder: as the cylinders shrink to their axes, the strings that never meet them are straight.
TEST(WrappedPath, BecomesTheViaPointsAsRadiiVanish) {
  Subject subject = hand();
  for (Strand& strand : subject.strands)
    if (!strand.path.empty()) strand.path.back().rides_on.clear();
  const Skeleton skeleton = build_skeleton(subject);
  const VectorXd q = VectorXd::Constant(skeleton.coordinates(), 0.05);
  Subject bare = subject;
  for (Strand& strand : bare.strands)
    strand.path.erase(std::remove_if(strand.path.begin(), strand.path.end(),
                                     [](const PathPoint& p) { return !p.surface.empty(); }),
                      strand.path.end());
  const Eigen::MatrixXd straight = arms_of(skeleton, build_paths(bare, skeleton), q);
  double last = 1;
  for (const double factor : {1.0, 0.5, 1e-3}) {
    Subject shrunk = subject;
    for (Surface& surface : shrunk.surfaces) surface.size *= factor;
    const Eigen::MatrixXd wrapped = arms_of(skeleton, build_paths(shrunk, skeleton), q);
    const double apart = (wrapped - straight).cwiseAbs().maxCoeff();
    EXPECT_LE(apart, last);
    last = apart;
  }
  EXPECT_EQ(last, 0);
}

// Every tendon of a whole hand, wrist included, by virtual work, by contact forces and by lengths.
TEST(WrappedPath, OfAWholeHandAgreesWithItsForcesAndItsLengths) {
  const Subject subject = hand();
  const Skeleton skeleton = build_skeleton(subject);
  const PathSet set = build_paths(subject, skeleton);
  const VectorXd q = VectorXd::Constant(skeleton.coordinates(), 0.21);
  const TreeState<double> state = pose_tree(skeleton.tree, q);
  PathSolver solver(set);
  const auto& shapes = solver.solve(state);
  const Eigen::MatrixXd R = arms_of(skeleton, set, q);
  for (std::size_t k = 0; k < set.paths.size(); ++k) {
    ASSERT_EQ(shapes[k].status, PathStatus::kTaut) << set.paths[k].name;
    const VectorXd row = R.row(static_cast<Eigen::Index>(k)).transpose();
    EXPECT_TRUE(
        matrix_near(row,
                    joint_torque(skeleton.tree, state, sample::path_wrenches(state, set, shapes, k),
                                 skeleton.coordinates()),
                    1e-14))
        << set.paths[k].name;
    // Fourth-order differences over 1e-3 rad.
    EXPECT_TRUE(
        matrix_near(row.transpose(), sample::measured_arms(skeleton.tree, set, q, k), 1e-10))
        << set.paths[k].name;
  }
}

}  // namespace
}  // namespace thenar
