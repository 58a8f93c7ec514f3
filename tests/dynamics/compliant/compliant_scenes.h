#pragma once

/// Both programs of compliant contact, for tests that ask both the same.

#include <string>

#include "base/error.h"
#include "dynamics/compliant/penalty_scene.h"
#include "dynamics/compliant/simbody_scene.h"
#include "tests/dynamics/stepping/sample_scenes.h"

namespace thenar::sample {

/// One of the programs.
struct CompliantProgram {
  std::string name;
  SceneRun (*run)(const MovingScene&, const SceneOptions&, const Progress&);
};
inline const CompliantProgram kOfSimbody{"Simbody", &simulate_simbody_scene};
inline const CompliantProgram kOfSundials{"SUNDIALS", &simulate_penalty_scene};

/// A ball of 20 mm and 0.1 kg on a large fixed floor whose upper side is z = 0.
struct BallOnFloor {
  MovingScene scene;
  int ball = 0;
};
inline constexpr double kBallRadius = 0.02;  // [m]
inline BallOnFloor ball_on_floor(double height = 0) {
  BallOnFloor out;
  Pose<double> X;
  X.p.z() = -0.05;
  add_body(out.scene, "floor", primitive(ShapeKind::kBox, {4, 4, 0.1}), 0, X);
  X.p.z() = kBallRadius + height;
  out.ball =
      add_body(out.scene, "ball", primitive(ShapeKind::kSphere, {kBallRadius, 0, 0}), 0.1, X);
  return out;
}

}  // namespace thenar::sample
