#pragma once

/// Force model of one digit in one experiment as flat lists of steps. Contains plain numbers only,
/// so that sources compiled for different processors can share it.

#include <utility>
#include <vector>

namespace thenar::kernel {

/// Constant array. Element access is always inlined: otherwise the linker might choose a copy of
/// the function that was compiled for another processor.
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

/// Linear term:  number[i] += weight u[coordinate].
struct LinearTerm {
  int number, coordinate;
  double weight;
};

/// Angle of the posture:  ratio q[coordinate] + offset;  coordinate -1: constant.
struct AngleStep {
  int coordinate;
  double ratio, offset;
};

/// Hinge; parents precede their children.
struct HingeStep {
  int parent;            // index of the parent hinge; -1: the base
  int coordinate;        // entry of q
  double ratio, offset;  // angle = ratio q + offset
  int direction, point;  // index of the first of their three numbers
  bool tilts, shifts;    // some coordinate moves the direction, or the point
};

/// Point of a tendon path.
struct NodeStep {
  int link;   // index of the link; -1: the base
  int place;  // index of the first of its three numbers
};

/// Contribution of a straight run of tendon to the arm about one hinge:  weight u . (axis x (node -
/// point)).
struct ArmTerm {
  int hinge;
  int node;
  int arm;        // entry of the arms (strands, coordinates)
  double weight;  // ratio of the hinge; negative if the end of the run is the distal one
};

/// Straight run of a tendon between two links, with direction u.
struct RunStep {
  int from, to;     // indices of its nodes
  int first, last;  // range of its arm_terms
};

/// Bend of the sheaths, which lowers the tension at all coordinates from first_coordinate_beyond
/// on.
struct BendStep {
  AngleStep angle;
  int first_coordinate_beyond;
};

/// Strand with friction.
struct SheathStep {
  int strand;
  int friction;  // index of its friction coefficient
};

/// Indices of the strands of the hood.
struct HoodSteps {
  int central_slip, radial_band, ulnar_band, terminal_slip;
};

/// Share of a muscle in the hood.
struct ShareStep {
  int muscle;
  double radial;         // fraction of the lateral share that the radial band carries [1]
  double into, central;  // fractions before parameters shift them [1]
  int into_shift, central_shift, slope;  // indices of the shifts and the slope
};

/// Tension of a muscle in a trial.
struct TensionStep {
  int muscle;
  double tension;  // [N]
  int own_force;   // index of the first of the three numbers of the force added in this posture
                   // only; -1: none
};

/// Trial with the tensions of its muscles.
struct TrialStep {
  int column;       // column of the forces
  int first, last;  // range of its pulls
};

/// Posture with its trials.
struct PostureStep {
  int first_trial, last_trial;
  int own_error;  // index of the first of its own angle errors; -1: none
};

/// Sine and cosine of a hinge's angle in a posture, if the angle is constant.
struct StillAngle {
  bool still;
  double sine, cosine;
};

/// Steps of the force model, and the numbers that they use.
struct Program {
  int coordinates = 0;      // entries of q
  int fit_coordinates = 0;  // entries of u
  int trials = 0;
  int loads = 0;       // number of columns of tip_constraint_loads()
  int tip_forces = 3;  // number of forces among the loads: 3, or 2 in the plane of flexion

  Array<double> start;      // numbers at u = 0
  Array<LinearTerm> moves;  // terms by which u changes the numbers

  Array<HingeStep> hinges;
  Array<PostureStep> postures;
  Array<double> q;                 // angles of each posture [rad] (postures, coordinates)
  Array<StillAngle> still_angles;  // constant angles (postures, hinges)
  int angle_error = 0;             // index of the first angle error

  bool arms_move = false;  // some coordinate changes the arms; false: the torques are still_torque
  Array<double>
      still_torque;  // constant torques; trials ordered by posture [N m] (trials, coordinates)
  int strands = 0;
  int arms = 0;  // index of the first constant arm (strands, coordinates)
  Array<NodeStep> nodes;
  Array<RunStep> runs;
  Array<ArmTerm> arm_terms;
  Array<int> path_strands;  // strands whose arms are computed from their paths
  Array<BendStep> bends;
  Array<SheathStep> sheaths;
  HoodSteps hood{};
  AngleStep knuckle{};
  double hood_angle = 0;  // knuckle angle at which the fractions are stated [rad]
  Array<ShareStep> shares;
  Array<int> pulls_strand;         // strand that each muscle pulls
  bool unexplained_moves = false;  // the unexplained forces can be nonzero
  int unexplained = 0;             // index of the first muscle's three unexplained forces
  int gain = 0;                    // index of the first gain
  Array<TensionStep> pulls;
  Array<TrialStep> trial_steps;  // trials ordered by posture

  int tip_link = 0;
  int tip = 0;              // index of the tip's three coordinates
  Array<int> tip_hinges;    // hinges from the tip to the base
  double tip_axes[9] = {};  // columns proximal, dorsal, radial
  int out_of_plane = 0;     // index of the length of out-of-plane moments
  double hold_length = 0;   // length that scales flexion moments [m]

  bool cell_moves =
      false;  // false: the constant still_cell maps components of the tip to those of the cell
  double still_cell[9] = {};  // column-major
  int sensor_tilt = 0;        // index of the first of three numbers
  int force_link = 0;
  double components[9] = {};  // column-major
};

}  // namespace thenar::kernel
