#pragma once

/// Tape of a run: all intermediate results that its adjoint needs, and the adjoints themselves.

#include "kinematics_fit/kernel/program.h"
#include "kinematics_fit/kernel/simd.h"

namespace thenar::kernel {
namespace {

/// Allocates consecutive parts of a block of memory; without a block it only counts their size.
class BumpAllocator {
 public:
  explicit BumpAllocator(V* first) : first_(first) {}
  template <typename T>
  T* take(int count) {
    T* part = first_ == nullptr ? nullptr : reinterpret_cast<T*>(first_ + used_);
    // NOLINTNEXTLINE(bugprone-sizeof-expression): T and V are no pointers
    used_ += count * static_cast<long>(sizeof(T) / sizeof(V));
    return part;
  }
  [[nodiscard]] long used() const { return used_; }

 private:
  V* first_;
  long used_ = 0;
};

/// Numbers of the digit, common to all postures.
struct DigitParameters {
  V* number;       // all numbers; axis directions are not normalised
  Vec* direction;  // unit directions of axes (hinges)
  V* shrink;       // 1 / length of the directions before normalisation (hinges)

  DigitParameters(const Program& program, BumpAllocator& bump)
      : number(bump.take<V>(program.start.size())),
        direction(bump.take<Vec>(program.hinges.size())),
        shrink(bump.take<V>(program.hinges.size())) {}
};

/// Intermediate results of one posture; their adjoints have the same shapes.
struct Posed {
  V* angle;           // joint angles with errors [rad] (coordinates)
  V *sine, *cosine;   // (hinges)
  Mat* R;             // orientation of each link (hinges)
  Vec *axis, *point;  // axis and point of each hinge in the posture (hinges)

  Vec* node;            // positions of path points in the posture [m]
  Vec* run;             // unit directions of runs
  V* length;            // 1 / length of each run [1/m]
  V* frictionless_arm;  // arms of strands without friction (strands, coordinates)
  V* tension_ratio;     // tension over tension at the muscle [1] (strands, coordinates)
  V* arm;               // arms with friction (strands, coordinates)
  V* bent;              // sum of bends (coordinates) [rad]
  V *into, *central;    // fractions into the hood and to the central slip (shares)
  V* row;               // arms of muscles (muscles, coordinates)
  V* torque;            // (trials of the posture, coordinates) [N m]

  Vec* tip;    // position of the tip [m]
  Mat* axes;   // proximal, dorsal and radial direction of the tip
  V* load;     // tip_constraint_loads() (coordinates, loads)
  V* inverse;  // pseudo-inverse of `load` (loads, coordinates)
  Mat* cell;   // map from the tip's force components to the cell's
  V* map;      // forces per torque (3, coordinates)

  Posed(const Program& p, const PostureStep& posture, BumpAllocator& bump) {
    const int n = p.coordinates, hinges = p.hinges.size();
    // Angles and poses.
    angle = bump.take<V>(n);
    sine = bump.take<V>(hinges), cosine = bump.take<V>(hinges);
    R = bump.take<Mat>(hinges);
    axis = bump.take<Vec>(hinges), point = bump.take<Vec>(hinges);
    // Arms, if they move.
    if (p.arms_move) {
      node = bump.take<Vec>(p.nodes.size());
      run = bump.take<Vec>(p.runs.size());
      length = bump.take<V>(p.runs.size());
      frictionless_arm = bump.take<V>(p.strands * n), tension_ratio = bump.take<V>(p.strands * n);
      arm = bump.take<V>(p.strands * n);
      bent = bump.take<V>(n);
      into = bump.take<V>(p.shares.size()), central = bump.take<V>(p.shares.size());
      row = bump.take<V>(p.pulls_strand.size() * n);
    }
    // Torques, loads and forces.
    torque = bump.take<V>(p.arms_move ? (posture.last_trial - posture.first_trial) * n : 0);
    tip = bump.take<Vec>(1);
    axes = bump.take<Mat>(1);
    load = bump.take<V>(n * p.loads), inverse = bump.take<V>(n * p.loads);
    cell = bump.take<Mat>(1);
    map = bump.take<V>(3 * n);
  }
};

/// Forces and moments on each link, accumulated by the adjoint of one posture as in statics.
struct Wrenches {
  Vec* force;   // forces on points of the link: adjoints of their positions (hinges)
  Vec* moment;  // their moments about the hinge's point, and adjoints of directions of the link
                // (hinges)

  Wrenches(const Program& program, BumpAllocator& bump)
      : force(bump.take<Vec>(program.hinges.size())),
        moment(bump.take<Vec>(program.hinges.size())) {}
};

/// Sets registers to zero.
inline void clear(V* from, long count) {
  for (long i = 0; i < count; ++i) from[i] = V{};
}

}  // namespace
}  // namespace thenar::kernel
