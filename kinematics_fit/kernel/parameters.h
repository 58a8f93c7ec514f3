#pragma once

/// Step 1: from displacements u to the numbers of the digit, and the adjoint.

#include "kinematics_fit/kernel/tape.h"

namespace thenar::kernel {
namespace {

/// number = start + weights u;  direction = number / |number|
inline void set_parameters(const Program& program, const V* u, DigitParameters& digit) {
  // Straight lines in u.
  for (int i = 0; i < program.start.size(); ++i) digit.number[i] = splat(program.start[i]);
  for (const LinearTerm& move : program.moves)
    digit.number[move.number] += move.weight * u[move.coordinate];
  // Axis directions of unit length; those that never tilt have it already.
  for (int i = 0; i < program.hinges.size(); ++i) {
    const Vec d = vector_at(digit.number + program.hinges[i].direction);
    if (program.hinges[i].tilts) {
      digit.shrink[i] = 1.0 / square_root(dot(d, d));
      digit.direction[i] = digit.shrink[i] * d;
    } else {
      digit.direction[i] = d;
    }
  }
}

/// Adjoint. Normalisation removes the part along the direction itself.
inline void adjoint_parameters(const Program& program, const DigitParameters& digit,
                               DigitParameters& adjoint, V* u_bar) {
  // Axis directions before normalisation.
  for (int i = 0; i < program.hinges.size(); ++i) {
    if (!program.hinges[i].tilts) continue;
    const Vec d = digit.direction[i], push = adjoint.direction[i];
    add_vector(adjoint.number + program.hinges[i].direction,
               digit.shrink[i] * (push - dot(push, d) * d));
  }
  // Transpose of the straight lines.
  for (const LinearTerm& move : program.moves)
    u_bar[move.coordinate] += move.weight * adjoint.number[move.number];
}

}  // namespace
}  // namespace thenar::kernel
