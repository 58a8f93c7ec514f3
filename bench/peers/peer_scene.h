#pragma once

/// One statement of a scene for all engines, and what a run of it gives back.

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/thread_seconds.h"
#include "dynamics/stepping/moving_scene.h"

namespace thenar::bench {

/// A scene that every engine can be given: bodies of spheres, capsules and boxes; hinges and slides
/// that each have a coordinate of their own, free bodies, and welds to the world; one coefficient
/// of friction; drives without a limit of effort, which act the whole time.
struct PeerScene {
  std::string name;
  MovingScene scene;
  double seconds = 1;   // how long [s]
  double sample = 0.1;  // between the instants that are kept [s]

  /// Where engines start that see a contact only once bodies overlap: a nanometre inside, or the
  /// object would fall freely in their first step. Empty: as the scene. (q)
  Eigen::VectorXd q_pressed = {};

  [[nodiscard]] const Eigen::VectorXd& rival_q() const {
    return q_pressed.size() > 0 ? q_pressed : scene.q;
  }
};

/// Where a body is, and how it moves.
struct BodyMotion {
  Pose<double> X_WB;
  Eigen::Vector3d linear{0, 0, 0};   // velocity of the centre of mass [m/s] (3)
  Eigen::Vector3d angular{0, 0, 0};  // [rad/s] (3)
};

/// All bodies at an instant.
struct PeerSample {
  double t = 0;  // [s]
  std::vector<BodyMotion> bodies;
};

/// What an engine made of a scene.
struct PeerRun {
  std::vector<PeerSample> samples;  // the start first
  double cpu_seconds = 0;           // of this thread, without building the scene [s]
  std::string message;              // empty: it ran to the end
};

/// Which scenes a setting is for: all, or those where its difference shows.
enum class PeerUse { kAll, kContacts, kFree };

/// An engine at one of its settings.
struct PeerSetting {
  std::string engine;     // "MuJoCo"
  std::string setting;    // "elliptic, impratio 10"
  bool adaptive = false;  // its knob is a tolerance, not a step [s]
  std::function<PeerRun(const PeerScene&, double knob)> run;
  PeerUse use = PeerUse::kAll;

  [[nodiscard]] std::string name() const { return engine + ", " + setting; }
};

/// Processor time that a run may take [s].
inline constexpr double kPatience = 10;

/// An engine of fixed steps that holds a scene.
class PeerWorld {
 public:
  PeerWorld() = default;
  PeerWorld(const PeerWorld&) = delete;
  PeerWorld& operator=(const PeerWorld&) = delete;
  virtual ~PeerWorld() = default;

  virtual void step() = 0;
  [[nodiscard]] virtual std::vector<BodyMotion> motion() const = 0;
};

/// Runs a world to the end of its scene.
[[nodiscard]] PeerRun run_world(PeerWorld& world, const PeerScene& scene, double step);

/// All bodies of a scene at some positions and speeds.
[[nodiscard]] std::vector<BodyMotion> motion_at(const MovingScene& scene, const Eigen::VectorXd& q,
                                                const Eigen::VectorXd& v);

/// A setting whose World is built from (scene, step, options...).
template <typename World, typename... Options>
[[nodiscard]] PeerSetting stepped(const std::string& engine, const std::string& setting,
                                  PeerUse use, const Options&... options) {
  return {
      engine, setting, false,
      [=](const PeerScene& scene, double step) {
        // A whole number of steps to the end.
        const double even = scene.seconds / std::round(scene.seconds / step);
        try {
          World world(scene, even, options...);
          return run_world(world, scene, even);
        } catch (const InputError&) {
          return PeerRun{{{0, motion_at(scene.scene, scene.scene.q, scene.scene.v)}}, 0, "cannot"};
        }
      },
      use};
}

/// @throws InputError if a scene has what not every engine can be given.
void check_peer_scene(const PeerScene& scene);

/// Value of a hinge or slide and its rate.
struct JointMotion {
  double value, rate;  // [rad] or [m], [rad/s] or [m/s]
};
[[nodiscard]] JointMotion joint_motion(const Mechanism& mechanism, std::size_t joint,
                                       const std::vector<BodyMotion>& bodies);

/// Effort at a hinge or slide of its spring, its damper and the drives of its coordinate.
[[nodiscard]] double joint_effort(const MovingScene& scene, std::size_t joint, double t,
                                  const JointMotion& motion);

/// Whether the effort of a joint changes with its motion or with time.
[[nodiscard]] bool effort_varies(const MovingScene& scene, std::size_t joint);

/// Shapes of a body; empty: it touches nothing.
[[nodiscard]] std::vector<ShapeSpec> shapes_of(const MechanismBody& body);

/// Whether two bodies are asked for contacts: not neighbours on a joint, not both fixed, not apart.
[[nodiscard]] bool may_touch(const MovingScene& scene, std::size_t a, std::size_t b);

// Settings of each engine, its default first; the others are its best for some of these scenes.
// One function a file, peer_*.cpp. Engines that are not installed are not built.
[[nodiscard]] std::vector<PeerSetting> our_settings();
[[nodiscard]] std::vector<PeerSetting> simbody_settings();
[[nodiscard]] std::vector<PeerSetting> mujoco_settings();
[[nodiscard]] std::vector<PeerSetting> ode_settings();
[[nodiscard]] std::vector<PeerSetting> bullet_settings();
[[nodiscard]] std::vector<PeerSetting> dart_settings();

}  // namespace thenar::bench
