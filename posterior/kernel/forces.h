#pragma once

/// Step 6: forces of all trials of a posture from their torques.

#include "posterior/kernel/tape.h"

namespace thenar::kernel {
namespace {

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

}  // namespace
}  // namespace thenar::kernel
