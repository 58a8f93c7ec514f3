#pragma once

/// Step 3a: moment arms of strands along their paths, with and without friction [m].

#include <algorithm>

#include "kinematics_fit/kernel/pose.h"

namespace thenar::kernel {
namespace {

/// Returns an angle of the posture [rad].
inline V angle_at(const AngleStep& angle, const PosedDigit& posed) {
  if (angle.coordinate < 0) return splat(angle.offset);
  return angle.ratio * posed.angle[angle.coordinate] + angle.offset;
}

/// Computes arms without friction: constant ones, or those of straight runs  u = (b - a) / |b - a|,
inline void set_paths(const Program& program, const DigitParameters& digit, PosedDigit& posed) {
  // Set constant arms; strands with a path start from zero.
  const int n = program.coordinates;
  for (int i = 0; i < program.strands * n; ++i)
    posed.frictionless_arm[i] = digit.number[program.arms + i];
  for (const int s : program.path_strands) clear(posed.frictionless_arm + s * n, n);
  // Compute the positions of the path points in the posture.
  for (int k = 0; k < program.nodes.size(); ++k)
    posed.node[k] =
        link_point(program, digit, posed, program.nodes[k].link, program.nodes[k].place);
  for (int k = 0; k < program.runs.size(); ++k) {
    // Compute the direction of the run, and add its contribution to the arm about every hinge
    // between its ends.
    const RunStep& run = program.runs[k];
    const Vec way = posed.node[run.to] - posed.node[run.from];
    posed.length[k] = 1.0 / square_root(dot(way, way));
    const Vec u = posed.run[k] = posed.length[k] * way;
    for (int i = run.first; i < run.last; ++i) {
      const ArmTerm& climb = program.arm_terms[i];
      const Vec r = posed.node[climb.node] - posed.point[climb.hinge];
      posed.frictionless_arm[climb.arm] += climb.weight * dot(u, cross(posed.axis[climb.hinge], r));
    }
  }
}

/// Adjoint of set_paths().
inline void adjoint_paths(const Program& program, const PosedDigit& posed, PosedDigit& adjoint,
                          Wrenches& on, DigitParameters& adjoint_digit) {
  const int n = program.coordinates;
  for (int k = 0; k < program.runs.size(); ++k) {
    // Add, for each term of the arm, adjoints of the direction, the axis and both points.
    const RunStep& run = program.runs[k];
    const Vec u = posed.run[k];
    Vec u_bar = {V{}, V{}, V{}};
    for (int i = run.first; i < run.last; ++i) {
      const ArmTerm& climb = program.arm_terms[i];
      const V g = climb.weight * adjoint.frictionless_arm[climb.arm];
      const Vec axis = posed.axis[climb.hinge];
      const Vec r = posed.node[climb.node] - posed.point[climb.hinge];
      const Vec r_bar = g * cross(u, axis);
      u_bar += g * cross(axis, r);
      adjoint.axis[climb.hinge] += g * cross(r, u);
      adjoint.point[climb.hinge] -= r_bar;
      adjoint.node[climb.node] += r_bar;
    }
    // Remove the component along the run, as the direction is normalised.
    const Vec way_bar = posed.length[k] * (u_bar - dot(u_bar, u) * u);
    adjoint.node[run.to] += way_bar;
    adjoint.node[run.from] -= way_bar;
  }
  // Pass adjoints from path points to links, then from constant arms to their numbers.
  for (int k = 0; k < program.nodes.size(); ++k)
    adjoint_link_point(posed, program.nodes[k].link, program.nodes[k].place, posed.node[k],
                       adjoint.node[k], on, adjoint_digit);
  for (const int s : program.path_strands) clear(adjoint.frictionless_arm + s * n, n);
  for (int i = 0; i < program.strands * n; ++i)
    adjoint_digit.number[program.arms + i] += adjoint.frictionless_arm[i];
}

/// Returns the size of a bend, smoothed as in bend_size() [rad].
inline V size_of(const BendStep& bend, const PosedDigit& posed) {
  const V angle = angle_at(bend.angle, posed);
  return bend.angle.coordinate < 0 ? (angle < 0.0 ? -angle : angle)
                                   : square_root(angle * angle + 1e-4);
}

/// Returns whether some bend first lowers the tension at coordinate j.
inline bool bends_before(const Program& program, int j) {
  return std::any_of(program.bends.begin(), program.bends.end(),
                     [j](const BendStep& bend) { return bend.first_coordinate_beyond == j; });
}

/// Computes arm = frictionless_arm exp(-mu bent),  with bent_j the sum of the bends between the
/// muscle and coordinate j.
inline void set_friction(const Program& program, const DigitParameters& digit, PosedDigit& posed) {
  // Without sheaths, copy the arms without friction.
  const int n = program.coordinates;
  for (int i = 0; i < program.strands * n; ++i) posed.arm[i] = posed.frictionless_arm[i];
  if (program.sheaths.size() == 0) return;
  // Sum of bends between the muscle and each coordinate.
  clear(posed.bent, n);
  for (const BendStep& bend : program.bends) {
    const V size = size_of(bend, posed);
    for (int j = bend.first_coordinate_beyond; j < n; ++j) posed.bent[j] += size;
  }
  // Compute the tension ratio; without another bend it equals that of the previous coordinate.
  for (const SheathStep& sheath : program.sheaths)
    for (int j = 0; j < n; ++j) {
      const int i = sheath.strand * n + j;
      if (bends_before(program, j))
        posed.tension_ratio[i] = exponential(-digit.number[sheath.friction] * posed.bent[j]);
      else
        posed.tension_ratio[i] = j == 0 ? splat(1) : posed.tension_ratio[i - 1];
      posed.arm[i] = posed.frictionless_arm[i] * posed.tension_ratio[i];
    }
}

/// Adjoint of set_friction().
inline void adjoint_friction(const Program& program, const DigitParameters& digit,
                             const PosedDigit& posed, PosedDigit& adjoint,
                             DigitParameters& adjoint_digit) {
  // Without sheaths, keep the adjoints.
  const int n = program.coordinates;
  for (int i = 0; i < program.strands * n; ++i) adjoint.frictionless_arm[i] = adjoint.arm[i];
  if (program.sheaths.size() == 0) return;
  for (const SheathStep& sheath : program.sheaths)
    for (int j = 0; j < n; ++j) {
      // Add adjoints of the arm, of the friction and of the bends.
      const int i = sheath.strand * n + j;
      adjoint.frictionless_arm[i] = adjoint.arm[i] * posed.tension_ratio[i];
      const V lost = adjoint.arm[i] * posed.arm[i];
      adjoint_digit.number[sheath.friction] -= lost * posed.bent[j];
      adjoint.bent[j] -= lost * digit.number[sheath.friction];
    }
  for (const BendStep& bend : program.bends) {
    // Pass adjoints from bends to the angles that cause them.
    if (bend.angle.coordinate < 0) continue;
    V size_bar = V{};
    for (int j = bend.first_coordinate_beyond; j < n; ++j) size_bar += adjoint.bent[j];
    adjoint.angle[bend.angle.coordinate] +=
        size_bar * bend.angle.ratio * angle_at(bend.angle, posed) / size_of(bend, posed);
  }
}

}  // namespace
}  // namespace thenar::kernel
