// Tests for dynamics/mechanism: recursions and Simbody give the same accelerations, on random
// trees, on every robot in data/ and on every human hand there.

#include <filesystem>

#include <gtest/gtest.h>

#include "base/error.h"
#include "dynamics/mechanism/articulated_body.h"
#include "dynamics/mechanism/build_mechanism.h"
#include "dynamics/mechanism/composite_body.h"
#include "dynamics/mechanism/simbody_machine.h"
#include "tests/dynamics/mechanism/sample_mechanisms.h"

namespace thenar {
namespace {

const Eigen::Vector3d kFall(1, -2, -9.81);

/// Largest difference relative to the largest entry.
double difference(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return (a - b).cwiseAbs().maxCoeff() / std::max(1e-30, b.cwiseAbs().maxCoeff());
}

/// Both machines in one random state.
void expect_same(const Mechanism& mechanism, sample::MechanismDraw& draw, double size) {
  const TreeModel model = tree_model(mechanism);
  const int n = model.layout.v;
  SimbodyMachine other(mechanism);
  const Eigen::VectorXd q = draw.position(mechanism, size), v = draw.numbers(n, 3);
  const Eigen::VectorXd tau = draw.numbers(n, 0.3);
  TreeMotion<double> motion(model);
  motion.set_position(q);
  motion.set_speed(v);
  motion.clear_loads();
  other.set_state(q, v);
  // A force and a moment on every body.
  std::vector<BodyLoad> loads;
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
    const int body = static_cast<int>(i);
    const Pose<double> X = motion.pose(body), X_other = other.pose(body);
    EXPECT_LT((X.R - X_other.R).norm() + (X.p - X_other.p).norm(), 1e-12)
        << mechanism.bodies[i].name;
    loads.push_back({body, draw.vector(0.2), draw.vector(1), draw.vector(0.05)});
    motion.add_load(model.bodies[i].link, loads.back().p, loads.back().force, loads.back().moment);
  }
  const double energy = other.kinetic_energy();
  EXPECT_NEAR(motion.kinetic_energy(), energy, 1e-11 * energy);

  // Mass matrix, and accelerations by it.
  MassMatrix<double> mass(model);
  ASSERT_TRUE(mass.compute(motion));
  const Eigen::MatrixXd M = Eigen::MatrixXd::NullaryExpr(n, n, [&](Eigen::Index i, Eigen::Index j) {
    return mass(static_cast<int>(i), static_cast<int>(j));
  });
  EXPECT_LT(difference(M, other.mass_matrix()), 1e-11);
  const Eigen::VectorXd wanted = other.accelerations(tau, kFall, loads);
  InverseDynamics<double> inverse(model);
  Eigen::VectorXd needed(n);
  inverse.efforts(motion, kFall, Eigen::VectorXd::Zero(n), needed);
  Eigen::VectorXd v_dot = tau - needed;
  mass.solve(model, v_dot);
  EXPECT_LT(difference(v_dot, wanted), 1e-9);
  Eigen::VectorXd back(n);
  inverse.efforts(motion, kFall, v_dot, back);
  EXPECT_LT((back - tau).norm(), 1e-9 * (1 + needed.norm()));

  // And by articulated bodies.
  if (model.has_couplings) return;
  ArticulatedBody<double> articulated(model);
  articulated.accelerations(motion, kFall, tau, v_dot);
  EXPECT_LT(difference(v_dot, wanted), 1e-9);
}

TEST(TwoMachines, AgreeOnRandomTrees) {
  sample::MechanismDraw draw(1);
  for (int trial = 0; trial < 200; ++trial) {
    Mechanism mechanism = draw.mechanism(draw.whole(1, 12), false);
    if (layout_of(mechanism).v == 0) continue;
    expect_same(mechanism, draw, 1);
  }
}

TEST(TwoMachines, AgreeWhereJointsShareCoordinates) {
  sample::MechanismDraw draw(2);
  for (int trial = 0; trial < 100; ++trial) {
    Mechanism mechanism = draw.mechanism(draw.whole(2, 12), true);
    if (layout_of(mechanism).v == 0) continue;
    SCOPED_TRACE(trial);
    expect_same(mechanism, draw, 0.5);
  }
}

TEST(TwoMachines, AgreeOnEveryRobot) {
  sample::MechanismDraw draw(3);
  int robots = 0;
  for (const auto& entry : std::filesystem::directory_iterator(THENAR_DATA_DIR "/robots")) {
    if (entry.path().extension() != ".toml") continue;
    SCOPED_TRACE(entry.path().filename().string());
    const Mechanism mechanism = robot_mechanism(read_robot(entry.path())).mechanism;
    for (int trial = 0; trial < 3; ++trial) expect_same(mechanism, draw, 0.5);
    ++robots;
  }
  EXPECT_GE(robots, 16);
}

TEST(TwoMachines, AgreeOnEverySubjectWithMasses) {
  sample::MechanismDraw draw(4);
  int hands = 0;
  for (const auto& entry : std::filesystem::directory_iterator(THENAR_DATA_DIR "/subjects")) {
    if (entry.path().extension() != ".toml") continue;
    SCOPED_TRACE(entry.path().filename().string());
    try {
      const Mechanism mechanism = skeleton_mechanism(build_skeleton(read_subject(entry.path())));
      if (mechanism.bodies.empty()) continue;  // arms alone
      for (int trial = 0; trial < 3; ++trial) expect_same(mechanism, draw, 0.5);
      ++hands;
    } catch (const InputError& e) {
      // Some subjects state no masses, or no sizes of segments.
      const std::string what = e.what();
      EXPECT_TRUE(what.find("moves nothing that has mass") != what.npos ||
                  what.find("neither moments of inertia nor a radius") != what.npos)
          << what;
    }
  }
  EXPECT_GE(hands, 4);
}

// A robot that holds nothing on a human's wrist, with a free ball: one tree of all.
TEST(TwoMachines, AgreeOnASceneOfSeveralParts) {
  sample::MechanismDraw draw(5);
  Mechanism scene;
  append(scene, skeleton_mechanism(
                    build_skeleton(read_subject(THENAR_DATA_DIR "/subjects/human_hand.toml"))));
  append(scene, robot_mechanism(read_robot(THENAR_DATA_DIR "/robots/barrett.toml")).mechanism,
         "robot/", 3, draw.frame(0.1));
  PlacedBody ball;
  ball.body = read_object(THENAR_DATA_DIR "/objects/sphere_70.toml");
  append(scene, body_mechanism(ball), "ball/");
  for (int trial = 0; trial < 5; ++trial) expect_same(scene, draw, 0.5);
}

}  // namespace
}  // namespace thenar
