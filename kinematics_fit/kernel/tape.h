#pragma once

/// Tape of a run: all intermediate results that its adjoint needs, and the adjoints themselves.

#include "kinematics_fit/kernel/program.h"
#include "kinematics_fit/kernel/simd.h"

namespace thenar::kernel {
namespace {

/// Allocates parts of one block of memory; without a block it only counts.
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

/// Numbers of the digit, the same in all postures.
struct DigitParameters {
  V* number;       // all of them, axis directions not of unit length
  Vec* direction;  // of unit length (hinges)
  V* shrink;       // 1 / length before (hinges)

  DigitParameters(const Program& program, BumpAllocator& bump)
      : number(bump.take<V>(program.start.size())),
        direction(bump.take<Vec>(program.hinges.size())),
        shrink(bump.take<V>(program.hinges.size())) {}
};

/// Intermediate results of one posture; the adjoints have the same shapes.
struct Posed {
  V* angle;           // [rad] (coordinates)
  V *sine, *cosine;   // (hinges)
  Mat* R;             // of each link (hinges)
  Vec *axis, *point;  // of each hinge in the posture (hinges)

  Vec* node;            // points of paths in the posture [m]
  Vec* run;             // unit directions of runs
  V* length;            // 1 / length of each run [1/m]
  V* frictionless_arm;  // arms of strands without friction (strands, coordinates)
  V* tension_ratio;     // tension over that at the muscle [1] (strands, coordinates)
  V* arm;               // their product (strands, coordinates)
  V* bent;              // sum of bends (coordinates) [rad]
  V *into, *central;    // fractions (shares)
  V* row;               // arms of muscles (muscles, coordinates)
  V* torque;            // (trials of the posture, coordinates) [N m]

  Vec* tip;    // one
  Mat* axes;   // proximal, dorsal, radial of the tip: one
  V* load;     // tip_constraint_loads() (coordinates, loads)
  V* inverse;  // its pseudo-inverse (loads, coordinates)
  Mat* cell;   // the cell's components from the tip's: one
  V* map;      // forces per torque (3, coordinates)

  Posed(const Program& p, const PostureStep& posture, BumpAllocator& bump) {
    const int n = p.coordinates, hinges = p.hinges.size();
    // Pose.
    angle = bump.take<V>(n);
    sine = bump.take<V>(hinges), cosine = bump.take<V>(hinges);
    R = bump.take<Mat>(hinges);
    axis = bump.take<Vec>(hinges), point = bump.take<Vec>(hinges);
    // Arms, where they move.
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

/// Forces and moments on each link that the adjoint of one posture sums up, as in statics.
struct Wrenches {
  Vec* force;   // on points of the link: adjoints of their places (hinges)
  Vec* moment;  // of those about the hinge's point, and on directions of the link (hinges)

  Wrenches(const Program& program, BumpAllocator& bump)
      : force(bump.take<Vec>(program.hinges.size())),
        moment(bump.take<Vec>(program.hinges.size())) {}
};

inline void clear(V* from, long count) {
  for (long i = 0; i < count; ++i) from[i] = V{};
}

}  // namespace
}  // namespace thenar::kernel
