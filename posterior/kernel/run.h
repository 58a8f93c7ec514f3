#pragma once

/// The whole model and its adjoint: steps forwards, and the same steps backwards.

#include "posterior/kernel/cell.h"
#include "posterior/kernel/hold.h"
#include "posterior/kernel/muscles.h"
#include "posterior/kernel/numbers.h"
#include "posterior/kernel/unit.h"

namespace thenar::kernel {
namespace {

/// Length of the work space that steps share.
inline int work_length(const Program& program) {
  const int n = program.coordinates, c = program.loads, longer = n > c ? n : c;
  return 2 * n * c + longer * longer + longer + 6 * c + 3 * n + 2 * c * c;
}

/// Torque of a trial about joint j; number or constant.
inline V torque_of(const Program& program, const PostureStep& posture, const Posed& posed,
                   int trial, int j) {
  return program.arms_move ? posed.torque[(trial - posture.first_trial) * program.coordinates + j]
                           : splat(program.still_torque[trial * program.coordinates + j]);
}

/// map = cell (first three rows of P);  force = map torque
inline void set_forces(const Program& program, int k, Posed& posed, V* force) {
  const int n = program.coordinates;
  const Mat cell = *posed.cell;
  const V* P = posed.inverse;
  V* map = posed.map;
  for (int j = 0; j < n; ++j) {
    const Vec f = cell * Vec{P[j], P[n + j], P[2 * n + j]};
    map[j] = f.x, map[n + j] = f.y, map[2 * n + j] = f.z;
  }
  const PostureStep& posture = program.postures[k];
  for (int i = posture.first_trial; i < posture.last_trial; ++i) {
    Vec f = {V{}, V{}, V{}};
    for (int j = 0; j < n; ++j) {
      const V torque = torque_of(program, posture, posed, i, j);
      f += torque * Vec{map[j], map[n + j], map[2 * n + j]};
    }
    V* out = force + 3 * program.trial_steps[i].column;
    out[0] = f.x, out[1] = f.y, out[2] = f.z;
  }
}

/// torque_bar = map' force_bar,  map_bar = sum force_bar torque',  and from it P_bar = cell'
/// map_bar and cell_bar = map_bar P'.
inline Mat pull_forces(const Program& program, int k, const Posed& posed, const V* force_bar,
                       Posed& bar) {
  const int n = program.coordinates;
  const V *P = posed.inverse, *map = posed.map;
  const PostureStep& posture = program.postures[k];
  for (int i = posture.first_trial; i < posture.last_trial; ++i) {
    const Vec push = vector_at(force_bar + 3 * program.trial_steps[i].column);
    for (int j = 0; j < n; ++j) {
      const V torque = torque_of(program, posture, posed, i, j);
      bar.map[j] += torque * push.x;
      bar.map[n + j] += torque * push.y;
      bar.map[2 * n + j] += torque * push.z;
      if (program.arms_move)
        bar.torque[(i - posture.first_trial) * n + j] =
            dot(push, Vec{map[j], map[n + j], map[2 * n + j]});
    }
  }
  Mat cell_bar = constant_matrix(kIdentity);
  cell_bar.x = cell_bar.y = cell_bar.z = {V{}, V{}, V{}};
  for (int j = 0; j < n; ++j) {
    const Vec map_bar = {bar.map[j], bar.map[n + j], bar.map[2 * n + j]};
    const Vec push = turned_back(*posed.cell, map_bar);
    bar.inverse[j] = push.x, bar.inverse[n + j] = push.y, bar.inverse[2 * n + j] = push.z;
    if (!program.cell_moves) continue;
    cell_bar.x += P[j] * map_bar;
    cell_bar.y += P[n + j] * map_bar;
    cell_bar.z += P[2 * n + j] * map_bar;
  }
  return cell_bar;
}

/// One posture forwards.
inline void run_posture(const Program& program, int k, const Numbers& digit, Posed& posed, V* work,
                        V* force) {
  set_angles(program, k, digit, posed);
  pose(program, digit, posed);
  if (program.arms_move) {
    set_paths(program, digit, posed);
    set_friction(program, digit, posed);
    set_rows(program, digit, posed);
    set_torques(program, k, digit, posed);
  }
  set_loads(program, digit, posed);
  invert_loads(posed.load, program.coordinates, program.loads, posed.inverse, work);
  set_cell(program, digit, posed);
  set_forces(program, k, posed, force);
}

/// One posture backwards. `bar` and `on` are zero beforehand.
inline void pull_posture(const Program& program, int k, const Numbers& digit, const Posed& posed,
                         const V* force_bar, Posed& bar, Wrenches& on, Numbers& bar_digit,
                         V* work) {
  const Mat cell_bar = pull_forces(program, k, posed, force_bar, bar);
  pull_cell(program, digit, posed, cell_bar, on, bar_digit);
  pull_inverse(posed.load, posed.inverse, bar.inverse, program.coordinates, program.loads, bar.load,
               work);
  pull_loads(program, digit, posed, bar.load, bar, on, bar_digit);
  if (program.arms_move) {
    pull_torques(program, k, digit, posed, bar, bar_digit);
    pull_rows(program, digit, posed, bar, bar_digit);
    pull_friction(program, digit, posed, bar, bar_digit);
    pull_paths(program, posed, bar, on, bar_digit);
  }
  pull_pose(program, posed, on, bar, bar_digit);
  pull_angles(program, k, bar, bar_digit);
}

/// Everything that one run leaves, in order: numbers, then postures.
inline long tape_length(const Program& program) {
  Bump bump(nullptr);
  Numbers numbers(program, bump);
  for (const PostureStep& posture : program.postures) Posed(program, posture, bump);
  return bump.used();
}

/// Room for u and forces, work space, and the adjoints of numbers and one posture.
inline long scratch_length(const Program& program) {
  Bump bump(nullptr);
  Numbers numbers(program, bump);
  Wrenches wrenches(program, bump);
  long most = 0;
  for (const PostureStep& posture : program.postures) {
    Bump own(nullptr);
    Posed(program, posture, own);
    most = own.used() > most ? own.used() : most;
  }
  return bump.used() + most + program.fit_coordinates + 3 * program.trials + work_length(program);
}

inline void gather(const double* const* points, int rows, V* to) {
  for (int i = 0; i < rows; ++i)
    for (int k = 0; k < kLanes; ++k) set_lane(to[i], k, points[k][i]);
}

inline void scatter(const V* from, int rows, int count, double* const* points) {
  for (int i = 0; i < rows; ++i)
    for (int k = 0; k < count; ++k) points[k][i] = lane(from[i], k);
}

inline void run(const Program& program, const double* const* u, int count, double* tape,
                double* scratch, double* const* forces) {
  Bump kept(reinterpret_cast<V*>(tape)), passing(reinterpret_cast<V*>(scratch));
  V* displacement = passing.take<V>(program.fit_coordinates);
  V* force = passing.take<V>(3 * program.trials);
  V* work = passing.take<V>(work_length(program));
  gather(u, program.fit_coordinates, displacement);
  Numbers digit(program, kept);
  set_numbers(program, displacement, digit);
  for (int k = 0; k < program.postures.size(); ++k) {
    Posed posed(program, program.postures[k], kept);
    run_posture(program, k, digit, posed, work, force);
  }
  scatter(force, 3 * program.trials, count, forces);
}

inline void pull(const Program& program, double* tape, const double* const* weights, int count,
                 double* scratch, double* const* gradient) {
  Bump kept(reinterpret_cast<V*>(tape)), passing(reinterpret_cast<V*>(scratch));
  V* u_bar = passing.take<V>(program.fit_coordinates);
  V* force_bar = passing.take<V>(3 * program.trials);
  V* work = passing.take<V>(work_length(program));
  gather(weights, 3 * program.trials, force_bar);
  const Numbers digit(program, kept);
  const long before = passing.used();
  Numbers bar_digit(program, passing);
  clear(u_bar, program.fit_coordinates);
  clear(u_bar + before, passing.used() - before);
  for (int k = 0; k < program.postures.size(); ++k) {
    Bump own = passing;
    const Posed posed(program, program.postures[k], kept);
    Posed bar(program, program.postures[k], own);
    Wrenches on(program, own);
    clear(u_bar + passing.used(), own.used() - passing.used());
    pull_posture(program, k, digit, posed, force_bar, bar, on, bar_digit, work);
  }
  pull_numbers(program, digit, bar_digit, u_bar);
  scatter(u_bar, program.fit_coordinates, count, gradient);
}

}  // namespace
}  // namespace thenar::kernel
