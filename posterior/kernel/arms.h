#pragma once

/// Step 3a: moment arms of strands along their paths, and what friction leaves of them.

#include "posterior/kernel/pose.h"

namespace thenar::kernel {
namespace {

/// An angle of the posture.
inline V angle_at(const AngleStep& angle, const Posed& posed) {
  if (angle.coordinate < 0) return splat(angle.offset);
  return angle.ratio * posed.angle[angle.coordinate] + angle.offset;
}

/// Arms without friction: constant ones, or those of straight runs  u = (b - a) / |b - a|,
///   sum weight u . (axis x (node - point)).
inline void set_paths(const Program& program, const Numbers& digit, Posed& posed) {
  const int n = program.coordinates;
  for (int i = 0; i < program.strands * n; ++i) posed.bare[i] = digit.number[program.arms + i];
  for (const int s : program.path_strands) clear(posed.bare + s * n, n);
  for (int k = 0; k < program.nodes.size(); ++k)
    posed.node[k] = carried(program, digit, posed, program.nodes[k].link, program.nodes[k].place);
  for (int k = 0; k < program.runs.size(); ++k) {
    const RunStep& run = program.runs[k];
    const Vec way = posed.node[run.to] - posed.node[run.from];
    posed.length[k] = 1.0 / square_root(dot(way, way));
    const Vec u = posed.run[k] = posed.length[k] * way;
    for (int i = run.first; i < run.last; ++i) {
      const ClimbStep& climb = program.climbs[i];
      const Vec r = posed.node[climb.node] - posed.point[climb.hinge];
      posed.bare[climb.arm] += climb.weight * dot(u, cross(posed.axis[climb.hinge], r));
    }
  }
}

inline void pull_paths(const Program& program, const Posed& posed, Posed& bar, Wrenches& on,
                       Numbers& bar_digit) {
  const int n = program.coordinates;
  for (int k = 0; k < program.runs.size(); ++k) {
    const RunStep& run = program.runs[k];
    const Vec u = posed.run[k];
    Vec u_bar = {V{}, V{}, V{}};
    for (int i = run.first; i < run.last; ++i) {
      const ClimbStep& climb = program.climbs[i];
      const V g = climb.weight * bar.bare[climb.arm];
      const Vec axis = posed.axis[climb.hinge];
      const Vec r = posed.node[climb.node] - posed.point[climb.hinge];
      const Vec r_bar = g * cross(u, axis);
      u_bar += g * cross(axis, r);
      bar.axis[climb.hinge] += g * cross(r, u);
      bar.point[climb.hinge] -= r_bar;
      bar.node[climb.node] += r_bar;
    }
    const Vec way_bar = posed.length[k] * (u_bar - dot(u_bar, u) * u);
    bar.node[run.to] += way_bar;
    bar.node[run.from] -= way_bar;
  }
  for (int k = 0; k < program.nodes.size(); ++k)
    pull_carried(posed, program.nodes[k].link, program.nodes[k].place, posed.node[k], bar.node[k],
                 on, bar_digit);
  for (const int s : program.path_strands) clear(bar.bare + s * n, n);
  for (int i = 0; i < program.strands * n; ++i) bar_digit.number[program.arms + i] += bar.bare[i];
}

/// Size of a bend, smoothed as in bend_size().
inline V size_of(const BendStep& bend, const Posed& posed) {
  const V angle = angle_at(bend.angle, posed);
  return bend.angle.coordinate < 0 ? (angle < 0.0 ? -angle : angle)
                                   : square_root(angle * angle + 1e-4);
}

/// Is coordinate j the first to feel some bend?
inline bool bends_before(const Program& program, int j) {
  for (const BendStep& bend : program.bends)
    if (bend.felt_from == j) return true;
  return false;
}

/// arm = bare exp(-mu bent),  bent_j = sum of the bends nearer the muscle than coordinate j.
inline void set_friction(const Program& program, const Numbers& digit, Posed& posed) {
  const int n = program.coordinates;
  for (int i = 0; i < program.strands * n; ++i) posed.arm[i] = posed.bare[i];
  if (program.sheaths.size() == 0) return;
  clear(posed.bent, n);
  for (const BendStep& bend : program.bends) {
    const V size = size_of(bend, posed);
    for (int j = bend.felt_from; j < n; ++j) posed.bent[j] += size;
  }
  for (const SheathStep& sheath : program.sheaths)
    for (int j = 0; j < n; ++j) {
      const int i = sheath.strand * n + j;
      if (bends_before(program, j))
        posed.left[i] = exponential(-digit.number[sheath.friction] * posed.bent[j]);
      else
        posed.left[i] = j == 0 ? splat(1) : posed.left[i - 1];
      posed.arm[i] = posed.bare[i] * posed.left[i];
    }
}

inline void pull_friction(const Program& program, const Numbers& digit, const Posed& posed,
                          Posed& bar, Numbers& bar_digit) {
  const int n = program.coordinates;
  for (int i = 0; i < program.strands * n; ++i) bar.bare[i] = bar.arm[i];
  if (program.sheaths.size() == 0) return;
  for (const SheathStep& sheath : program.sheaths)
    for (int j = 0; j < n; ++j) {
      const int i = sheath.strand * n + j;
      bar.bare[i] = bar.arm[i] * posed.left[i];
      const V lost = bar.arm[i] * posed.arm[i];
      bar_digit.number[sheath.friction] -= lost * posed.bent[j];
      bar.bent[j] -= lost * digit.number[sheath.friction];
    }
  for (const BendStep& bend : program.bends) {
    if (bend.angle.coordinate < 0) continue;
    V size_bar = V{};
    for (int j = bend.felt_from; j < n; ++j) size_bar += bar.bent[j];
    bar.angle[bend.angle.coordinate] +=
        size_bar * bend.angle.ratio * angle_at(bend.angle, posed) / size_of(bend, posed);
  }
}

}  // namespace
}  // namespace thenar::kernel
