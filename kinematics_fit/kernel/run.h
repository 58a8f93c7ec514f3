#pragma once

/// The whole force model and its adjoint: all steps forwards, and the same steps backwards.

#include "kinematics_fit/kernel/load_cell.h"
#include "kinematics_fit/kernel/muscles.h"
#include "kinematics_fit/kernel/parameters.h"
#include "kinematics_fit/kernel/simd_backend.h"
#include "kinematics_fit/kernel/tip_constraint.h"

namespace thenar::kernel {
namespace {

/// Length of the work space that steps share [registers].
inline int work_length(const Program& program) {
  const int n = program.coordinates, c = program.loads, longer = n > c ? n : c;
  return 2 * n * c + longer * longer + longer + 6 * c + 3 * n + 2 * c * c;
}

/// One posture forwards.
inline void run_posture(const Program& program, int k, const DigitParameters& digit, Posed& posed,
                        V* work, V* force) {
  // Steps 2 and 3: pose, and torques of the tendons.
  set_angles(program, k, digit, posed);
  pose(program, digit, posed);
  if (program.arms_move) {
    set_paths(program, digit, posed);
    set_friction(program, digit, posed);
    set_rows(program, digit, posed);
    set_torques(program, k, digit, posed);
  }
  // Steps 4 to 6: loads of the hold, the load cell, and forces.
  set_loads(program, digit, posed);
  invert_loads(posed.load, program.coordinates, program.loads, posed.inverse, work);
  set_load_cell(program, digit, posed);
  set_forces(program, k, digit, posed, force);
}

/// One posture backwards. `adjoint` and `on` are zero beforehand.
// NOLINTNEXTLINE(readability-function-size): an adjoint takes the arguments, results and adjoints
inline void adjoint_posture(const Program& program, int k, const DigitParameters& digit,
                            const Posed& posed, const V* force_bar, Posed& adjoint, Wrenches& on,
                            DigitParameters& adjoint_digit, V* work) {
  // Steps 6 to 4 backwards: forces, load cell, loads of the hold.
  const Mat cell_bar = adjoint_forces(program, k, digit, posed, force_bar, adjoint, adjoint_digit);
  adjoint_load_cell(program, digit, posed, cell_bar, on, adjoint_digit);
  adjoint_pseudo_inverse(posed.load, posed.inverse, adjoint.inverse, program.coordinates,
                         program.loads, program.tip_forces, adjoint.load, work);
  adjoint_loads(program, digit, posed, adjoint.load, adjoint, on, adjoint_digit);
  // Step 3, where arms move at all, and step 2.
  if (program.arms_move) {
    adjoint_torques(program, k, digit, posed, adjoint, adjoint_digit);
    adjoint_rows(program, digit, posed, adjoint, adjoint_digit);
    adjoint_friction(program, digit, posed, adjoint, adjoint_digit);
    adjoint_paths(program, posed, adjoint, on, adjoint_digit);
  }
  adjoint_pose(program, posed, on, adjoint, adjoint_digit);
  adjoint_angles(program, k, adjoint, adjoint_digit);
}

/// Returns whether any lane asks for a force of posture k.
inline bool asks_for(const Program& program, int k, const V* force_bar) {
  const PostureStep& posture = program.postures[k];
  for (int i = posture.first_trial; i < posture.last_trial; ++i)
    for (int c = 0; c < 3; ++c)
      for (int point = 0; point < kLanes; ++point)
        if (lane(force_bar[3 * program.trial_steps[i].column + c], point) != 0) return true;
  return false;
}

/// Length of the tape of one run: numbers, then postures [registers].
inline long tape_length(const Program& program) {
  BumpAllocator bump(nullptr);
  DigitParameters numbers(program, bump);
  for (const PostureStep& posture : program.postures) Posed(program, posture, bump);
  return bump.used();
}

/// Returns the length of the scratch memory for u and forces, work space, and the adjoints of
/// numbers and one posture.
inline long scratch_length(const Program& program) {
  BumpAllocator bump(nullptr);
  DigitParameters numbers(program, bump);
  Wrenches wrenches(program, bump);
  // The largest posture: adjoints of one at a time.
  long most = 0;
  for (const PostureStep& posture : program.postures) {
    BumpAllocator own(nullptr);
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

// NOLINTNEXTLINE(readability-function-size): the signature is SimdBackend's
inline void run(const Program& program, const double* const* u, int count, double* tape,
                double* scratch, double* const* forces, KeepTape keep) {
  // Work space; points lie side by side in the lanes.
  BumpAllocator kept(reinterpret_cast<V*>(tape)), passing(reinterpret_cast<V*>(scratch));
  V* displacement = passing.take<V>(program.fit_coordinates);
  V* force = passing.take<V>(3 * program.trials);
  V* work = passing.take<V>(work_length(program));
  gather(u, program.fit_coordinates, displacement);
  // Step 1, once for all postures.
  DigitParameters digit(program, kept);
  set_parameters(program, displacement, digit);
  for (int k = 0; k < program.postures.size(); ++k) {
    // Postures one behind the other on the tape, or all in the same place.
    BumpAllocator own = kept;
    Posed posed(program, program.postures[k], own);
    if (keep == KeepTape::kYes) kept = own;
    run_posture(program, k, digit, posed, work, force);
  }
  scatter(force, 3 * program.trials, count, forces);
}

inline void run_adjoint(const Program& program, double* tape, const double* const* weights,
                        int count, double* scratch, double* const* gradient) {
  // The tape in the order in which it was written.
  BumpAllocator kept(reinterpret_cast<V*>(tape)), passing(reinterpret_cast<V*>(scratch));
  V* u_bar = passing.take<V>(program.fit_coordinates);
  V* force_bar = passing.take<V>(3 * program.trials);
  V* work = passing.take<V>(work_length(program));
  gather(weights, 3 * program.trials, force_bar);
  const DigitParameters digit(program, kept);
  // Adjoints of the digit's numbers sum over postures: zero at first.
  const long before = passing.used();
  DigitParameters adjoint_digit(program, passing);
  clear(u_bar, program.fit_coordinates);
  clear(u_bar + before, passing.used() - before);
  for (int k = 0; k < program.postures.size(); ++k) {
    const Posed posed(program, program.postures[k], kept);
    if (!asks_for(program, k, force_bar)) continue;
    // Adjoints of a posture begin at zero each time.
    BumpAllocator own = passing;
    Posed adjoint(program, program.postures[k], own);
    Wrenches on(program, own);
    clear(u_bar + passing.used(), own.used() - passing.used());
    adjoint_posture(program, k, digit, posed, force_bar, adjoint, on, adjoint_digit, work);
  }
  // Step 1 backwards.
  adjoint_parameters(program, digit, adjoint_digit, u_bar);
  scatter(u_bar, program.fit_coordinates, count, gradient);
}

}  // namespace
}  // namespace thenar::kernel
