#pragma once

/// Step 1: numbers of the digit from displacements u, and the adjoint.

#include "kinematics_fit/kernel/tape.h"

namespace thenar::kernel {
namespace {

/// Computes number = start + weights u  and  direction = number / |number|.
inline void set_parameters(const Program& program, const V* u, DigitParameters& digit) {
  // Add the linear terms in u.
  for (int i = 0; i < program.start.size(); ++i) digit.number[i] = splat(program.start[i]);
  for (const LinearTerm& move : program.moves)
    digit.number[move.number] += move.weight * u[move.coordinate];
  // Normalise axis directions; those that never tilt have unit length already.
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

/// Adjoint of set_parameters(). Normalisation removes the component along the direction itself.
inline void adjoint_parameters(const Program& program, const DigitParameters& digit,
                               DigitParameters& adjoint, V* u_bar) {
  // Differentiate by axis directions before normalisation.
  for (int i = 0; i < program.hinges.size(); ++i) {
    if (!program.hinges[i].tilts) continue;
    const Vec d = digit.direction[i], push = adjoint.direction[i];
    add_vector(adjoint.number + program.hinges[i].direction,
               digit.shrink[i] * (push - dot(push, d) * d));
  }
  // Apply the transpose of the linear terms.
  for (const LinearTerm& move : program.moves)
    u_bar[move.coordinate] += move.weight * adjoint.number[move.number];
}

}  // namespace
}  // namespace thenar::kernel
