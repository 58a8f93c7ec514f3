#pragma once

/// The force model of one digit in one experiment as flat lists of steps. Plain numbers alone, so
/// that sources for different processors can share them.

#include <utility>
#include <vector>

namespace thenar::kernel {

/// A constant vector. Reading is always inlined: otherwise the linker might pick a copy of the
/// function that was compiled for another processor.
template <typename T>
class Array {
 public:
  explicit Array(std::vector<T> rows = {})
      : rows_(std::move(rows)), first_(rows_.data()), size_(static_cast<int>(rows_.size())) {}
  Array(const Array&) = delete;
  Array& operator=(const Array&) = delete;
  Array& operator=(std::vector<T> rows) {
    rows_ = std::move(rows);
    first_ = rows_.data();
    size_ = static_cast<int>(rows_.size());
    return *this;
  }
  ~Array() = default;

  [[nodiscard]] __attribute__((always_inline)) const T* begin() const { return first_; }
  [[nodiscard]] __attribute__((always_inline)) const T* end() const { return first_ + size_; }
  [[nodiscard]] __attribute__((always_inline)) const T& operator[](int i) const {
    return first_[i];
  }
  [[nodiscard]] __attribute__((always_inline)) int size() const { return size_; }

 private:
  std::vector<T> rows_;
  const T* first_;
  int size_;
};

/// number[i] += weight u[coordinate]
struct LinearTerm {
  int number, coordinate;
  double weight;
};

/// An angle of the posture:  ratio q[coordinate] + offset;  coordinate -1: frozen.
struct AngleStep {
  int coordinate;
  double ratio, offset;
};

/// A hinge, after its parent.
struct HingeStep {
  int parent;            // hinge; -1: the base
  int coordinate;        // entry of q
  double ratio, offset;  // angle = ratio q + offset
  int direction, point;  // index of their three numbers
  bool tilts, shifts;    // some coordinate moves direction, point
};

/// A point of a tendon path.
struct NodeStep {
  int link;   // -1: the base
  int place;  // index of its three numbers
};

/// Contribution of a run of tendon to the arm about one hinge:  weight u (axis x (node - point)).
struct ArmTerm {
  int hinge;
  int node;
  int arm;        // entry of the arms (strands, coordinates)
  double weight;  // ratio of the hinge; negative where the run's end is the further one out
};

/// A straight run of tendon between two links, u its direction.
struct RunStep {
  int from, to;     // nodes
  int first, last;  // of the arm_terms
};

/// A bend of the sheaths, which lowers the tension at all coordinates from first_coordinate_beyond
/// on.
struct BendStep {
  AngleStep angle;
  int first_coordinate_beyond;
};

/// A strand with friction.
struct SheathStep {
  int strand;
  int friction;  // index of its number
};

/// Strands of the hood.
struct HoodSteps {
  int central_slip, radial_band, ulnar_band, terminal_slip;
};

/// A muscle's share in the hood.
struct ShareStep {
  int muscle;
  double radial;                         // part of the lateral share that the radial band takes [1]
  double into, central;                  // fractions before they are shifted [1]
  int into_shift, central_shift, slope;  // indices of numbers
};

/// Tension of a muscle in a trial.
struct TensionStep {
  int muscle;
  double tension;  // [N]
  int own_force;   // index of the three numbers of the force that its posture alone adds; -1: none
};

/// One trial: the tensions of its muscles.
struct TrialStep {
  int column;       // of the forces
  int first, last;  // of the pulls
};

/// A posture and the trials in it.
struct PostureStep {
  int first_trial, last_trial;
  int own_error;  // index of the first of its own angle errors; -1: none
};

/// Sine and cosine of a hinge's angle in a posture, where no coordinate moves the angle.
struct StillAngle {
  bool still;
  double sine, cosine;
};

/// All steps, and the numbers that they use.
struct Program {
  int coordinates = 0;      // entries of q
  int fit_coordinates = 0;  // entries of u
  int trials = 0;
  int loads = 0;       // columns of tip_constraint_loads()
  int tip_forces = 3;  // of them forces: 3, or 2 in the plane of flexion

  Array<double> start;  // the numbers at u = 0
  Array<LinearTerm> moves;

  Array<HingeStep> hinges;
  Array<PostureStep> postures;
  Array<double> q;                 // (postures, coordinates) [rad]
  Array<StillAngle> still_angles;  // (postures, hinges)
  int angle_error = 0;             // index of the first angle error

  bool arms_move = false;      // false: the torques of all trials are still_torque
  Array<double> still_torque;  // (trials in the order below, coordinates) [N m]
  int strands = 0;
  int arms = 0;  // index of the constant arms (strands, coordinates)
  Array<NodeStep> nodes;
  Array<RunStep> runs;
  Array<ArmTerm> arm_terms;
  Array<int> path_strands;  // strands whose arms follow from their paths
  Array<BendStep> bends;
  Array<SheathStep> sheaths;
  HoodSteps hood{};
  AngleStep knuckle{};
  double hood_angle = 0;  // of the knuckle, at which shares are stated [rad]
  Array<ShareStep> shares;
  Array<int> pulls_strand;         // of each muscle
  bool unexplained_moves = false;  // or is not zero: forces beyond those of the geometry count
  int unexplained = 0;             // index of the first muscle's three numbers
  int gain = 0;                    // index of the first gain
  Array<TensionStep> pulls;
  Array<TrialStep> trial_steps;  // by posture

  int tip_link = 0;
  int tip = 0;              // index of three numbers
  Array<int> tip_hinges;    // from the tip to the base
  double tip_axes[9] = {};  // columns proximal, dorsal, radial
  int out_of_plane = 0;     // index
  double hold_length = 0;   // of flexion moments [m]

  bool cell_moves = false;    // false: still_cell maps the tip's components to the cell's
  double still_cell[9] = {};  // by columns
  int sensor_tilt = 0;        // index of three numbers
  int force_link = 0;
  double components[9] = {};  // by columns
};

}  // namespace thenar::kernel
