#pragma once

/// Step 4: loads of the tip constraint: torque about each joint per unit load.

#include "kinematics_fit/kernel/pose.h"
#include "kinematics_fit/kernel/pseudo_inverse.h"

namespace thenar::kernel {
namespace {

/// Computes the torque about each joint per load (coordinates, loads). The row of a joint holds
/// forces in two or three directions a_k of the tip,  ratio (axis x (tip - point)) . a_k,  and
/// moments,
///   ratio length axis . a_k.
inline void set_loads(const Program& program, const DigitParameters& digit, PosedDigit& posed) {
  // Compute position and directions of the tip in the posture.
  const int c = program.loads, forces = program.tip_forces;
  const V out = digit.number[program.out_of_plane];
  const Vec tip = *posed.tip = link_point(program, digit, posed, program.tip_link, program.tip);
  const Mat a = *posed.axes = posed.R[program.tip_link] * constant_matrix(program.tip_axes);
  clear(posed.load, program.coordinates * c);
  for (const int i : program.tip_hinges) {
    // Compute the loads of forces, then of the moments that a rigid constraint adds.
    const double ratio = program.hinges[i].ratio;
    V* load = posed.load + program.hinges[i].coordinate * c;
    const Vec m = cross(posed.axis[i], tip - posed.point[i]);
    load[0] += ratio * dot(m, a.x);
    load[1] += ratio * dot(m, a.y);
    if (forces == 3) load[2] += ratio * dot(m, a.z);
    if (c > forces) load[forces] += ratio * program.hold_length * dot(posed.axis[i], a.z);
    if (c == 6) {
      load[4] += ratio * out * dot(posed.axis[i], a.x);
      load[5] += ratio * out * dot(posed.axis[i], a.y);
    }
  }
}

/// Adjoint of set_loads(). Directions a_k rotate with the tip's link; the moment on it is  a_k x
/// a_k_bar.
// NOLINTNEXTLINE(readability-function-size): an adjoint takes the arguments, results and adjoints
inline void adjoint_loads(const Program& program, const DigitParameters& digit,
                          const PosedDigit& posed, const V* load_bar, PosedDigit& adjoint,
                          Wrenches& on, DigitParameters& adjoint_digit) {
  const int c = program.loads, forces = program.tip_forces, link = program.tip_link;
  const V out = digit.number[program.out_of_plane];
  const Mat& a = *posed.axes;
  Vec push = {V{}, V{}, V{}};
  for (const int i : program.tip_hinges) {
    // Add the adjoints of the forces: by tip, axis and point, and by the rotation of the tip.
    const double ratio = program.hinges[i].ratio;
    const V* g = load_bar + program.hinges[i].coordinate * c;
    const Vec axis = posed.axis[i], r = *posed.tip - posed.point[i];
    Vec w = ratio * g[0] * a.x + ratio * g[1] * a.y;
    if (forces == 3) w += ratio * g[2] * a.z;
    const Vec pull = cross(w, axis);
    push += pull;
    adjoint.point[i] -= pull;
    adjoint.axis[i] += cross(r, w);
    on.moment[link] += cross(w, cross(axis, r));
    if (c == forces) continue;
    // Add the adjoints of the moments.
    Vec turn = ratio * program.hold_length * g[forces] * a.z;
    if (c == 6) {
      turn += ratio * out * g[4] * a.x + ratio * out * g[5] * a.y;
      adjoint_digit.number[program.out_of_plane] +=
          ratio * (g[4] * dot(axis, a.x) + g[5] * dot(axis, a.y));
    }
    adjoint.axis[i] += turn;
    on.moment[link] += cross(turn, axis);
  }
  adjoint_link_point(posed, link, program.tip, *posed.tip, push, on, adjoint_digit);
}

}  // namespace
}  // namespace thenar::kernel
