#pragma once

/// Bed of springs over a pad's own skin, pressed by any rigid object, with friction and relaxation.

#include <vector>

#include <Eigen/Core>

#include "base/spatial.h"
#include "geometry/shape.h"
#include "pad_laws/elastic_foundation.h"

namespace thenar {

/// Spring columns of a pad, each under a piece of its skin, in the pad's frame.
struct FoundationColumns {
  Eigen::Matrix3Xd skin;      // middle of the piece of skin [m] (3, columns)
  Eigen::Matrix3Xd normal;    // outward normal of the skin, unit (3, columns)
  Eigen::VectorXd thickness;  // thickness of the soft tissue [m] (columns)
  Eigen::VectorXd area;       // area of the piece of skin [m^2] (columns)
};

/// State of a bed, the history of each column. Empty: untouched.
struct BedState {
  Eigen::VectorXd elastic;       // elastic normal force, as if nothing relaxed [N] (columns)
  Eigen::MatrixXd terms;         // its history terms [N] (terms, columns)
  Eigen::Matrix3Xd shear;        // elastic friction on the skin [N] (3, columns)
  Eigen::MatrixXd shear_terms;   // its history terms [N] (3 terms, columns)
  Eigen::Matrix3Xd anchor;       // sticking point of the object, object's frame [m] (3, columns)
  Eigen::VectorXd normal_force;  // normal force at the last step [N] (columns)
  Eigen::Matrix3Xd shear_force;  // friction on the skin at the last step [N] (3, columns)
  std::vector<bool> touching;    // contact at the last step (columns)
  std::vector<bool> remembers;   // contact, or a history term above 1e-12 N (columns)
};

/// Contact of a bed with an object.
struct BedContact {
  Wrench push;         // wrench of the object on the pad, about the pad's origin
  double force = 0;    // sum of normal forces [N]
  double depth = 0;    // largest overlap of the undeformed skin; 0: apart [m]
  double gap = 0;      // lower bound of the distance of columns to the object; 0: touches [m]
  double area = 0;     // area of the patch [m^2]
  double torsion = 0;  // largest torque about the mean normal per normal force: mu times the mean
                       // distance from the centre of pressure [m]
  double aspect = 1;   // ratio of semi-axes by second moments of the pressure, >= 1 [1]
  double strain = 0;   // largest delta / h [1]
  double energy = 0;   // energy of a plain bed, as if nothing relaxed [J]
  double stick = 0;    // share of the normal force on sticking columns [1]
  Eigen::Vector3d centre{0, 0, 0};  // centre of pressure [m] (3)
  Eigen::Vector3d normal{0, 0, 0};  // mean direction of the normal forces, unit (3)
  bool behind = false;  // a column is beyond the middle of a thin object, whose far side pulls it
                        // outward: the contact is invalid
};

/// Bed of spring columns; immutable. Springs push along the object's normal by their overlap with
/// it. For a plain bed (spread 1, surround 0) the force is the negative gradient of an energy.
class FoundationBed {
 public:
  /// Builds a bed. `constants.thickness` is not used: each column has its own.
  /// @throws InputError unless columns agree in number, thicknesses and areas are positive and
  /// normals unit, all finite; and as check_foundation() and check_exponential_terms().
  FoundationBed(FoundationColumns columns, const FoundationConstants& constants,
                std::vector<ExponentialTerm> terms = {});

  /// Computes an instant press from rest without friction; `friction` affects the torsion alone.
  /// @param X_PO  pose of the object in the pad's frame
  /// @throws InputError unless the pose is finite, and friction finite and >= 0.
  [[nodiscard]] BedContact press(const Shape& object, const Pose<double>& X_PO,
                                 double friction = 0) const;

  /// Computes one time step, exactly if elastic forces are linear in time. A column sticks to the
  /// point of the object that it touched first, with friction G / h times area times displacement.
  /// Once that exceeds the friction cone, the column slips and its friction stays on the cone.
  /// @param seconds  duration of the step; 0: nothing relaxes [s]
  /// @throws InputError as press(), if seconds < 0, or the state is of another bed.
  [[nodiscard]] BedContact step(const Shape& object, const Pose<double>& X_PO, double friction,
                                double seconds, BedState& state) const;

  /// Returns the columns in the order of the state.
  [[nodiscard]] const FoundationColumns& columns() const { return columns_; }
  [[nodiscard]] const FoundationConstants& constants() const { return constants_; }
  [[nodiscard]] const std::vector<ExponentialTerm>& relaxation() const { return terms_; }

 private:
  /// Consecutive columns within a bounding ball.
  struct Leaf {
    Eigen::Vector3d centre;
    double radius;
    Eigen::Index first, end;
  };
  /// A column that the object presses.
  struct Touch {
    Eigen::Index column;
    double delta;            // compression of its spring; below 0: apart [m]
    Eigen::Vector3d normal;  // outward normal of the object, direction of its push, unit (3)
  };
  struct Touches {
    std::vector<Touch> columns;
    double deepest = 0;         // largest overlap [m]
    double gap = 0;             // BedContact::gap [m]
    double area = 0;            // area of the patch [m^2]
    double surround_share = 0;  // c / r of FoundationConstants [1/m]
  };
  void split(std::vector<Eigen::Index>& order, Eigen::Index first, Eigen::Index end);
  [[nodiscard]] Touches touches(const Shape& object, const Pose<double>& X_PO) const;
  [[nodiscard]] double area_share(const Touch& touch) const;
  struct StepInputs {
    Pose<double> X_PO, X_OP;
    double friction;
    MemoryStep weights;
  };
  struct ColumnFriction {
    Eigen::Vector3d elastic;         // friction as if nothing relaxed [N] (3)
    Eigen::Vector3d force{0, 0, 0};  // friction on the skin [N] (3)
    bool sticks = false;
  };
  void initialize(BedState& state) const;
  /// Computes one step of a column.
  /// @param elastic  force of its spring as if nothing relaxed [N]
  /// @param n  outward normal of the object, unit (3)
  /// @return whether the column sticks
  bool move_column(Eigen::Index i, double elastic, const Eigen::Vector3d& n,
                   const StepInputs& inputs, BedState& state) const;
  /// Computes the friction of a touching column. Sets its anchor at first touch, and moves it if
  /// the column slips.
  /// @param force  normal force [N]
  /// @param past  friction of the history [N] (3)
  [[nodiscard]] ColumnFriction stick_or_slip(Eigen::Index i, const Eigen::Vector3d& n, double force,
                                             Eigen::Vector3d past, const StepInputs& inputs,
                                             BedState& state) const;
  void sum_contact(const Touches& found, const Eigen::VectorXd& forces, double friction,
                   BedContact& contact) const;

  FoundationColumns columns_;
  FoundationConstants constants_;
  std::vector<ExponentialTerm> terms_;
  std::vector<Leaf> leaves_;
  Eigen::VectorXd width_;  // root of the area of each column [m] (columns)
  double reach_ = 0;       // gap up to which a column may count for the area of the patch [m]
};

}  // namespace thenar
