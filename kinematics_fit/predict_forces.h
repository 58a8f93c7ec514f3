#pragma once

/// The forward model: fingertip forces of every trial of an experiment, on any scalar.

#include "kinematics_fit/experiment_plan.h"
#include "kinematics_fit/specimen_model.h"

namespace thenar {

/// Model of the digit as mounted, for given parameter values [SI] (all).
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

/// Map from stated tensions to the force components that the load cell reads in one posture [1]
/// (3, muscles); rows of components that the experiment does not fit are zero.
template <typename T>
[[nodiscard]] MatrixX<T> cell_force_map(const SpecimenModel<T>& model, const ExperimentPlan& plan,
                                        std::size_t posture) {
  // The posture with its errors of angles.
  VectorX<T> angles = plan.postures[posture].cast<T>() + model.angle_error;
  if (plan.posture_key[posture] >= 0) angles += model.posture_error.col(plan.posture_key[posture]);
  const TreeState<T> state = pose_tree(model.digit.tree, angles);
  // Tip force of a unit of stated tension, in the tip's axes.
  MatrixX<T> map =
      tip_force_map(model.digit, state, angles, plan.hold, plan.known, model.out_of_plane) *
          model.gain.asDiagonal() +
      model.unexplained;
  const Eigen::Index muscles = model.gain.size();
  if (plan.posture_key[posture] >= 0)
    map += model.posture_unexplained.middleCols(plan.posture_key[posture] * muscles, muscles);
  // Turned to the axes of the link in which forces are stated.
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
  // The map of each posture serves all its trials.
  std::vector<MatrixX<T>> maps;
  for (std::size_t k = 0; k < plan.postures.size(); ++k)
    maps.push_back(cell_force_map(model, plan, k));
  Eigen::Matrix<T, 3, Eigen::Dynamic> forces(3, plan.force.cols());
  for (Eigen::Index i = 0; i < forces.cols(); ++i)
    forces.col(i) = maps[plan.posture_of_trial[i]] * plan.tension[i].cast<T>();
  return forces;
}

}  // namespace thenar
