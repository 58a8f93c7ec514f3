#pragma once

/// The forward model: fingertip forces of every trial of an experiment, on any scalar.

#include <map>

#include "base/error.h"
#include "kinematics_fit/fit_parameters.h"
#include "kinematics_fit/specimen_model.h"

namespace thenar {

/// Names of an experiment resolved against a digit; built once, used at every evaluation.
struct ExperimentPlan {
  TipConstraint hold;
  int force_link;                         // link whose axes the forces use; -1: the base
  Eigen::Matrix3d components;             // experiment components from (proximal, dorsal, radial)
  std::vector<Eigen::VectorXd> postures;  // [rad] (coordinates)
  std::vector<std::string> posture_names;
  std::vector<int> posture_key;   // column of posture_error of each posture; -1: none
  std::vector<double> condition;  // of each posture's tip_constraint_loads() before the fit [1]
  std::vector<int> posture_of_trial;
  std::vector<Eigen::VectorXd> tension;  // of each trial [N] (muscles)
  Eigen::Matrix3Xd force;                // measured [N] (3, trials)
  Eigen::Matrix3Xd sd;                   // [N] (3, trials)
};

/// @param parameters  says which postures may be in error one by one
/// @throws InputError if the experiment names a joint, muscle or segment the digit has not, or a
/// posture in which the held tip is singular: no force there follows from the tendons' torques.
[[nodiscard]] ExperimentPlan plan_experiment(const TendonDigit& digit,
                                             const FitParameters& parameters,
                                             const Experiment& experiment);

/// The digit as mounted, for these parameter values [SI] (all).
template <typename T>
[[nodiscard]] SpecimenModel<T> specimen_model(const TendonDigit& digit,
                                              const FitParameters& parameters,
                                              const std::vector<T>& values) {
  SpecimenModel<T> model = cast_model<T>(digit.model, static_cast<int>(parameters.postures.size()));
  for (std::size_t p = 0; p < parameters.all.size(); ++p)
    set_parameter(digit.model, parameters.all[p], values[p], model);
  normalise_axes(model);
  return model;
}

/// Rotation by the rotation vector w, exact to second order near zero without a singular angle.
template <typename T>
[[nodiscard]] Mat3<T> small_rotation(const Vec3<T>& w) {
  // Cayley's map: a rotation for any w, tangent to the exponential.
  const Vec3<T> h = w / T(2);
  Mat3<T> K;
  K << T(0), -h.z(), h.y(), h.z(), T(0), -h.x(), -h.y(), h.x(), T(0);
  return Mat3<T>::Identity() + (T(2) / (T(1) + h.squaredNorm())) * (K + K * K);
}

/// Map from stated tensions to the force components the load cell reads (3, muscles), one posture.
template <typename T>
[[nodiscard]] MatrixX<T> cell_force_map(const SpecimenModel<T>& model, const ExperimentPlan& plan,
                                        std::size_t posture) {
  VectorX<T> angles = plan.postures[posture].cast<T>() + model.angle_error;
  if (plan.posture_key[posture] >= 0) angles += model.posture_error.col(plan.posture_key[posture]);
  const TreeState<T> state = pose_tree(model.digit.tree, angles);
  MatrixX<T> map = tip_force_map(model.digit, state, angles, plan.hold, model.out_of_plane) *
                   model.gain.asDiagonal();
  if (plan.force_link != model.digit.tip_link) {
    const auto axes = [&](int link) -> Mat3<T> {
      return link < 0 ? model.digit.tip_axes : Mat3<T>(state[link].X.R * model.digit.tip_axes);
    };
    map = (axes(plan.force_link).transpose() * axes(model.digit.tip_link) * map).eval();
  }
  return plan.components.cast<T>() * (small_rotation(model.sensor_tilt) * map);
}

/// Predicted force components of every trial [N] (3, trials).
template <typename T>
[[nodiscard]] Eigen::Matrix<T, 3, Eigen::Dynamic> predict_forces(const SpecimenModel<T>& model,
                                                                 const ExperimentPlan& plan) {
  std::vector<MatrixX<T>> maps;
  for (std::size_t k = 0; k < plan.postures.size(); ++k)
    maps.push_back(cell_force_map(model, plan, k));
  Eigen::Matrix<T, 3, Eigen::Dynamic> forces(3, plan.force.cols());
  for (Eigen::Index i = 0; i < forces.cols(); ++i)
    forces.col(i) = maps[plan.posture_of_trial[i]] * plan.tension[i].cast<T>();
  return forces;
}

}  // namespace thenar
