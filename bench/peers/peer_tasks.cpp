#include "bench/peers/peer_tasks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include "base/units.h"
#include "dynamics/stepping/simulate_scene.h"
#include "tests/dynamics/stepping/sample_hands.h"
#include "tests/dynamics/stepping/sample_scenes.h"

namespace thenar::bench {
namespace {

using Eigen::Vector3d;
using sample::primitive;

constexpr double kG = 9.81;        // [m/s^2]
constexpr double kEdge = 0.05;     // of cubes [m]
constexpr double kArm = 0.0054;    // of the swinging pinch [m]
constexpr double kPressed = 1e-9;  // overlap in which some engines start [m]

const std::vector<double> kSteps{1e-4, 1e-3, 5e-3, 1e-2, 2e-2};
const std::vector<double> kCoarseSteps{1e-3, 5e-3, 1e-2, 2e-2};
const std::vector<double> kTolerances{1e-4, 1e-5, 1e-6, 1e-9, 1e-12};

/// A cube between two balls on slides along x, which press on it.
struct Pinch {
  MovingScene scene;
  int cube = 0;
  double mass = 0.1;  // of the cube [kg]
};
Pinch pinch(double force, double above, double finger_mass, double cube_mass) {
  Pinch out;
  out.mass = cube_mass;
  for (const double side : {-1.0, 1.0}) {
    ShapeSpec ball = primitive(ShapeKind::kSphere, {0.01, 0, 0});
    ball.X_BS.p = {side * (0.5 * kEdge + 0.01), 0, above};
    const int finger = sample::add_on_joint(out.scene, side < 0 ? "left" : "right", ball,
                                            finger_mass, JointKind::kSlide, {1, 0, 0}, {0, 0, 0});
    out.scene.drives.push_back(
        {out.scene.mechanism.joints[static_cast<std::size_t>(finger)].coordinate, -side * force});
  }
  out.cube = sample::add_body(out.scene, "cube", primitive(ShapeKind::kBox, {kEdge, kEdge, kEdge}),
                              cube_mass);
  out.scene.friction.coefficient = 0.8;
  return out;
}

/// Where the centre of mass of a body is.
Vector3d centre(const MovingScene& scene, int body, const PeerSample& sample) {
  const auto i = static_cast<std::size_t>(body);
  return sample.bodies[i].X_WB * scene.mechanism.bodies[i].mass.com;
}

/// How far a body's centre has gone since the start [mm]. @param along  which ways count (3)
std::function<double(const PeerRun&)> moved_mm(const MovingScene& scene, int body,
                                               const Vector3d& along) {
  return [=](const PeerRun& run) {
    const Vector3d way =
        centre(scene, body, run.samples.back()) - centre(scene, body, run.samples.front());
    return way.cwiseProduct(along).norm() / kMm;
  };
}

/// The same since a later instant [mm].
std::function<double(const PeerRun&)> crept_mm(const MovingScene& scene, int body,
                                               const Vector3d& along, double since) {
  return [=](const PeerRun& run) {
    const auto settled =
        std::find_if(run.samples.begin(), run.samples.end(),
                     [&](const PeerSample& sample) { return sample.t > since - 1e-9; });
    if (settled == run.samples.end()) return std::nan("");
    const Vector3d way = centre(scene, body, run.samples.back()) - centre(scene, body, *settled);
    return way.cwiseProduct(along).norm() / kMm;
  };
}

/// A start with fingers on slides moved the way that they are driven.
Eigen::VectorXd pressed(const MovingScene& scene) {
  const MechanismLayout layout = layout_of(scene.mechanism);
  Eigen::VectorXd q = scene.q;
  for (const SceneDrive& drive : scene.drives)
    q[layout.coordinate_q[static_cast<std::size_t>(drive.coordinate)]] +=
        std::copysign(kPressed, drive.bias);
  return q;
}

std::function<bool(const PeerRun&)> above(const std::function<double(const PeerRun&)>& error,
                                          double limit) {
  return [=](const PeerRun& run) { return !(error(run) <= limit); };
}

PeerTask hold(const std::string& name, const std::string& about, const MovingScene& scene,
              int object, double seconds) {
  PeerTask task;
  task.peer = {name, scene, seconds, 0.1};
  task.about = about;
  task.peer.q_pressed = pressed(scene);
  task.error = {"slip [mm]", moved_mm(scene, object, {0, 1, 1})};
  task.further.push_back({"in the second half", crept_mm(scene, object, {0, 1, 1}, 0.5 * seconds)});
  task.lost = above(moved_mm(scene, object, {1, 1, 1}), kLostAt);
  task.steps = kSteps;
  task.tolerances = kTolerances;
  return task;
}

PeerTask pinch_hold() {
  const Pinch world = pinch(2, 0, 0.02, 0.1);
  return hold("pinch", "Two balls press with 2 N on a cube of 0.1 kg, friction 0.8, 10 s: it stays",
              world.scene, world.cube, 10);
}

PeerTask light_fingers() {
  const Pinch world = pinch(2, 0, 1e-4, 0.1);
  PeerTask task = hold("light fingers", "The same with fingers of 0.1 g, 1 s: the cube stays",
                       world.scene, world.cube, 1);
  return task;
}

PeerTask heavy_cube() {
  const Pinch world = pinch(80, 0, 5e-3, 5);
  return hold("heavy cube", "Fingers of 5 g press with 80 N on a cube of 5 kg, 1 s: it stays",
              world.scene, world.cube, 1);
}

/// Energy of one body [J].
double energy(const MovingScene& scene, int body, const PeerSample& sample) {
  const auto i = static_cast<std::size_t>(body);
  const BodyMass& mass = scene.mechanism.bodies[i].mass;
  const BodyMotion& at = sample.bodies[i];
  const Vector3d w = at.X_WB.R.transpose() * at.angular;
  return 0.5 * mass.mass * at.linear.squaredNorm() + 0.5 * w.dot(mass.inertia * w) -
         mass.mass * scene.gravity.dot(centre(scene, body, sample));
}

/// Angle of a compound pendulum on the arm of the pinch that starts at its lowest point [rad].
double pendulum_angle(double seconds, double rate, const BodyMass& mass) {
  const double stiffness = mass.mass * kG * kArm / (mass.inertia(0, 0) + mass.mass * kArm * kArm);
  // Runge and Kutta's steps, so short that their error is rounding.
  const long steps = std::lround(seconds * 20000);
  const double h = seconds / static_cast<double>(steps);
  double angle = 0;
  const auto bend = [&](double a) { return -stiffness * std::sin(a); };
  for (long i = 0; i < steps; ++i) {
    const double a1 = bend(angle), r1 = rate;
    const double a2 = bend(angle + 0.5 * h * r1), r2 = rate + 0.5 * h * a1;
    const double a3 = bend(angle + 0.5 * h * r2), r3 = rate + 0.5 * h * a2;
    const double a4 = bend(angle + h * r3), r4 = rate + h * a3;
    angle += h / 6 * (r1 + 2 * r2 + 2 * r3 + r4);
    rate += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
  }
  return angle;
}

PeerTask swinging_pinch() {
  Pinch world = pinch(8, kArm, 0.02, 0.1);
  set_free_velocity(world.scene.mechanism, world.cube, world.scene.q, {0, 6 * kArm, 0}, {6, 0, 0},
                    world.scene.v);
  const MovingScene scene = world.scene;
  const int cube = world.cube;
  const double mass = world.mass;
  const auto arm = [=](const PeerSample& sample) {
    return Vector3d(centre(scene, cube, sample) - Vector3d(0, 0, kArm));
  };
  PeerTask task;
  task.peer = {"swinging pinch", scene, 10, 0.1, pressed(scene)};
  task.about =
      "The same with 8 N, the cube's centre 5.4 mm below the grip's axis, started at 6 rad/s: a "
      "pendulum for 10 s, whose arm and energy stay";
  task.error = {"arm [mm]", [=](const PeerRun& run) {
                  const Vector3d at = arm(run.samples.back());
                  return std::abs(std::hypot(at.y(), at.z()) - kArm) / kMm;
                }};
  task.further.push_back({"energy [mg 10 mm]", [=](const PeerRun& run) {
                            return (energy(scene, cube, run.samples.back()) -
                                    energy(scene, cube, run.samples.front())) /
                                   (mass * kG * 0.01);
                          }});
  task.further.push_back(
      {"angle [rad]", [=](const PeerRun& run) {
         const auto i = static_cast<std::size_t>(cube);
         const double wanted =
             pendulum_angle(run.samples.back().t, 6, scene.mechanism.bodies[i].mass);
         const Vector3d at = arm(run.samples.back());
         return std::abs(std::remainder(std::atan2(at.y(), -at.z()) - wanted, 2 * kPi));
       }});
  task.lost = [=](const PeerRun& run) {
    const Vector3d at = arm(run.samples.back());
    return !(at.norm() <= kLostAt * kMm + kArm);
  };
  task.steps = kSteps;
  task.tolerances = kTolerances;
  return task;
}

PeerTask slide(const std::string& name, double angle) {
  Pinch world = pinch(0.4, 0, 0.02, 0.1);
  world.scene.gravity = Vector3d(0, std::sin(angle), -std::cos(angle)) * kG;
  const MovingScene scene = world.scene;
  const int cube = world.cube;
  const double seconds = 0.05, force = 2 * 0.8 * 0.4;
  const double way = 0.5 * (kG - force / world.mass) * seconds * seconds;
  PeerTask task;
  task.peer = {name, scene, seconds, 0.05, pressed(scene)};
  task.about = "The same with 0.4 N, below what holds it: the cube slides 4.2625 mm in 50 ms";
  task.error = {"error of the way [1]", [=](const PeerRun& run) {
                  const Vector3d gone = centre(scene, cube, run.samples.back());
                  return (gone - scene.gravity.normalized() * way).norm() / way;
                }};
  task.lost = above(task.error.of, 1);
  task.steps = {1e-4, 1e-3, 5e-3};
  task.tolerances = kTolerances;
  return task;
}

PeerTask capsule(double force) {
  MovingScene scene;
  const double radius = 0.0125, thick = 0.01;
  for (const double side : {-1.0, 1.0}) {
    ShapeSpec pad = primitive(ShapeKind::kBox, {thick, 0.03, 0.08});
    pad.X_BS.p = {side * (radius + 0.5 * thick), 0, 0};
    const int body = sample::add_on_joint(scene, side < 0 ? "left" : "right", pad, 0.05,
                                          JointKind::kSlide, {1, 0, 0}, {0, 0, 0});
    scene.drives.push_back(
        {scene.mechanism.joints[static_cast<std::size_t>(body)].coordinate, -side * force});
  }
  const int object =
      sample::add_body(scene, "capsule", primitive(ShapeKind::kCapsule, {radius, 0.05, 0}), 0.045);
  scene.friction.coefficient = 0.7;
  PeerTask task =
      hold(fmt::format("capsule, {:.0f} N", force),
           "Two pads press on a capsule of 45 g, friction 0.7, 60 s: it stays", scene, object, 60);
  task.steps = {1e-3, 5e-3};
  return task;
}

/// A start with free bodies sunk into what they lie on, each one deeper than the one below it.
Eigen::VectorXd sunk(const MovingScene& scene, const std::vector<int>& bodies, double slope) {
  const MechanismLayout layout = layout_of(scene.mechanism);
  Eigen::VectorXd q = scene.q;
  double depth = 0;
  for (const int body : bodies) {
    depth += kPressed;
    q.segment<3>(layout.first_q[static_cast<std::size_t>(body)] + 4) -=
        depth * Vector3d(std::sin(slope), 0, std::cos(slope));
  }
  return q;
}

PeerTask ramp_that_holds() {
  const sample::Incline world = sample::incline(30 * kDegree, std::tan(30.1 * kDegree));
  PeerTask task = hold("ramp, holds", "A cube on 30 degrees, friction tan(30.1), 10 s: it stays",
                       world.scene, world.cube, 10);
  task.peer.q_pressed = sunk(world.scene, {world.cube}, 30 * kDegree);
  task.error = {"slip [mm]", moved_mm(world.scene, world.cube, {1, 1, 1})};
  task.steps = kCoarseSteps;
  return task;
}

PeerTask ramp_that_slides() {
  const double slope = 30 * kDegree, friction = std::tan(29.9 * kDegree), seconds = 2;
  const sample::Incline world = sample::incline(slope, friction);
  const double way = 0.5 * kG * (std::sin(slope) - friction * std::cos(slope)) * seconds * seconds;
  const auto moved = moved_mm(world.scene, world.cube, {1, 1, 1});
  PeerTask task =
      hold("ramp, slides", "The same with tan(29.9), 2 s: it slides 34.25 mm, as computed",
           world.scene, world.cube, seconds);
  task.peer.q_pressed = sunk(world.scene, {world.cube}, slope);
  task.error = {"error of the way [1]",
                [=](const PeerRun& run) { return std::abs(moved(run) * kMm / way - 1); }};
  task.further.clear();
  task.lost = above(task.error.of, 1);
  task.steps = kCoarseSteps;
  return task;
}

PeerTask stack() {
  MovingScene scene;
  Pose<double> X;
  X.p.z() = -0.05;
  sample::add_body(scene, "floor", primitive(ShapeKind::kBox, {1, 1, 0.1}), 0, X);
  std::vector<int> cubes;
  for (int i = 0; i < 5; ++i) {
    X.p.z() = (i + 0.5) * kEdge;
    cubes.push_back(sample::add_body(scene, fmt::format("cube {}", i),
                                     primitive(ShapeKind::kBox, {kEdge, kEdge, kEdge}), 0.1, X));
  }
  scene.friction.coefficient = 0.5;
  PeerTask task =
      hold("stack", "Five cubes flat on each other, 10 s: nothing moves", scene, cubes.back(), 10);
  task.peer.q_pressed = sunk(scene, cubes, 0);
  task.error = {"way of the top cube [mm]", moved_mm(scene, cubes.back(), {1, 1, 1})};
  task.further = {{"in the second half", crept_mm(scene, cubes.back(), {1, 1, 1}, 5)}};
  task.steps = kCoarseSteps;
  return task;
}

/// Where a scene ends by our own steps at a tolerance of 1e-12, found when it is first asked for.
std::function<const std::vector<BodyMotion>&()> converged(const PeerScene& peer) {
  auto end = std::make_shared<std::vector<BodyMotion>>();
  return [=]() -> const std::vector<BodyMotion>& {
    if (end->empty()) {
      SceneOptions options;
      options.duration = peer.seconds;
      options.tolerance = 1e-12;
      options.columns = 8;
      const SceneRun run = simulate_scene(peer.scene, options);
      *end = motion_at(peer.scene, run.samples.back().q, run.samples.back().v);
    }
    return *end;
  };
}

PeerTask hand_swing() {
  PeerTask task;
  task.peer = {"free hand", sample::swinging_hand(), 0.5, 0.5};
  task.about = "21 joints swing freely for 0.5 s, against our own converged run";
  const auto wanted = converged(task.peer);
  const Mechanism mechanism = task.peer.scene.mechanism;
  task.error = {"joint error [rad]", [=](const PeerRun& run) {
                  double most = 0;
                  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
                    const double off = joint_motion(mechanism, i, run.samples.back().bodies).value -
                                       joint_motion(mechanism, i, wanted()).value;
                    most = std::max(most, std::abs(std::remainder(off, 2 * kPi)));
                  }
                  return most;
                }};
  task.lost = [](const PeerRun&) { return false; };
  task.steps = {5e-5, 1e-4, 2e-4, 5e-4, 1e-3, 2e-3, 5e-3};
  task.tolerances = {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12};
  task.touches = false;
  return task;
}

PeerTask carried_ball() {
  const sample::BallInHand world = sample::ball_in_hand();
  const MovingScene scene = world.scene;
  const auto ball = static_cast<std::size_t>(world.ball);
  PeerTask task;
  task.peer = {"ball in hand", scene, 1, 0.1, sunk(scene, {world.ball}, 0)};
  task.about =
      "Five fingers hold a ball on a palm that is carried along and swings, 11 contacts, 1 s, "
      "against "
      "our own converged run";
  const auto wanted = converged(task.peer);
  const auto off = [=](const PeerRun& run) {
    return (centre(scene, world.ball, run.samples.back()) - wanted()[ball].X_WB.p).norm() / kMm;
  };
  task.error = {"place of the ball [mm]", off};
  task.further.push_back({"its turn [rad]", [=](const PeerRun& run) {
                            const Eigen::Matrix3d R = run.samples.back().bodies[ball].X_WB.R *
                                                      wanted()[ball].X_WB.R.transpose();
                            return Eigen::AngleAxisd(R).angle();
                          }});
  task.lost = above(off, kLostAt);
  task.steps = {1e-4, 1e-3, 2e-3, 5e-3, 1e-2, 2e-2};
  task.tolerances = {1e-3, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12};
  return task;
}

}  // namespace

std::vector<PeerTask> contact_tasks() {
  std::vector<PeerTask> tasks{pinch_hold(),      swinging_pinch(),
                              slide("slide", 0), slide("slide at 45 degrees", 45 * kDegree),
                              light_fingers(),   heavy_cube(),
                              capsule(12),       capsule(60),
                              ramp_that_holds(), ramp_that_slides(),
                              stack(),           carried_ball(),
                              hand_swing()};
  for (const PeerTask& task : tasks) check_peer_scene(task.peer);
  return tasks;
}

}  // namespace thenar::bench
