#include "bench/grasp_task.h"

#include <random>

#include "base/thread_seconds.h"
#include "base/units.h"
#include "grasp/closing/approach.h"
#include "grasp/closing/approach_sampling.h"
#include "grasp/closing/close_hand.h"
#include "grasp/closing/closing_drives.h"
#include "grasp/closing/grasp.h"

namespace thenar::bench {
namespace {

GraspBody superellipsoid(double e1, double e2) {
  PlacedBody placed;
  ShapeSpec shape;
  shape.kind = ShapeKind::kSuperellipsoid;
  shape.size = {0.03, 0.04, 0.05};
  shape.exponents = {e1, e2};
  placed.body.name = "object";
  placed.body.material = "glass";
  placed.body.shapes = {shape};
  return build_body(placed);
}

/// Adds the time since `start`, which becomes now.
void add_lap(double& sum, double& start) {
  const double end = thread_seconds();
  sum += end - start;
  start = end;
}

void time_grasp(const GraspTask& task, const GraspSetup& setup, unsigned number,
                GraspTimes& times) {
  std::mt19937 random(number);
  Eigen::VectorXd q = open_posture(task.hand.layout());
  const double spread = sample_between(0, kPi, random);
  q = task.hand.posture((Eigen::Vector4d() << spread, 0, 0, 0).finished());
  const Pose<double> X_WH = sample_approach_pose(task.collision_hand, q, setup.object, random);
  const double way = approach_distance(task.collision_hand, q, setup.object);

  ++times.starts;
  double lap = thread_seconds();
  const ApproachResult approached = approach(task.collision_hand, X_WH, q, setup, way);
  add_lap(times.approach, lap);
  if (!approached.touches) return;
  const ClosedHand closed = close_hand(task.collision_hand, approached.X_WH, q, setup);
  add_lap(times.close, lap);
  const std::vector<HandContact> contacts =
      find_contacts({task.collision_hand, approached.X_WH, task.hand.pose(closed.q)}, setup);
  add_lap(times.contacts, lap);
  const Epsilon quality = epsilon(
      wrench_set(contacts_without_hand(contacts), setup.object.com, setup.object.torque_scale));
  add_lap(times.quality, lap);
  if (!contacts.empty()) ++times.grasped;
  if (quality.force_closure) ++times.closures;
}

}  // namespace

std::unique_ptr<const GraspTask> build_grasp_task() {
  auto task = std::make_unique<GraspTask>(
      GraspTask{RobotHand(read_robot(THENAR_DATA_DIR "/robots/barrett.toml")), {}, {}});
  task->collision_hand = collision_hand(task->hand);
  for (const double e1 : {0.3, 1.0, 1.7})
    for (const double e2 : {0.3, 1.0, 1.7})
      task->setups.push_back({superellipsoid(e1, e2), {}, built_in_materials()});
  return task;
}

GraspTimes& GraspTimes::operator+=(const GraspTimes& other) {
  approach += other.approach;
  close += other.close;
  contacts += other.contacts;
  quality += other.quality;
  starts += other.starts;
  grasped += other.grasped;
  closures += other.closures;
  return *this;
}

GraspTimes time_grasps(const GraspTask& task, int first, int step, int count) {
  GraspTimes times;
  for (std::size_t i = 0; i < task.setups.size(); ++i)
    for (int g = first; g < count; g += step)
      time_grasp(task, task.setups[i],
                 static_cast<unsigned>(i) * 100'000U + static_cast<unsigned>(g), times);
  return times;
}

}  // namespace thenar::bench
