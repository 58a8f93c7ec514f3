#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/units.h"
#include "geometry/primitives.h"
#include "pads/contact_area.h"
#include "pads/pad_press.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

Tissue soft_tissue(double poisson_ratio) {
  Tissue tissue;
  tissue.shear_modulus = 12e3;
  tissue.poisson_ratio = poisson_ratio;
  return tissue;
}

/// A box of tissue on a floor, refined around the middle of its top.
struct Slab {
  Slab(double size, int levels, double fine, double poisson_ratio)
      : mesh(box_mesh({size, size, size / 2}, {4, 4, 2})), top(size / 2, size / 2, size / 2) {
    for (int level = 0; level < levels; ++level) {
      std::vector<int> marked;
      for (const int index : mesh.active()) {
        const HexCell& cell = mesh.cells()[static_cast<std::size_t>(index)];
        const Vector3d low = mesh.place(cell.corners[0]), high = mesh.place(cell.corners[7]);
        const double away = (top.cwiseMax(low).cwiseMin(high) - top).norm();
        if (away < std::max(fine, 0.6 * (high - low)[0])) marked.push_back(index);
      }
      mesh.refine(marked);
    }
    std::vector<bool> floor;
    for (int node = 0; node < mesh.nodes(); ++node) {
      floor.push_back(mesh.place(node)[2] < 1e-9);
      on_top.push_back(mesh.place(node)[2] > size / 2 - 1e-9);
    }
    body = std::make_unique<TissueBody>(mesh, HexElement::kMeanDilatation,
                                        std::vector{soft_tissue(poisson_ratio)}, floor);
    surface = build_contact_surface(mesh, *body, on_top);
    factors = std::make_unique<PressFactors>(*body);
  }
  HexMesh mesh;
  Vector3d top;
  std::vector<bool> on_top;  // whether a node is (nodes)
  std::unique_ptr<TissueBody> body;
  ContactSurface surface;
  std::unique_ptr<PressFactors> factors;
};

/// A ball of 6 mm that just touches a slab of 10 mm.
struct BallOnSlab {
  BallOnSlab() {
    X.p = slab.top + Vector3d(0, 0, 6e-3);
    goal.X_PO = X;
    state = rest_state(*slab.body, slab.surface, X);
  }
  PressOutcome press(const PressOptions& options = {}) {
    return press_step(*slab.body, slab.surface, ball, goal, options, *slab.factors, state);
  }
  Slab slab{0.02, 1, 4e-3, 0.49};
  RigidObject ball{build_sphere(6e-3), 0};
  Pose<double> X;  // at the start
  PressGoal goal;
  PressState state;
};

TEST(PressStep, ABallInAThickSlabMeetsTheForceOfHertz) {
  constexpr double kSize = 0.2, kRadius = 0.01, kDepth = 1e-4, kNu = 0.49;
  const double a = std::sqrt(kRadius * kDepth);
  Slab slab(kSize, 7, 4 * a, kNu);
  const RigidObject ball{build_sphere(kRadius), 0};
  Pose<double> X;
  X.p = slab.top + Vector3d(0, 0, kRadius);
  PressState state = rest_state(*slab.body, slab.surface, X);
  PressGoal goal;
  goal.X_PO = X;
  goal.X_PO.p[2] -= kDepth;
  const PressOutcome out =
      press_step(*slab.body, slab.surface, ball, goal, {}, *slab.factors, state);
  ASSERT_EQ(out.status, Status::kSolved) << out.message;
  // Hertz; the floor adds 1 + 1.133 a / h for a stuck, incompressible layer
  // [Dimitriadis2002].
  const double E = 2 * 12e3 * (1 + kNu) / (1 - kNu * kNu);
  const double hertz = 4.0 / 3 * E * std::sqrt(kRadius) * std::pow(kDepth, 1.5);
  EXPECT_NEAR(-out.push.force[2] / hertz, 1 + 1.133 * a / (kSize / 2), 0.01);
  EXPECT_LE(out.gap, 1e-9);
  EXPECT_LT(out.push.force.head<2>().norm(), 1e-6 * hertz);
}

// a^2 = R d (1 + 2/3 1.133 a / h) on a floor: see ContactArea.OfABallIsThatOfHertz.
TEST(PressStep, ABallInAThickSlabTouchesTheCircleOfHertz) {
  constexpr double kSize = 0.2, kRadius = 0.01, kNu = 0.49;
  Slab slab(kSize, 7, 3.5e-3, kNu);
  const RigidObject ball{build_sphere(kRadius), 0};
  Pose<double> X;
  X.p = slab.top + Vector3d(0, 0, kRadius);
  PressState state = rest_state(*slab.body, slab.surface, X);
  PressGoal goal;
  for (int k = 1; k <= 12; ++k) {
    const double depth = k * 0.02e-3;
    goal.X_PO = X;
    goal.X_PO.p[2] -= depth;
    ASSERT_EQ(press_step(*slab.body, slab.surface, ball, goal, {}, *slab.factors, state).status,
              Status::kSolved);
    const double area = contact_area(slab.mesh, *slab.body, {soft_tissue(kNu)}, slab.on_top,
                                     slab.surface, ball, state);
    // Of a radius of 1.6 to 4 cells.
    if (k > 1) {
      const double floor = 2.0 / 3 * 1.133 * std::sqrt(kRadius * depth) / (kSize / 2);
      EXPECT_NEAR(area / (kPi * kRadius * depth), 1 + floor, 0.06) << depth;
    }
  }
}

TEST(PressStep, FrictionStaysInItsConeAndAgainstTheSlip) {
  Slab slab(0.02, 2, 4e-3, 0.45);
  constexpr double kFriction = 0.4;
  const RigidObject ball{build_sphere(6e-3), kFriction};
  Pose<double> X;
  X.p = slab.top + Vector3d(0, 0, 6e-3);
  PressState state = rest_state(*slab.body, slab.surface, X);
  PressGoal goal;
  goal.X_PO = X;
  // Down, then sideways until it slides.
  for (int k = 0; k < 4; ++k) {
    goal.X_PO.p[2] -= 2e-4;
    ASSERT_EQ(press_step(*slab.body, slab.surface, ball, goal, {}, *slab.factors, state).status,
              Status::kSolved);
  }
  double before = 0;
  for (int k = 0; k < 12; ++k) {
    goal.X_PO.p[0] += 1e-4;
    const PressOutcome out =
        press_step(*slab.body, slab.surface, ball, goal, {}, *slab.factors, state);
    ASSERT_EQ(out.status, Status::kSolved) << k << out.message;
    for (Eigen::Index i = 0; i < state.normal_force.size(); ++i)
      EXPECT_LE(state.friction_force.col(i).norm(),
                kFriction * state.normal_force[i] * (1 + 1e-12));
    before = out.push.force[0];
  }
  // All slides: the shear on each node is at its bound and along the motion.
  double bound = 0, shear = 0;
  for (Eigen::Index i = 0; i < state.normal_force.size(); ++i) {
    bound += kFriction * state.normal_force[i];
    shear += state.friction_force.col(i).norm();
  }
  EXPECT_NEAR(shear / bound, 1, 1e-6);
  EXPECT_GT(before, 0);
}

TEST(PressStep, OneLargeStepIsTenSmallOnesWithoutFriction) {
  const auto pressed = [](int steps) {
    BallOnSlab on;
    PressOutcome out;
    for (int k = 0; k < steps; ++k) {
      on.goal.X_PO.p[2] -= 1e-3 / steps;
      out = on.press();
      EXPECT_EQ(out.status, Status::kSolved);
    }
    return out.push.force[2];
  };
  EXPECT_NEAR(pressed(1) / pressed(10), 1, 1e-6);
}

TEST(PressStep, ForceAsTheGoalIsTheForceAtThatDepth) {
  BallOnSlab on;
  on.goal.X_PO.p[2] -= 5e-4;
  (void)on.press();
  on.goal.force = 0.2;
  const PressOutcome out = on.press();
  ASSERT_EQ(out.status, Status::kSolved) << out.message;
  EXPECT_NEAR(-out.push.force[2], 0.2, 1e-8);
  // The same by depth.
  BallOnSlab again;
  again.goal.X_PO = on.state.X_PO;
  const PressOutcome twin = again.press();
  EXPECT_NEAR(-twin.push.force[2], 0.2, 1e-7);
}

TEST(PressStep, AFailedStepLeavesTheStateAsItWas) {
  BallOnSlab on;
  on.goal.X_PO.p[2] -= 0.02;  // through the floor
  const PressOutcome out = on.press();
  EXPECT_NE(out.status, Status::kSolved);
  EXPECT_FALSE(out.message.empty());
  EXPECT_TRUE(on.state.x.isZero(0));
}

TEST(PressStep, AStepStopsWithinAnIteration) {
  BallOnSlab on;
  on.goal.X_PO.p[2] -= 5e-4;
  int asked = 0;
  PressOptions options;
  options.stop = [&] { return ++asked == 3; };
  const PressOutcome out = on.press(options);
  EXPECT_EQ(out.status, Status::kStopped);
  EXPECT_EQ(out.iterations, 2);
  EXPECT_EQ(asked, 3);
  EXPECT_TRUE(on.state.x.isZero(0));
  EXPECT_TRUE(on.state.X_PO.p == on.X.p);
}

TEST(PadShape, ItsMeshHasTheVolumeBetweenTheEllipsoids) {
  PadShape shape;
  const double exact = kPi / 6 *
                       (shape.length * shape.width * shape.height -
                        shape.bone_length * shape.bone_width * shape.bone_height);
  const auto missing = [&](int finer) {
    const HexMesh mesh = pad_mesh(shape, {2 * finer, finer, finer});
    std::vector<bool> held = held_by_bone(mesh);
    double sum = 0;
    for (const int index : mesh.active()) {
      Eigen::Matrix3Xd X(3, 8);
      for (int c = 0; c < 8; ++c)
        X.col(c) = mesh.place(
            mesh.cells()[static_cast<std::size_t>(index)].corners[static_cast<std::size_t>(c)]);
      for (const double w : element_shape(HexElement::kMeanDilatation, X).volume) sum += w;
    }
    return exact - sum;
  };
  // Chords of the skin miss a part that falls with the square of the cells.
  EXPECT_LT(missing(4), 0.02 * exact);
  EXPECT_NEAR(missing(2) / missing(4), 4, 0.5);
}

TEST(PadShape, LayersHaveTheirThicknessEverywhere) {
  PadShape shape;
  shape.layers = {{0.4e-3}, {1.1e-3}};
  const PadChart chart(shape);
  for (const auto& [a, b] : {std::pair(0.0, 0.0), std::pair(0.5, -0.3), std::pair(0.0, 0.9)}) {
    EXPECT_NEAR((chart.place({a, b, 1}) - chart.place({a, b, 0.75})).norm(), 0.4e-3, 1e-15);
    EXPECT_NEAR((chart.place({a, b, 0.75}) - chart.place({a, b, 0.5})).norm(), 1.1e-3, 1e-15);
  }
  const HexMesh mesh = pad_mesh(shape, {});
  int most = 0;
  for (const HexCell& cell : mesh.cells()) most = std::max(most, cell.region);
  EXPECT_EQ(most, 2);
}

TEST(PadShape, ASkinOfItsOwnIsFollowed) {
  PadShape shape;
  shape.skin = build_sphere(11e-3);
  const PadChart chart(shape);
  for (const auto& [a, b] : {std::pair(0.0, 0.0), std::pair(0.5, -0.3), std::pair(0.0, 0.9)})
    EXPECT_NEAR(chart.place({a, b, 1}).norm(), 11e-3, 2e-9);
  shape.skin = build_sphere(5e-3);  // the bone sticks out
  EXPECT_THROW(PadChart{shape}, InputError);
}

TEST(PadShape, NonsenseIsRefused) {
  PadShape shape;
  shape.bone_height = shape.height;
  EXPECT_THROW(PadChart{shape}, InputError);
  shape = {};
  shape.width = NAN;
  EXPECT_THROW(PadChart{shape}, InputError);
  shape = {};
  shape.layers = {{6e-3}};
  EXPECT_THROW(PadChart{shape}, InputError);
}

/// A pad pressed onto a wall.
PadPressResult pressed(double depth, double error, double poisson_ratio, int steps) {
  PadModel model;
  model.tissues = {soft_tissue(poisson_ratio)};
  PadPressOptions options;
  options.force_error = error;
  Pose<double> X;
  X.p = {0, 0, model.shape.height + 0.051};
  PadPress press(model, {build_box({0.1, 0.1, 0.1}), 0}, X, options);
  EXPECT_NEAR(press.touch({0, 0, -1}), 1e-3, 1e-9);
  PressGoal goal;
  goal.X_PO = press.state().X_PO;
  PadPressResult result;
  for (int k = 0; k < steps; ++k) {
    goal.X_PO.p[2] -= depth / steps;
    result = press.step(goal);
  }
  return result;
}

TEST(PadPress, RefinesUntilTheForceIsAsGoodAsAsked) {
  const PadPressResult rough = pressed(1.5e-3, 0.2, 0.49, 1), fine = pressed(1.5e-3, 0.03, 0.49, 1);
  ASSERT_EQ(rough.solved.status, Status::kSolved);
  ASSERT_EQ(fine.solved.status, Status::kSolved);
  EXPECT_LE(fine.force_error, 0.03);
  EXPECT_LE(fine.penetration, 1e-6);
  EXPECT_GT(fine.elements, rough.elements);
  EXPECT_NEAR(rough.push.force[2] / fine.push.force[2], 1, 0.2);
}

TEST(PadPress, ErrorsAreNoLargerThanAsked) {
  // Also with few cells: gaps are means over the curved skin, those of its nodes would give two
  // thirds of the force.
  for (const double depth : {0.75e-3, 1.5e-3}) {
    const PadPressResult fine = pressed(depth, 0.05, 0.49, 1);
    ASSERT_EQ(fine.solved.status, Status::kSolved);
    for (const double error : {0.3, 0.15}) {
      const PadPressResult rough = pressed(depth, error, 0.49, 1);
      EXPECT_LT(rough.elements, 400U);
      EXPECT_NEAR(rough.push.force[2] / fine.push.force[2], 1, error) << depth;
    }
  }
}

TEST(PadPress, ABallPressesWithTheSlopeOfTheEnergy) {
  // Without friction the work of the push is all energy of the tissue, whatever the mesh; with
  // friction a coarse mesh is solved, too.
  for (const double friction : {0.0, 0.7}) {
    PadModel model;
    model.tissues = {soft_tissue(0.49)};
    PadPressOptions options;
    options.force_error = 1;
    options.max_penetration = 1;
    constexpr double kRadius = 4e-3, kStep = 1e-6;
    Pose<double> X;
    X.p = {0, 0, model.shape.height + 1e-3 + kRadius};
    PadPress press(model, {build_sphere(kRadius), friction}, X, options);
    (void)press.touch({0, 0, -1});
    const auto energy = [&] {
      TissueResponse now;
      const Eigen::Matrix3Xd u = press.body().node_displacements(press.state().x, {});
      press.body().evaluate(u, 0, {}, {}, ElementRequest::kEnergy, now);
      return now.energy;
    };
    PressGoal goal;
    goal.X_PO = press.state().X_PO;
    goal.X_PO.p[2] -= 1e-3;
    const PadPressResult first = press.step(goal);
    ASSERT_EQ(first.solved.status, Status::kSolved) << first.solved.message;
    EXPECT_EQ(first.elements, 144U);
    if (friction > 0) continue;
    const double before = energy();
    goal.X_PO.p[2] -= kStep;
    const PadPressResult second = press.step(goal);
    ASSERT_EQ(second.solved.status, Status::kSolved) << second.solved.message;
    const double push = -0.5 * (first.push.force[2] + second.push.force[2]);
    EXPECT_NEAR((energy() - before) / kStep / push, 1, 1e-5);
  }
}

TEST(PadPress, SticksAndSlipsWithoutEnd) {
  // From sticking to sliding: nodes took turns for ever where the force of a node that left its
  // cone was turned along what little it had slipped.
  for (const double friction : {0.3, 0.9}) {
    PadModel model;
    model.tissues = {soft_tissue(0.49)};
    PadPressOptions options;
    options.force_error = 0.2;
    Pose<double> X;
    X.p = {0, 0, model.shape.height + 0.051};
    PadPress press(model, {build_box({0.1, 0.1, 0.1}), friction}, X, options);
    (void)press.touch({0, 0, -1});
    PressGoal goal;
    goal.X_PO = press.state().X_PO;
    goal.X_PO.p[2] -= 1e-3;
    PadPressResult result = press.step(goal);
    ASSERT_EQ(result.solved.status, Status::kSolved) << result.solved.message;
    press.set_force_error(1);
    double shear = 0;
    for (int k = 0; k < 6; ++k) {
      goal.X_PO.p[0] += 7e-4;
      result = press.step(goal);
      ASSERT_EQ(result.solved.status, Status::kSolved) << friction << ", " << k;
      EXPECT_LT(result.solved.iterations, 40);
      EXPECT_GE(result.push.force[0], shear * (1 - 1e-3));
      shear = result.push.force[0];
    }
    EXPECT_NEAR(shear / -result.push.force[2], friction, 0.02 * friction);
  }
}

TEST(PadPress, ForceRisesFasterThanDepth) {
  const double f1 = -pressed(1e-3, 0.2, 0.49, 1).push.force[2];
  const double f2 = -pressed(2e-3, 0.2, 0.49, 1).push.force[2];
  EXPECT_GT(f2, 2.83 * f1);  // Hertz: 2^1.5
}

TEST(PadPress, RelaxesOnAMeshThatRefines) {
  // Pressed in a short time and held for half of the relaxation time; refined while held, or from
  // the beginning.
  const auto held = [](double first_error, std::size_t& elements) {
    PadModel model;
    model.tissues = {soft_tissue(0.49)};
    model.tissues[0].relaxation = {{0.5, 0.1}};
    Pose<double> X;
    X.p = {0, 0, model.shape.height + 0.051};
    PadPressOptions options;
    options.force_error = first_error;
    PadPress press(model, {build_box({0.1, 0.1, 0.1}), 0}, X, options);
    (void)press.touch({0, 0, -1});
    PressGoal goal;
    goal.X_PO = press.state().X_PO;
    goal.X_PO.p[2] -= 1e-3;
    goal.time = 1e-6;
    PadPressResult result = press.step(goal);
    EXPECT_EQ(result.solved.status, Status::kSolved);
    elements = result.elements;
    goal.time = 0.05;
    press.set_force_error(0.1);
    result = press.step(goal);
    EXPECT_EQ(result.solved.status, Status::kSolved) << result.solved.message;
    EXPECT_LE(result.force_error, 0.1);
    return -result.push.force[2];
  };
  std::size_t coarse = 0, fine = 0;
  const double refined = held(1, coarse), fine_before = held(0.1, fine);
  EXPECT_GT(fine, coarse);
  // Without its past it would be 1.25 times as large: (0.75 + 0.25) against 0.5 + 0.5 exp(-0.5).
  EXPECT_NEAR(refined / fine_before, 1, 0.06);
}

TEST(PadPress, AForceIsReachedFromTheTouch) {
  PadModel model;
  model.tissues = {soft_tissue(0.49)};
  PadPressOptions options;
  options.force_error = 1;
  Pose<double> X;
  X.p = {0, 0, model.shape.height + 0.051};
  PadPress press(model, {build_box({0.1, 0.1, 0.1}), 0}, X, options);
  (void)press.touch({0, 0, -1});
  PressGoal goal;
  goal.X_PO = press.state().X_PO;
  goal.X_PO.p[2] -= 2e-5;
  ASSERT_EQ(press.step(goal).solved.status, Status::kSolved);
  EXPECT_THROW((void)press.touch({0, 0, -1}), InputError);
  goal.force = 0.5;
  const PadPressResult result = press.step(goal);
  ASSERT_EQ(result.solved.status, Status::kSolved) << result.solved.message;
  EXPECT_NEAR(-result.push.force[2], 0.5, 1e-7);
}

TEST(PadPress, AnyForceIsFoundAndMoreForceIsDeeper) {
  // On coarse meshes a pad feels an object before it touches: small forces are found before.
  const auto along = [](double angle) { return Vector3d(-std::sin(angle), 0, -std::cos(angle)); };
  for (const PadCells& cells : {PadCells{2, 1, 2}, PadCells{3, 2, 2}, PadCells{4, 2, 3}})
    for (const double angle : {0.0, 0.5})
      for (const double friction : {0.0, 0.6}) {
        PadModel model;
        model.tissues = {soft_tissue(0.49)};
        model.cells = cells;
        PadPressOptions options;
        options.force_error = 1e3;
        double deep = -1;
        for (const double force : {1e-4, 1e-3, 1e-2, 0.1, 1.0}) {
          Pose<double> X;
          X.R = rotation_about<double>({0, 1, 0}, angle);
          X.p = -0.08 * along(angle);
          PadPress press(model, {build_box({0.1, 0.1, 0.1}), friction}, X, options);
          (void)press.touch(along(angle));
          PressGoal goal;
          goal.X_PO = press.state().X_PO;
          goal.along = along(angle);
          goal.force = force;
          const PadPressResult result = press.step(goal);
          ASSERT_EQ(result.solved.status, Status::kSolved)
              << cells.across << ' ' << angle << ' ' << force << ' ' << result.solved.message;
          EXPECT_NEAR(goal.along.dot(result.push.force), force, 2e-9);
          const double depth = goal.along.dot(press.state().X_PO.p - goal.X_PO.p);
          EXPECT_GT(depth, deep);
          deep = depth;
        }
      }
}

TEST(PadPress, AForceThatIsOutOfReachSaysHowFarItCame) {
  PadModel model;
  model.tissues = {soft_tissue(0.49)};
  PadPressOptions options;
  options.force_error = 1e3;
  options.max_penetration = 1;
  Pose<double> X;
  X.p = {0, 0, model.shape.height + 2e-3};
  PadPress press(model, {build_sphere(1e-3), 0}, X, options);
  (void)press.touch({0, 0, -1});
  const double touched = press.state().X_PO.p[2];
  PressGoal goal;
  goal.X_PO = press.state().X_PO;
  goal.force = 100;  // it goes into the tissue between nodes, and through the bone
  const PadPressResult result = press.step(goal);
  EXPECT_NE(result.solved.status, Status::kSolved);
  EXPECT_EQ(result.solved.message.rfind("no solution beyond ", 0), 0U) << result.solved.message;
  EXPECT_EQ(press.state().X_PO.p[2], touched);
  EXPECT_TRUE(press.state().x.isZero(0));
}

TEST(PadPress, NonsenseIsRefused) {
  PadModel model;
  model.tissues = {soft_tissue(0.49)};
  Pose<double> X;
  X.p = {0, 0, model.shape.height + 0.051};
  PadPress press(model, {build_box({0.1, 0.1, 0.1}), 0}, X, {});
  PressGoal goal;
  goal.X_PO = X;
  goal.X_PO.p[2] = NAN;
  EXPECT_THROW((void)press.step(goal), InputError);
  goal.X_PO = X;
  goal.time = -1;
  EXPECT_THROW((void)press.step(goal), InputError);
  goal.time = 0;
  goal.force = 0.2;
  goal.along = {0, 0, -2};
  EXPECT_THROW((void)press.step(goal), InputError);
  EXPECT_THROW((void)press.touch({0, 0, 2}), InputError);
}

TEST(PadPress, LiftsOffAtAnyPoissonRatio) {
  PadModel model;
  model.tissues = {soft_tissue(0.49999)};
  PadPressOptions options;
  options.force_error = 1;
  Pose<double> X;
  X.p = {0, 0, model.shape.height + 0.051};
  PadPress press(model, {build_box({0.1, 0.1, 0.1}), 0}, X, options);
  (void)press.touch({0, 0, -1});
  PressGoal goal;
  goal.X_PO = press.state().X_PO;
  goal.X_PO.p[2] -= 1e-3;
  ASSERT_EQ(press.step(goal).solved.status, Status::kSolved);
  goal.X_PO.p[2] += 2e-3;
  const PadPressResult result = press.step(goal);
  EXPECT_EQ(result.solved.status, Status::kSolved) << result.solved.message;
  EXPECT_EQ(result.push.force.norm(), 0);
  EXPECT_LT(press.state().x.lpNorm<Eigen::Infinity>(), 1e-9);
}

TEST(PadPress, ATurnStrainsNoRefinedPad) {
  HexMesh mesh = pad_mesh({}, {});
  mesh.refine({3, 20, 50});
  const TissueBody body(mesh, HexElement::kMeanDilatation, {soft_tissue(0.49)},
                        std::vector<bool>(static_cast<std::size_t>(mesh.nodes()), false));
  const Eigen::Matrix3d R = rotation_about<double>({0, 0.6, 0.8}, 0.3);
  Eigen::Matrix3Xd u(3, mesh.nodes());
  for (int node = 0; node < mesh.nodes(); ++node)
    u.col(node) = R * mesh.place(node) - mesh.place(node);
  TissueResponse at;
  body.evaluate(u, 0, {}, {}, ElementRequest::kForce, at);
  EXPECT_LT(at.energy, 1e-15);
  EXPECT_LT(at.force.norm(), 1e-12);
  // All that lies on the rim is held, on curved edges and faces, too.
  mesh.refine(std::vector<int>(mesh.active()));
  const std::vector<bool> held = held_by_bone(mesh);
  for (int node = 0; node < mesh.nodes(); ++node)
    if (mesh.in_use(node) && mesh.masters(node).empty() && std::abs(mesh.place(node)[2]) < 1e-9) {
      EXPECT_TRUE(held[static_cast<std::size_t>(node)]);
    }
}

TEST(PadPress, HalfOfTheThicknessIsReached) {
  const PadPressResult result = pressed(2.75e-3, 1, 0.49, 1);
  EXPECT_EQ(result.solved.status, Status::kSolved) << result.solved.message;
}

}  // namespace
}  // namespace thenar
