#include <cmath>

#include "api/named/data_folders.h"
#include "base/parallel_tasks.h"
#include "dynamics/stepping/contact_step.h"
#include "hand/skin/skin_landmarks.h"
#include "studies/questions/demo.h"

namespace thenar {
namespace {

// Times of the scenes on one core of 2.5 GHz [s]
constexpr double kGlassTime = 0.3, kThumbTime = 1, kThumbOnPinsTime = 0.5, kBallTime = 0.7;

std::vector<PadState> thumb_pad_on_mug(const SceneResult& scene) {
  const Mechanism& mechanism = scene.built->scene.mechanism;
  const Subject& subject = default_human();
  const Eigen::Vector3d pad =
      pad_normal(subject, build_skeleton(subject, {{"thumb"}, {}}), "thumb");
  return pad_angles(scene.run, scene.measures, body_named(mechanism, "human:skewed/DP1"),
                    body_named(mechanism, "mug"), pad);
}

/// Both steppers on a ball that rolls off another, over a wide range of settings.
std::vector<WorkPoint> roll_ball(const std::string& data) {
  // The scene has an exact solution, so that errors are true ones.
  const std::string file =
      named_file("scene", "ball_on_ball", "scenes", ".toml", data_folders(data));
  const BuiltScene built = open_scene(read_scene(file), data).built;
  const auto ball = static_cast<std::size_t>(body_named(built.scene.mechanism, "ball"));
  // The exact end, from where it starts.
  ContactStep step(built.scene);
  std::vector<Pose<double>> X;
  step.compute_poses(step.initial_state(), X);
  const Eigen::Vector3d p = X[ball].p;
  const double angle = rolled_angle(std::atan2(p.x(), p.z()), built.options.duration, p.norm());
  const Eigen::Vector3d end = p.norm() * Eigen::Vector3d(std::sin(angle), 0, std::cos(angle));
  // Settings span the range from coarse to as accurate as doubles allow.
  WorkSettings settings;
  settings.tolerances = {1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11};
  settings.steps = {1e-2, 5e-3, 2e-3, 1e-3, 5e-4, 2e-4, 1e-4, 5e-5, 2e-5, 1e-5};
  return work_precision(built.scene, built.options, settings, [&](const SceneSample& sample) {
    step.compute_poses({sample.t, sample.q, sample.v, sample.z}, X);
    return (X[ball].p - end).norm();
  });
}

}  // namespace

std::vector<ParallelTask> demo_scene_tasks(const std::string& data, const std::optional<Path>& path,
                                           DemoMotion& motion) {
  // The mug is touched twice: by a thumb whose joints give, and by one on ideal hinges.
  SceneRequest glass, thumb, pinned;
  glass.data = thumb.data = data;
  glass.path = thumb.path = path;
  glass.scene = "wine_glass";
  thumb.scene = "thumb_mug";
  pinned = thumb;
  pinned.on_pins = true;
  const auto run = [](const SceneRequest& request, SceneResult& into) {
    return [request, &into](const Progress& progress) { into = simulate_scene(request, progress); };
  };
  // The thumb's pad is measured where its motion is whole.
  const auto run_thumb = [](const SceneRequest& request, SceneResult& into,
                            std::vector<PadState>& pad) {
    return [request, &into, &pad](const Progress& progress) {
      into = simulate_scene(request, progress);
      if (!progress.stop()) pad = thumb_pad_on_mug(into);
    };
  };
  return {{kGlassTime, run(glass, motion.glass)},
          {kThumbTime, run_thumb(thumb, motion.thumb, motion.pad)},
          {kThumbOnPinsTime, run_thumb(pinned, motion.thumb_on_pins, motion.pad_on_pins)},
          {kBallTime, [data, &motion](const Progress&) { motion.work = roll_ball(data); }}};
}

DemoMotion move_demo_scenes(const std::string& data, const Progress& progress,
                            const std::optional<Path>& path) {
  DemoMotion motion;
  run_tasks(demo_scene_tasks(data, path, motion), progress);
  return motion;
}

}  // namespace thenar
