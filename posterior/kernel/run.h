#pragma once

/// The whole model and its adjoint: steps forwards, and the same steps backwards.

#include "posterior/kernel/cell.h"
#include "posterior/kernel/forces.h"
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
                double* scratch, double* const* forces, KeepTape keep) {
  Bump kept(reinterpret_cast<V*>(tape)), passing(reinterpret_cast<V*>(scratch));
  V* displacement = passing.take<V>(program.fit_coordinates);
  V* force = passing.take<V>(3 * program.trials);
  V* work = passing.take<V>(work_length(program));
  gather(u, program.fit_coordinates, displacement);
  Numbers digit(program, kept);
  set_numbers(program, displacement, digit);
  for (int k = 0; k < program.postures.size(); ++k) {
    Bump own = kept;
    Posed posed(program, program.postures[k], own);
    if (keep == KeepTape::kYes) kept = own;
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
