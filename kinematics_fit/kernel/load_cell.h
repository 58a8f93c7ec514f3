#pragma once

/// Steps 5 and 6: components of the load cell from those of the tip, and forces of all trials [N].

#include "kinematics_fit/kernel/pose.h"
#include "kinematics_fit/kernel/tape.h"

namespace thenar::kernel {
namespace {

/// Cayley's rotation  Q = I + s (K + K^2),  K = [h],  h = w / 2,  s = 2 / (1 + |h|^2).
struct Tilt {
  Vec h;
  V s;
  Mat turn;  // K + K^2
  Mat Q;
};

/// Computes the rotation of a rotation vector w.
inline Tilt tilt_of(const Vec& w) {
  Tilt t;
  t.h = splat(0.5) * w;
  const Vec& h = t.h;
  // Compute K + K^2 from the components of h, column by column.
  const V square = dot(h, h);
  t.s = 2.0 / (1.0 + square);
  t.turn = {{h.x * h.x - square, h.x * h.y + h.z, h.x * h.z - h.y},
            {h.x * h.y - h.z, h.y * h.y - square, h.y * h.z + h.x},
            {h.x * h.z + h.y, h.y * h.z - h.x, h.z * h.z - square}};
  t.Q = {t.s * t.turn.x, t.s * t.turn.y, t.s * t.turn.z};
  t.Q.x.x += 1.0, t.Q.y.y += 1.0, t.Q.z.z += 1.0;
  return t;
}

/// Returns w_bar from Q_bar, through K, K^2 and s.
inline Vec adjoint_tilt(const Tilt& t, const Mat& Q_bar) {
  const Mat B = transposed(Q_bar);
  const Vec twist = {Q_bar.y.z - Q_bar.z.y, Q_bar.z.x - Q_bar.x.z, Q_bar.x.y - Q_bar.y.x};
  const V trace = Q_bar.x.x + Q_bar.y.y + Q_bar.z.z;
  const V s_bar = dot(Q_bar.x, t.turn.x) + dot(Q_bar.y, t.turn.y) + dot(Q_bar.z, t.turn.z);
  const Vec h_bar =
      t.s * (twist + (Q_bar * t.h + B * t.h) - (2.0 * trace) * t.h) - (t.s * t.s * s_bar) * t.h;
  return splat(0.5) * h_bar;
}

/// Returns the directions of the force components, in the posture of their link.
inline Mat stated_axes(const Program& program, const PosedDigit& posed) {
  const Mat axes = constant_matrix(program.tip_axes);
  return program.force_link < 0 ? axes : posed.R[program.force_link] * axes;
}

/// Computes cell = components  tilt  stated_axes' tip_axes.
inline void set_load_cell(const Program& program, const DigitParameters& digit, PosedDigit& posed) {
  if (!program.cell_moves) {
    *posed.cell = constant_matrix(program.still_cell);
    return;
  }
  // Compute the tilt of the cell, and the rotation from the tip's axes to those of the components.
  const Tilt tilt = tilt_of(vector_at(digit.number + program.sensor_tilt));
  *posed.cell = constant_matrix(program.components) * tilt.Q;
  if (program.force_link != program.tip_link)
    *posed.cell = *posed.cell * (transposed(stated_axes(program, posed)) * *posed.axes);
}

/// Adjoint of set_load_cell().
inline void adjoint_load_cell(const Program& program, const DigitParameters& digit,
                              const PosedDigit& posed, const Mat& cell_bar, Wrenches& on,
                              DigitParameters& adjoint_digit) {
  if (!program.cell_moves) return;
  // Differentiate by the tilt, the last factor of the product.
  const Tilt tilt = tilt_of(vector_at(digit.number + program.sensor_tilt));
  const Mat components = constant_matrix(program.components);
  Mat tilted_bar = cell_bar;
  if (program.force_link != program.tip_link) {
    // Differentiate by the links, with which both sets of axes rotate.
    const Mat stated = stated_axes(program, posed);
    const Mat between = transposed(stated) * *posed.axes;
    const Mat between_bar = transposed(components * tilt.Q) * cell_bar;
    tilted_bar = cell_bar * transposed(between);
    const auto felt = [](const Mat& a, const Mat& a_bar) {
      return cross(a.x, a_bar.x) + cross(a.y, a_bar.y) + cross(a.z, a_bar.z);
    };
    on.moment[program.tip_link] += felt(*posed.axes, stated * between_bar);
    if (program.force_link >= 0)
      on.moment[program.force_link] += felt(stated, *posed.axes * transposed(between_bar));
  }
  add_vector(adjoint_digit.number + program.sensor_tilt,
             adjoint_tilt(tilt, transposed(components) * tilted_bar));
}

}  // namespace

// Step 6: forces of all trials of a posture from their torques.
namespace {

/// Returns the torque of a trial about joint j, computed or constant [N m].
inline V torque_of(const Program& program, const PostureStep& posture, const PosedDigit& posed,
                   int trial, int j) {
  return program.arms_move ? posed.torque[(trial - posture.first_trial) * program.coordinates + j]
                           : splat(program.still_torque[trial * program.coordinates + j]);
}

/// Returns the tip force per torque about joint j, from rows of P; in the plane of flexion the
/// radial component is zero.
inline Vec tip_force_of(const Program& program, const V* P, int j) {
  const int n = program.coordinates;
  return {P[j], P[n + j], program.tip_forces == 3 ? P[2 * n + j] : V{}};
}

/// Returns the sum over the muscles of a trial of  tension unexplained [N].
inline Vec unexplained_force(const Program& program, const DigitParameters& digit, int trial) {
  Vec f = {V{}, V{}, V{}};
  const TrialStep& step = program.trial_steps[trial];
  for (int t = step.first; t < step.last; ++t) {
    const TensionStep& pull = program.pulls[t];
    f += splat(pull.tension) * vector_at(digit.number + program.unexplained + 3 * pull.muscle);
    if (pull.own_force >= 0) f += splat(pull.tension) * vector_at(digit.number + pull.own_force);
  }
  return f;
}

/// Computes map = cell (rows of P that are forces) and force = map torque + cell unexplained.
inline void set_forces(const Program& program, int k, const DigitParameters& digit,
                       PosedDigit& posed, V* force) {
  // Compute the force components per joint torque.
  const int n = program.coordinates;
  const Mat cell = *posed.cell;
  const V* P = posed.inverse;
  V* map = posed.map;
  for (int j = 0; j < n; ++j) {
    const Vec f = cell * tip_force_of(program, P, j);
    map[j] = f.x, map[n + j] = f.y, map[2 * n + j] = f.z;
  }
  // Compute the forces of each trial of the posture.
  const PostureStep& posture = program.postures[k];
  for (int i = posture.first_trial; i < posture.last_trial; ++i) {
    Vec f = {V{}, V{}, V{}};
    for (int j = 0; j < n; ++j) {
      const V torque = torque_of(program, posture, posed, i, j);
      f += torque * Vec{map[j], map[n + j], map[2 * n + j]};
    }
    if (program.unexplained_moves) f += cell * unexplained_force(program, digit, i);
    V* out = force + 3 * program.trial_steps[i].column;
    out[0] = f.x, out[1] = f.y, out[2] = f.z;
  }
}

/// Adjoint of the unexplained forces:  tension cell' force_bar  for each muscle, and their
/// contribution to cell_bar.
// NOLINTNEXTLINE(readability-function-size): an adjoint takes the arguments, results and adjoints
inline void adjoint_unexplained(const Program& program, int trial, const DigitParameters& digit,
                                const PosedDigit& posed, const Vec& force_bar,
                                DigitParameters& adjoint_digit, Mat& cell_bar) {
  const Vec push = turned_back(*posed.cell, force_bar);
  const TrialStep& step = program.trial_steps[trial];
  for (int t = step.first; t < step.last; ++t) {
    const TensionStep& pull = program.pulls[t];
    const Vec by_force = splat(pull.tension) * push;
    add_vector(adjoint_digit.number + program.unexplained + 3 * pull.muscle, by_force);
    if (pull.own_force >= 0) add_vector(adjoint_digit.number + pull.own_force, by_force);
  }
  if (!program.cell_moves) return;
  const Vec f = unexplained_force(program, digit, trial);
  cell_bar.x += f.x * force_bar;
  cell_bar.y += f.y * force_bar;
  cell_bar.z += f.z * force_bar;
}

/// Adjoint of set_forces():  torque_bar = map' force_bar,  map_bar = sum force_bar torque',  and
/// from it P_bar = cell' map_bar and cell_bar = map_bar P'.
// NOLINTNEXTLINE(readability-function-size): an adjoint takes the arguments, results and adjoints
inline Mat adjoint_forces(const Program& program, int k, const DigitParameters& digit,
                          const PosedDigit& posed, const V* force_bar, PosedDigit& adjoint,
                          DigitParameters& adjoint_digit) {
  // Pass adjoints from forces of the trials to the map and the torques.
  const int n = program.coordinates;
  const V *P = posed.inverse, *map = posed.map;
  Mat cell_bar = constant_matrix(kIdentity);
  cell_bar.x = cell_bar.y = cell_bar.z = {V{}, V{}, V{}};
  const PostureStep& posture = program.postures[k];
  for (int i = posture.first_trial; i < posture.last_trial; ++i) {
    const Vec push = vector_at(force_bar + 3 * program.trial_steps[i].column);
    for (int j = 0; j < n; ++j) {
      const V torque = torque_of(program, posture, posed, i, j);
      adjoint.map[j] += torque * push.x;
      adjoint.map[n + j] += torque * push.y;
      adjoint.map[2 * n + j] += torque * push.z;
      if (program.arms_move)
        adjoint.torque[(i - posture.first_trial) * n + j] =
            dot(push, Vec{map[j], map[n + j], map[2 * n + j]});
    }
    if (program.unexplained_moves)
      adjoint_unexplained(program, i, digit, posed, push, adjoint_digit, cell_bar);
  }
  // Pass adjoints from the map to the pseudo-inverse, and to the cell if it moves.
  for (int j = 0; j < n; ++j) {
    const Vec map_bar = {adjoint.map[j], adjoint.map[n + j], adjoint.map[2 * n + j]};
    const Vec push = turned_back(*posed.cell, map_bar);
    adjoint.inverse[j] = push.x, adjoint.inverse[n + j] = push.y;
    if (program.tip_forces == 3) adjoint.inverse[2 * n + j] = push.z;
    if (!program.cell_moves) continue;
    const Vec f = tip_force_of(program, P, j);
    cell_bar.x += f.x * map_bar;
    cell_bar.y += f.y * map_bar;
    cell_bar.z += f.z * map_bar;
  }
  return cell_bar;
}

}  // namespace
}  // namespace thenar::kernel
