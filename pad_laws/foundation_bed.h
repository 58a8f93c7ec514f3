#pragma once

/// A bed of springs over a pad's own skin, pressed by any rigid object, with friction and
/// relaxation.

#include <vector>

#include <Eigen/Core>

#include "base/spatial.h"
#include "geometry/shape.h"
#include "pad_laws/elastic_foundation.h"

namespace thenar {

/// Springs of a pad, each a piece of its skin. Frame: the pad's.
struct FoundationColumns {
  Eigen::Matrix3Xd skin;      // middle of the piece [m] (3, columns)
  Eigen::Matrix3Xd normal;    // of the skin, outward, unit (3, columns)
  Eigen::VectorXd thickness;  // of what is below [m] (columns)
  Eigen::VectorXd area;       // [m^2] (columns)
};

/// State of a bed, the memory of each column. Empty: untouched.
struct BedState {
  Eigen::VectorXd elastic;       // normal force if nothing relaxed [N] (columns)
  Eigen::MatrixXd terms;         // of its relaxation [N] (terms, columns)
  Eigen::Matrix3Xd shear;        // friction on the skin if nothing relaxed [N] (3, columns)
  Eigen::MatrixXd shear_terms;   // of its relaxation [N] (3 terms, columns)
  Eigen::Matrix3Xd anchor;       // where skin sticks, in the object's frame [m] (3, columns)
  Eigen::VectorXd normal_force;  // at the last step [N] (columns)
  Eigen::Matrix3Xd shear_force;  // the same of friction on the skin [N] (3, columns)
  std::vector<bool> touching;    // at the last step (columns)
  std::vector<bool> remembers;   // any force above 1e-12 N (columns)
};

/// A bed under an object.
struct BedContact {
  Wrench push;         // of the object on the pad, about the pad's origin
  double force = 0;    // sum of normal forces [N]
  double depth = 0;    // deepest overlap of the undeformed skin; 0: apart [m]
  double gap = 0;      // apart, the columns are at least so far from the object [m]
  double area = 0;     // of the patch [m^2]
  double torsion = 0;  // largest torque about the mean normal per normal force: mu times the mean
                       // distance from the centre of pressure [m]
  double aspect = 1;   // ratio of semi-axes by second moments of the pressure, >= 1 [1]
  double strain = 0;   // largest delta / h [1]
  double energy = 0;   // of a plain bed, if nothing relaxed [J]
  double stick = 0;    // share of the normal force on columns that stick [1]
  Eigen::Vector3d centre{0, 0, 0};  // of pressure [m] (3)
  Eigen::Vector3d normal{0, 0, 0};  // mean direction of the push, unit (3)
  bool behind = false;  // a column is beyond the middle of a thin object, whose far side pulls it
                        // outward: the answer means nothing
};

/// Columns under springs; constant. Springs push along the object's normal by their overlap with
/// it, which for a plain bed (spread 1, surround 0) is minus the gradient of an energy.
class FoundationBed {
 public:
  /// `constants.thickness` is not used: columns have theirs.
  /// @throws InputError unless columns agree in number, thicknesses and areas are positive and
  /// normals unit, all finite; and as check_foundation() and check_exponential_terms().
  FoundationBed(FoundationColumns columns, const FoundationConstants& constants,
                std::vector<ExponentialTerm> terms = {});

  /// A press at once from rest without friction; `friction` is for the torsion alone.
  /// @param X_PO  of the object in the pad's frame
  /// @throws InputError unless the pose is finite, and friction finite and >= 0.
  [[nodiscard]] BedContact press(const Shape& object, const Pose<double>& X_PO,
                                 double friction = 0) const;

  /// One step of time, exact where elastic forces run straight in it. A column sticks to the object
  /// where it touched, its friction G / h times its area times the way, until that exceeds the cone
  /// of its normal force; then it slips and stays at the cone.
  /// @param seconds  of the step; 0: nothing relaxes
  /// @throws InputError as press(), if seconds < 0, or the state is of another bed.
  [[nodiscard]] BedContact step(const Shape& object, const Pose<double>& X_PO, double friction,
                                double seconds, BedState& state) const;

  /// d push / d motion of the object, both moment and turn first, about the pad's origin, in
  /// press(): by central differences.
  /// @param step  of motions; turns are as large at a lever of 10 mm [m]
  /// @throws InputError as press(), or unless the step is positive and finite.
  [[nodiscard]] Eigen::Matrix<double, 6, 6> stiffness(const Shape& object, const Pose<double>& X_PO,
                                                      double step = 1e-6) const;

  /// Returns the columns, in the order of the state.
  [[nodiscard]] const FoundationColumns& columns() const { return columns_; }
  [[nodiscard]] const FoundationConstants& constants() const { return constants_; }
  [[nodiscard]] const std::vector<ExponentialTerm>& relaxation() const { return terms_; }

 private:
  /// Columns that lie together.
  struct Leaf {
    Eigen::Vector3d centre;
    double radius;
    Eigen::Index first, end;
  };
  /// A column that the object presses.
  struct Touch {
    Eigen::Index column;
    double delta;            // of its spring, at first the overlap; below 0: apart [m]
    Eigen::Vector3d normal;  // of the object, outward: along its push (3)
  };
  struct Touches {
    std::vector<Touch> all;
    double deepest = 0;  // overlap [m]
    double gap = 0;      // as BedContact [m]
    double area = 0;     // of the patch [m^2]
    double stiffer = 0;  // c / r of FoundationConstants [1/m]
  };
  void split(std::vector<Eigen::Index>& order, Eigen::Index first, Eigen::Index end);
  [[nodiscard]] Touches touches(const Shape& object, const Pose<double>& X_PO) const;
  [[nodiscard]] double share_of_area(const Touch& touch) const;
  struct StepInputs {
    Pose<double> X_PO, X_OP;
    double friction;
    MemoryStep weights;
  };
  void begin(BedState& state) const;
  /// One step of a column. @param elastic  force of its spring if nothing relaxed [N]
  /// @param n  of the object, outward (3)  @return whether it sticks
  bool move_column(Eigen::Index i, double elastic, const Eigen::Vector3d& n,
                   const StepInputs& inputs, BedState& state) const;
  void conclude(const Touches& found, const Eigen::VectorXd& forces, double friction,
                BedContact& contact) const;

  FoundationColumns columns_;
  FoundationConstants constants_;
  std::vector<ExponentialTerm> terms_;
  std::vector<Leaf> leaves_;
  Eigen::VectorXd width_;  // root of their areas [m] (columns)
  double reach_ = 0;       // how far apart a column may be and still count for the area [m]
};

}  // namespace thenar
