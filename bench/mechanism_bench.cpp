// Accelerations of a hand of 21 joints, four fingers of four and a skewed thumb of five: recursions
// beside Simbody.

#include <benchmark/benchmark.h>

#include "dynamics/mechanism/articulated_body.h"
#include "dynamics/mechanism/build_mechanism.h"
#include "dynamics/mechanism/composite_body.h"
#include "dynamics/mechanism/simbody_machine.h"

namespace thenar {
namespace {

const Eigen::Vector3d kFall(0, 0, -9.81);

/// The human hand without its wrist.
Mechanism hand() {
  SkeletonOptions options;
  const Subject subject = read_subject(THENAR_DATA_DIR "/subjects/human_hand.toml");
  for (const std::string& joint : shared_joints(subject)) options.frozen[joint] = 0;
  return skeleton_mechanism(build_skeleton(subject, options));
}

/// A hand in motion.
struct Task {
  Mechanism mechanism = hand();
  TreeModel model = tree_model(mechanism);
  TreeMotion<double> motion{model};
  Eigen::VectorXd q = Eigen::VectorXd::LinSpaced(model.layout.q, 0.1, 0.5);
  Eigen::VectorXd v = Eigen::VectorXd::LinSpaced(model.layout.v, -3, 3);
  Eigen::VectorXd tau = Eigen::VectorXd::Constant(model.layout.v, 0.01);
  Eigen::VectorXd v_dot = Eigen::VectorXd::Zero(model.layout.v);

  void move() {
    q[0] = 0.6 - q[0];  // so that nothing is known beforehand
    motion.set_position(q);
    motion.set_speed(v);
    motion.clear_loads();
  }
};

void positions(benchmark::State& state) {
  Task task;
  for (auto _ : state) {
    task.q[0] = 0.6 - task.q[0];
    task.motion.set_position(task.q);
    benchmark::DoNotOptimize(task.motion.links().back().o);
  }
  state.counters["speeds"] = task.model.layout.v;
}
BENCHMARK(positions);

void articulated_body(benchmark::State& state) {
  Task task;
  ArticulatedBody<double> machine(task.model);
  for (auto _ : state) {
    task.move();
    machine.accelerations(task.motion, kFall, task.tau, task.v_dot);
    benchmark::DoNotOptimize(task.v_dot.sum());
  }
}
BENCHMARK(articulated_body);

void mass_matrix_and_factor(benchmark::State& state) {
  Task task;
  MassMatrix<double> mass(task.model);
  for (auto _ : state) {
    task.q[0] = 0.6 - task.q[0];
    task.motion.set_position(task.q);
    benchmark::DoNotOptimize(mass.compute(task.motion));
  }
}
BENCHMARK(mass_matrix_and_factor);

void inverse_dynamics(benchmark::State& state) {
  Task task;
  InverseDynamics<double> machine(task.model);
  for (auto _ : state) {
    task.move();
    machine.efforts(task.motion, kFall, task.v, task.v_dot);
    benchmark::DoNotOptimize(task.v_dot.sum());
  }
}
BENCHMARK(inverse_dynamics);

void simbody(benchmark::State& state) {
  Task task;
  SimbodyMachine machine(task.mechanism);
  for (auto _ : state) {
    task.q[0] = 0.6 - task.q[0];
    machine.set_state(task.q, task.v);
    benchmark::DoNotOptimize(machine.accelerations(task.tau, kFall).sum());
  }
}
BENCHMARK(simbody);

}  // namespace
}  // namespace thenar
