#pragma once

/// Step 2: angles [rad], and positions and orientations of links and hinges [m]. The adjoint
/// accumulates forces and moments from the tip to the base, as in statics.

#include "kinematics_fit/kernel/tape.h"

namespace thenar::kernel {
namespace {

/// Returns R times the rotation of a hinge, with along = R d:
///   column k:  cos R e_k + (1 - cos) d_k along + sin R (d x e_k).
inline Mat turned(const Mat& R, const Vec& along, const Vec& d, const V& sine, const V& cosine) {
  const Vec u = (1.0 - cosine) * along, s = sine * d;
  return {cosine * R.x + d.x * u + s.z * R.y - s.y * R.z,
          cosine * R.y + d.y * u + s.x * R.z - s.z * R.x,
          cosine * R.z + d.z * u + s.y * R.x - s.x * R.y};
}

/// Computes sines and cosines of all hinges in posture `k`.
inline void set_angles(const Program& program, int k, const DigitParameters& digit,
                       PosedDigit& posed) {
  // Add the errors of all postures and of this one to the stated angles.
  const int n = program.coordinates, own = program.postures[k].own_error;
  for (int j = 0; j < n; ++j) {
    posed.angle[j] = program.q[k * n + j] + digit.number[program.angle_error + j];
    if (own >= 0) posed.angle[j] += digit.number[own + j];
  }
  // Compute sines and cosines; those of constant angles were precomputed.
  for (int i = 0; i < program.hinges.size(); ++i) {
    const StillAngle& still = program.still_angles[k * program.hinges.size() + i];
    const HingeStep& hinge = program.hinges[i];
    if (still.still) {
      posed.sine[i] = splat(still.sine), posed.cosine[i] = splat(still.cosine);
    } else {
      const auto turn = sine_and_cosine(hinge.ratio * posed.angle[hinge.coordinate] + hinge.offset);
      posed.sine[i] = turn.sine, posed.cosine[i] = turn.cosine;
    }
  }
}

/// Adjoint of set_angles(), from angles to their errors.
inline void adjoint_angles(const Program& program, int k, const PosedDigit& adjoint,
                           DigitParameters& adjoint_digit) {
  const int own = program.postures[k].own_error;
  for (int j = 0; j < program.coordinates; ++j) {
    adjoint_digit.number[program.angle_error + j] += adjoint.angle[j];
    if (own >= 0) adjoint_digit.number[own + j] += adjoint.angle[j];
  }
}

/// Computes, link by link:  axis = R_parent d,  point = its position on the parent,  R = R_parent
/// turn.
inline void pose(const Program& program, const DigitParameters& digit, PosedDigit& posed) {
  for (int i = 0; i < program.hinges.size(); ++i) {
    const HingeStep& hinge = program.hinges[i];
    const Vec d = digit.direction[i], p = vector_at(digit.number + hinge.point);
    Mat R = constant_matrix(kIdentity);
    // Pose hinges at the base, then those on a link with a known pose.
    posed.axis[i] = d, posed.point[i] = p;
    if (hinge.parent >= 0) {
      const int parent = hinge.parent;
      R = posed.R[parent];
      const Vec offset = p - vector_at(digit.number + program.hinges[parent].point);
      posed.axis[i] = R * d;
      posed.point[i] = posed.point[parent] + R * offset;
    }
    // Turn about the axis.
    posed.R[i] = turned(R, posed.axis[i], d, posed.sine[i], posed.cosine[i]);
  }
}

/// Adjoint of pose(). A force F at its hinge's point and a moment M about the point act on a link
/// (see Wrenches). The twists that move all links beyond are
///   by the angle: axis;  by a tilt e: sin R e + (1 - cos) axis x R e;  by the point: (R_parent -
///   R) e.
/// With the adjoints of the axis and the point themselves:
///   angle_bar = axis . M,
///   d_bar     = R_parent' (sin M + (1 - cos) M x axis + axis_bar),
///   p_bar     = R_parent' (F + point_bar) - R' F.
inline void adjoint_pose(const Program& program, const PosedDigit& posed, Wrenches& on,
                         PosedDigit& adjoint, DigitParameters& adjoint_digit) {
  for (int i = program.hinges.size() - 1; i >= 0; --i) {
    const HingeStep& hinge = program.hinges[i];
    const Vec F = on.force[i], M = on.moment[i], axis = posed.axis[i];
    // Take the moment along the axis as the angle's adjoint.
    adjoint.angle[hinge.coordinate] += hinge.ratio * dot(axis, M);
    Vec tilt = posed.sine[i] * M + (1.0 - posed.cosine[i]) * cross(M, axis) + adjoint.axis[i];
    // Transfer force and moment to the parent, as for a free body.
    const Vec total = F + adjoint.point[i];
    Vec shift = total;
    if (hinge.parent >= 0) {
      const int parent = hinge.parent;
      tilt = turned_back(posed.R[parent], tilt);
      shift = turned_back(posed.R[parent], shift);
      on.force[parent] += total;
      on.moment[parent] +=
          M + cross(axis, adjoint.axis[i]) + cross(posed.point[i] - posed.point[parent], total);
    }
    // Add adjoints of the hinge's numbers, if any coordinate moves them.
    if (hinge.tilts) adjoint_digit.direction[i] += tilt;
    if (hinge.shifts)
      add_vector(adjoint_digit.number + hinge.point, shift - turned_back(posed.R[i], F));
  }
}

/// Returns the position of a point of a link in the posture; link -1 is the base.
inline Vec link_point(const Program& program, const DigitParameters& digit, const PosedDigit& posed,
                      int link, int place) {
  const Vec p = vector_at(digit.number + place);
  if (link < 0) return p;
  return posed.point[link] +
         posed.R[link] * (p - vector_at(digit.number + program.hinges[link].point));
}

/// Adjoint of link_point(): a force `push` at the point's position x acts on its link.
// NOLINTNEXTLINE(readability-function-size): an adjoint takes the arguments, results and adjoints
inline void adjoint_link_point(const PosedDigit& posed, int link, int place, const Vec& x,
                               const Vec& push, Wrenches& on, DigitParameters& adjoint_digit) {
  if (link < 0) {
    add_vector(adjoint_digit.number + place, push);
  } else {
    add_vector(adjoint_digit.number + place, turned_back(posed.R[link], push));
    on.force[link] += push;
    on.moment[link] += cross(x - posed.point[link], push);
  }
}

}  // namespace
}  // namespace thenar::kernel
