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
  T* allocate(int count) {
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
      : number(bump.allocate<V>(program.start.size())),
        direction(bump.allocate<Vec>(program.hinges.size())),
        shrink(bump.allocate<V>(program.hinges.size())) {}
};

/// Intermediate results of one posture; their adjoints have the same shapes.
struct PosedDigit {
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

  PosedDigit(const Program& p, const PostureStep& posture, BumpAllocator& bump) {
    const int n = p.coordinates, hinges = p.hinges.size();
    // Angles and poses.
    angle = bump.allocate<V>(n);
    sine = bump.allocate<V>(hinges), cosine = bump.allocate<V>(hinges);
    R = bump.allocate<Mat>(hinges);
    axis = bump.allocate<Vec>(hinges), point = bump.allocate<Vec>(hinges);
    // Arms, if they move.
    if (p.arms_move) {
      node = bump.allocate<Vec>(p.nodes.size());
      run = bump.allocate<Vec>(p.runs.size());
      length = bump.allocate<V>(p.runs.size());
      frictionless_arm = bump.allocate<V>(p.strands * n),
      tension_ratio = bump.allocate<V>(p.strands * n);
      arm = bump.allocate<V>(p.strands * n);
      bent = bump.allocate<V>(n);
      into = bump.allocate<V>(p.shares.size()), central = bump.allocate<V>(p.shares.size());
      row = bump.allocate<V>(p.pulls_strand.size() * n);
    }
    // Torques, loads and forces.
    torque = bump.allocate<V>(p.arms_move ? (posture.last_trial - posture.first_trial) * n : 0);
    tip = bump.allocate<Vec>(1);
    axes = bump.allocate<Mat>(1);
    load = bump.allocate<V>(n * p.loads), inverse = bump.allocate<V>(n * p.loads);
    cell = bump.allocate<Mat>(1);
    map = bump.allocate<V>(3 * n);
  }
};

/// Forces and moments on each link, accumulated by the adjoint of one posture as in statics.
struct Wrenches {
  Vec* force;   // forces on points of the link: adjoints of their positions (hinges)
  Vec* moment;  // their moments about the hinge's point, and adjoints of directions of the link
                // (hinges)

  Wrenches(const Program& program, BumpAllocator& bump)
      : force(bump.allocate<Vec>(program.hinges.size())),
        moment(bump.allocate<Vec>(program.hinges.size())) {}
};

/// Sets registers to zero.
inline void clear(V* from, long count) {
  for (long i = 0; i < count; ++i) from[i] = V{};
}

}  // namespace
}  // namespace thenar::kernel
