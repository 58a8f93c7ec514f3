#pragma once

/// Wrench sets whose epsilon and volume are known in closed form.

#include "grasp/contact/wrench_set.h"

namespace thenar {

using Axes = decltype(WrenchCap::A);

inline const WrenchCoordinates kHalfAxes =
    (WrenchCoordinates() << 1, 0.8, 0.6, 0.3, 0.25, 0.5).finished();

/// Explicit wrenches +-a_i e_i; those of one axis share a contact only with
/// themselves.
inline WrenchSet cross_polytope() {
  WrenchSet set;
  for (int i = 0; i < 6; ++i)
    for (const double sign : {1.0, -1.0})
      set.caps.push_back({(sign * kHalfAxes(i)) * ScaledWrench::unit(i), Axes(6, 0), -1});
  return set;
}

/// Seven unit vectors with inner products -1/6.
inline WrenchSet regular_simplex() {
  Eigen::Matrix<double, 6, 7> v = Eigen::Matrix<double, 6, 7>::Zero();
  for (int i = 0; i < 6; ++i) {
    v(i, i) = std::sqrt(1 - v.col(i).head(i).squaredNorm());
    for (int j = i + 1; j < 7; ++j)
      v(i, j) = (-1.0 / 6 - v.col(i).head(i).dot(v.col(j).head(i))) / v(i, i);
  }
  WrenchSet set;
  for (int j = 0; j < 7; ++j)
    set.caps.push_back({ScaledWrench::from_coordinates(v.col(j)), Axes(6, 0), -1});
  return set;
}

/// Contacts (+-a, +-a) on all faces of a cube of half side 1, torque scale 1.
inline WrenchSet cube_without_friction(double a) {
  std::vector<Contact> contacts;
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {1.0, -1.0})
      for (const double u : {a, -a})
        for (const double v : {a, -a}) {
          Contact contact;
          contact.p(axis) = side;
          contact.p((axis + 1) % 3) = u;
          contact.p((axis + 2) % 3) = v;
          contact.n = -side * Eigen::Vector3d::Unit(axis);
          contacts.push_back(contact);
        }
  return wrench_set(contacts, Eigen::Vector3d::Zero(), 1);
}

inline WrenchSet orthogonal_discs() {
  WrenchSet set;
  for (int i = 0; i < 3; ++i) {
    Axes A = Axes::Zero(6, 2);
    A(2 * i, 0) = A(2 * i + 1, 1) = 1;
    set.caps.push_back({ScaledWrench{}, A, -1});
  }
  return set;
}

inline WrenchSet orthogonal_balls() {
  WrenchSet set;
  for (int i = 0; i < 2; ++i) {
    Axes A = Axes::Zero(6, 3);
    A.middleRows(3 * i, 3).setIdentity();
    set.caps.push_back({ScaledWrench{}, A, -1});
  }
  return set;
}

/// At +-3 cm on x, torque scale 3 cm. @param torsion  in parts of the scale
/// [1]; 0: hard points
inline WrenchSet two_soft_fingers(double friction, double torsion) {
  const double r = 0.03;
  return wrench_set({{{r, 0, 0}, {-1, 0, 0}, friction, torsion * r},
                     {{-r, 0, 0}, {1, 0, 0}, friction, torsion * r}},
                    Eigen::Vector3d::Zero(), r);
}

}  // namespace thenar
