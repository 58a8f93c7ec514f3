#pragma once

/// A thumb of five skewed axes and nine tendons made up for tests and benchmarks, and its force
/// map on the other machine: a Simbody system rebuilt for every set of axes.

#include <Simbody.h>

#include "tests/hand/sample_subjects.h"
#include "tests/hand/simd_pair.h"
#include "tests/tendons/forces/force_map.h"

namespace thenar::sample {

inline constexpr int kThumbHinges = 5, kThumbTendons = 9, kThumbPostures = 2;

using ThumbAxes = std::array<Axis<double>, kThumbHinges>;
using ThumbArms = Eigen::Matrix<double, kThumbTendons, kThumbHinges>;
using ThumbPosture = Eigen::Matrix<double, kThumbHinges, 1>;
using ThumbMap = Eigen::Matrix<double, kThumbTendons, 3>;  // transposed
using ThumbMaps = std::array<ThumbMap, kThumbPostures>;

/// What stays the same while the axes are fitted.
struct ThumbTask {
  ThumbAxes axes;  // reference axes
  std::array<Tangents, kThumbHinges> frames;
  Eigen::Vector3d tip;                         // [m]
  std::array<ThumbPosture, kThumbPostures> q;  // [rad]
  std::array<ThumbArms, kThumbPostures> arms;  // [m/rad]
};

/// Four numbers for each axis: two tilts [rad], two shifts [m].
using AxisParameters = std::array<std::array<double, 4>, kThumbHinges>;

inline ThumbTask thumb_task(Draw& draw) {
  ThumbTask task;
  // Carpometacarpal flexion and abduction, the same of the next joint, then the last hinge.
  const std::array<Eigen::Vector3d, kThumbHinges> directions{
      {{0.2, 0.9, 0.3}, {0.8, -0.3, 0.5}, {0.1, 0.95, 0.2}, {0.9, 0.1, 0.3}, {0.05, 1, -0.1}}};
  const std::array<double, kThumbHinges> along{0, 0.012, 0.045, 0.048, 0.080};  // [m]
  for (int i = 0; i < kThumbHinges; ++i) {
    task.axes[i] = {directions[i].normalized(), Eigen::Vector3d(0, 0, along[i])};
    task.frames[i] = tangents(task.axes[i].direction);
  }
  task.tip = {0, 0, 0.105};
  for (int k = 0; k < kThumbPostures; ++k) {
    task.q[k] = draw.numbers(kThumbHinges, 0.2, 0.7);
    for (double& arm : task.arms[k].reshaped()) arm = draw.number(-0.012, 0.012);
  }
  return task;
}

inline AxisParameters axis_parameters(Draw& draw) {
  AxisParameters parameters;
  for (auto& by : parameters)
    by = {draw.number(-0.2, 0.2), draw.number(-0.2, 0.2), draw.number(-0.005, 0.005),
          draw.number(-0.005, 0.005)};
  return parameters;
}

inline ThumbAxes moved_axes(const ThumbTask& task, const AxisParameters& parameters) {
  ThumbAxes axes;
  for (int i = 0; i < kThumbHinges; ++i)
    axes[i] = moved_axis<double>(task.axes[i], task.frames[i], parameters[i]);
  return axes;
}

/// Our way, one posture after the other.
inline ThumbMaps thumb_maps(const ThumbTask& task, const AxisParameters& parameters) {
  const ThumbAxes axes = moved_axes(task, parameters);
  ThumbMaps maps;
  for (int k = 0; k < kThumbPostures; ++k)
    maps[k] = force_map(serial_jacobian(axes, task.tip, task.q[k]), task.arms[k]).At;
  return maps;
}

/// The data of both postures side by side.
struct PairedThumb {
  Vec3<SimdPair> tip;
  Eigen::Matrix<SimdPair, kThumbHinges, 1> q;
  Eigen::Matrix<SimdPair, kThumbTendons, kThumbHinges> arms;
};

inline PairedThumb paired(const ThumbTask& task) {
  const auto pair = [](double a, double b) { return SimdPair(a, b); };
  return {task.tip.cast<SimdPair>(), task.q[0].binaryExpr(task.q[1], pair),
          task.arms[0].binaryExpr(task.arms[1], pair)};
}

/// Our way, both postures at once. (tendons, 3)
inline Eigen::Matrix<SimdPair, kThumbTendons, 3> thumb_maps(const ThumbTask& task,
                                                            const PairedThumb& thumb,
                                                            const AxisParameters& parameters) {
  const ThumbAxes axes = moved_axes(task, parameters);
  std::array<Axis<SimdPair>, kThumbHinges> both;
  for (int i = 0; i < kThumbHinges; ++i)
    both[i] = {axes[i].direction.cast<SimdPair>(), axes[i].point.cast<SimdPair>()};
  return force_map(serial_jacobian(both, thumb.tip, thumb.q), thumb.arms).At;
}

inline ThumbMaps apart(const Eigen::Matrix<SimdPair, kThumbTendons, 3>& both) {
  return {both.unaryExpr([](const SimdPair& p) { return p[0]; }),
          both.unaryExpr([](const SimdPair& p) { return p[1]; })};
}

/// Simbody's way: axis frames are topology, so that every set of axes is a new system.
inline ThumbMaps thumb_maps_by_simbody(const ThumbTask& task, const AxisParameters& parameters) {
  const auto vec3 = [](const Eigen::Vector3d& v) { return SimTK::Vec3(v.x(), v.y(), v.z()); };
  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter(system);
  const SimTK::Body::Rigid body(SimTK::MassProperties(1, SimTK::Vec3(0), SimTK::Inertia(1)));
  SimTK::MobilizedBodyIndex last(0);
  for (const Axis<double>& axis : moved_axes(task, parameters)) {
    const SimTK::Transform X(SimTK::Rotation(SimTK::UnitVec3(vec3(axis.direction)), SimTK::ZAxis),
                             vec3(axis.point));
    last = SimTK::MobilizedBody::Pin(matter.updMobilizedBody(last), X, body, X)
               .getMobilizedBodyIndex();
  }
  SimTK::State state = system.realizeTopology();
  system.realizeModel(state);

  ThumbMaps maps;
  SimTK::Matrix J;
  for (int k = 0; k < kThumbPostures; ++k) {
    for (int i = 0; i < kThumbHinges; ++i) state.updQ()[i] = task.q[k][i];
    system.realize(state, SimTK::Stage::Position);
    matter.calcStationJacobian(state, last, vec3(task.tip), J);
    Eigen::Matrix<double, 3, kThumbHinges> jacobian;
    for (int i = 0; i < kThumbHinges; ++i)
      for (int row = 0; row < 3; ++row) jacobian(row, i) = J(row, i);
    maps[k] = force_map(jacobian, task.arms[k]).At;
  }
  return maps;
}

inline double difference(const ThumbMaps& a, const ThumbMaps& b) {
  double error = 0;
  for (int k = 0; k < kThumbPostures; ++k)
    error = std::max(error, (a[k] - b[k]).cwiseAbs().maxCoeff());
  return error;
}

}  // namespace thenar::sample
