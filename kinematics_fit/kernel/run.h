#pragma once

/// Complete force model and its adjoint: all steps forward, and the same steps backward.

#include "kinematics_fit/kernel/load_cell.h"
#include "kinematics_fit/kernel/muscles.h"
#include "kinematics_fit/kernel/parameters.h"
#include "kinematics_fit/kernel/simd_backend.h"
#include "kinematics_fit/kernel/tip_constraint.h"

namespace thenar::kernel {
namespace {

/// Returns the length of the workspace that the steps share [registers].
inline int work_length(const Program& program) {
  const int n = program.coordinates, c = program.loads, longer = n > c ? n : c;
  return 2 * n * c + longer * longer + longer + 6 * c + 3 * n + 2 * c * c;
}

/// Evaluates one posture.
inline void run_posture(const Program& program, int k, const DigitParameters& digit,
                        PosedDigit& posed, V* work, V* force) {
  // Steps 2 and 3: pose, and torques of the tendons.
  set_angles(program, k, digit, posed);
  pose(program, digit, posed);
  if (program.arms_move) {
    set_paths(program, digit, posed);
    set_friction(program, digit, posed);
    set_rows(program, digit, posed);
    set_torques(program, k, digit, posed);
  }
  // Steps 4 to 6: loads of the tip constraint, load cell, and forces.
  set_loads(program, digit, posed);
  invert_loads(posed.load, program.coordinates, program.loads, posed.inverse, work);
  set_load_cell(program, digit, posed);
  set_forces(program, k, digit, posed, force);
}

/// Evaluates the adjoint of one posture. `adjoint` and `on` must be zero.
// NOLINTNEXTLINE(readability-function-size): an adjoint takes the arguments, results and adjoints
inline void adjoint_posture(const Program& program, int k, const DigitParameters& digit,
                            const PosedDigit& posed, const V* force_bar, PosedDigit& adjoint,
                            Wrenches& on, DigitParameters& adjoint_digit, V* work) {
  // Steps 6 to 4 backward: forces, load cell, loads of the tip constraint.
  const Mat cell_bar = adjoint_forces(program, k, digit, posed, force_bar, adjoint, adjoint_digit);
  adjoint_load_cell(program, digit, posed, cell_bar, on, adjoint_digit);
  adjoint_pseudo_inverse(posed.load, posed.inverse, adjoint.inverse, program.coordinates,
                         program.loads, program.tip_forces, adjoint.load, work);
  adjoint_loads(program, digit, posed, adjoint.load, adjoint, on, adjoint_digit);
  // Step 3, if the arms move, and step 2.
  if (program.arms_move) {
    adjoint_torques(program, k, digit, posed, adjoint, adjoint_digit);
    adjoint_rows(program, digit, posed, adjoint, adjoint_digit);
    adjoint_friction(program, digit, posed, adjoint, adjoint_digit);
    adjoint_paths(program, posed, adjoint, on, adjoint_digit);
  }
  adjoint_pose(program, posed, on, adjoint, adjoint_digit);
  adjoint_angles(program, k, adjoint, adjoint_digit);
}

/// Returns whether any lane has a nonzero weight of a force of posture k.
inline bool asks_for(const Program& program, int k, const V* force_bar) {
  const PostureStep& posture = program.postures[k];
  for (int i = posture.first_trial; i < posture.last_trial; ++i)
    for (int c = 0; c < 3; ++c)
      for (int point = 0; point < kLanes; ++point)
        if (lane(force_bar[3 * program.trial_steps[i].column + c], point) != 0) return true;
  return false;
}

/// Returns the length of the tape of one run: numbers, then postures [registers].
inline long tape_length(const Program& program) {
  BumpAllocator bump(nullptr);
  DigitParameters numbers(program, bump);
  for (const PostureStep& posture : program.postures) PosedDigit(program, posture, bump);
  return bump.used();
}

/// Returns the length of the scratch memory for u and forces, the workspace, and the adjoints of
/// the numbers and of one posture [registers].
inline long scratch_length(const Program& program) {
  BumpAllocator bump(nullptr);
  DigitParameters numbers(program, bump);
  Wrenches wrenches(program, bump);
  // Take the maximum over the postures, whose adjoints share the memory.
  long max_used = 0;
  for (const PostureStep& posture : program.postures) {
    BumpAllocator own(nullptr);
    PosedDigit(program, posture, own);
    max_used = own.used() > max_used ? own.used() : max_used;
  }
  return bump.used() + max_used + program.fit_coordinates + 3 * program.trials +
         work_length(program);
}

/// Copies the numbers of the points into lanes.
inline void gather(const double* const* points, int rows, V* to) {
  for (int i = 0; i < rows; ++i)
    for (int k = 0; k < kLanes; ++k) set_lane(to[i], k, points[k][i]);
}

/// Copies the first `count` lanes to the points.
inline void scatter(const V* from, int rows, int count, double* const* points) {
  for (int i = 0; i < rows; ++i)
    for (int k = 0; k < count; ++k) points[k][i] = lane(from[i], k);
}

/// Evaluates the forces, see SimdBackend::run().
// NOLINTNEXTLINE(readability-function-size): the signature is SimdBackend's
inline void run(const Program& program, const double* const* u, int count, double* tape,
                double* scratch, double* const* forces, KeepTape keep) {
  // Allocate the workspace, and store points side by side in lanes.
  BumpAllocator kept(reinterpret_cast<V*>(tape)), passing(reinterpret_cast<V*>(scratch));
  V* displacement = passing.allocate<V>(program.fit_coordinates);
  V* force = passing.allocate<V>(3 * program.trials);
  V* work = passing.allocate<V>(work_length(program));
  gather(u, program.fit_coordinates, displacement);
  // Step 1, once for all postures.
  DigitParameters digit(program, kept);
  set_parameters(program, displacement, digit);
  for (int k = 0; k < program.postures.size(); ++k) {
    // Store postures one after another on the tape, or all at the same position.
    BumpAllocator own = kept;
    PosedDigit posed(program, program.postures[k], own);
    if (keep == KeepTape::kYes) kept = own;
    run_posture(program, k, digit, posed, work, force);
  }
  scatter(force, 3 * program.trials, count, forces);
}

/// Evaluates the adjoint, see SimdBackend::run_adjoint().
inline void run_adjoint(const Program& program, double* tape, const double* const* weights,
                        int count, double* scratch, double* const* gradient) {
  // Read the tape in the order in which it was written.
  BumpAllocator kept(reinterpret_cast<V*>(tape)), passing(reinterpret_cast<V*>(scratch));
  V* u_bar = passing.allocate<V>(program.fit_coordinates);
  V* force_bar = passing.allocate<V>(3 * program.trials);
  V* work = passing.allocate<V>(work_length(program));
  gather(weights, 3 * program.trials, force_bar);
  const DigitParameters digit(program, kept);
  // Clear the adjoints of the digit's numbers, which are sums over postures.
  const long before = passing.used();
  DigitParameters adjoint_digit(program, passing);
  clear(u_bar, program.fit_coordinates);
  clear(u_bar + before, passing.used() - before);
  for (int k = 0; k < program.postures.size(); ++k) {
    const PosedDigit posed(program, program.postures[k], kept);
    if (!asks_for(program, k, force_bar)) continue;
    // Clear the adjoints of the posture.
    BumpAllocator own = passing;
    PosedDigit adjoint(program, program.postures[k], own);
    Wrenches on(program, own);
    clear(u_bar + passing.used(), own.used() - passing.used());
    adjoint_posture(program, k, digit, posed, force_bar, adjoint, on, adjoint_digit, work);
  }
  // Step 1 backward.
  adjoint_parameters(program, digit, adjoint_digit, u_bar);
  scatter(u_bar, program.fit_coordinates, count, gradient);
}

}  // namespace
}  // namespace thenar::kernel
