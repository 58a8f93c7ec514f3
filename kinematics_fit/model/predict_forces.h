#pragma once

/// Forward model: fingertip forces of every trial of an experiment, for any scalar type.

#include <functional>

#include "kinematics_fit/model/experiment_plan.h"
#include "kinematics_fit/model/force_site.h"
#include "kinematics_fit/model/specimen_model.h"

namespace thenar {

/// Builds the model of the digit as mounted, for given parameter values [SI] (all).
template <typename T>
[[nodiscard]] SpecimenModel<T> specimen_model(const TendonDigit& digit,
                                              const FitParameters& parameters,
                                              const std::vector<T>& values) {
  SpecimenModel<T> model = cast_model<T>(digit.model, static_cast<int>(parameters.postures.size()));
  if (digit.net) model.net = cast_net<T>(digit.net);
  for (std::size_t p = 0; p < parameters.all.size(); ++p)
    set_parameter(digit.model, parameters.all[p], values[p], model);
  normalise_axes(model);
  return model;
}

/// Returns the rotation by the rotation vector w, exact to second order near zero, without
/// singularities.
template <typename T>
[[nodiscard]] Mat3<T> small_rotation(const Vec3<T>& w) {
  // Cayley's map: a rotation for any w, tangent to the exponential.
  const Vec3<T> h = w / T(2);
  Mat3<T> K;
  K << T(0), -h.z(), h.y(), h.z(), T(0), -h.x(), -h.y(), h.x(), T(0);
  return Mat3<T>::Identity() + (T(2) / (T(1) + h.squaredNorm())) * (K + K * K);
}

/// Specimen in one posture of an experiment.
template <typename T>
struct PosedSpecimen {
  VectorX<T> angles;   // joint angles with their errors [rad] (coordinates)
  TreeState<T> state;  // pose of the links
  int key = -1;        // index of the posture in the parameters' postures; -1: not named there
  Mat3<T> cell;  // map from the tip's axes to the components of the load cell; rows of components
                 // that are not fitted are zero (3, 3)
};

/// Poses a specimen in one posture of an experiment.
template <typename T>
[[nodiscard]] PosedSpecimen<T> pose_specimen(const SpecimenModel<T>& model,
                                             const ExperimentPlan& plan, std::size_t posture) {
  // Compute the angles of the posture with their errors.
  PosedSpecimen<T> at;
  at.key = plan.posture_key[posture];
  at.angles = plan.postures[posture].cast<T>() + model.angle_error;
  if (at.key >= 0) at.angles += model.posture_error.col(at.key);
  at.state = pose_tree(model.digit.tree, at.angles);
  // Rotate from the tip's axes to those of the link in which forces are stated, then to the cell's.
  at.cell = plan.components.cast<T>() * small_rotation(model.sensor_tilt);
  if (plan.force_link != model.digit.tip_link) {
    const auto axes = [&](int link) -> Mat3<T> {
      return link < 0 ? model.digit.tip_axes : Mat3<T>(at.state[link].X.R * model.digit.tip_axes);
    };
    at.cell = (at.cell * axes(plan.force_link).transpose() * axes(model.digit.tip_link)).eval();
  }
  return at;
}

/// Computes the map from stated tensions to the tip's force in the tip's axes, for all tendons
/// outside of a net [1] (3, muscles).
template <typename T>
[[nodiscard]] MatrixX<T> stated_force_map(const SpecimenModel<T>& model, const ExperimentPlan& plan,
                                          const PosedSpecimen<T>& at) {
  MatrixX<T> arms = muscle_arms(model.digit, at.state, at.angles);
  if (model.net) take_outside_arms(*model.net, model.digit.tree, at.state, arms);
  MatrixX<T> map = held_tip_forces(model.digit, at.state, plan.hold, plan.known, model.out_of_plane,
                                   MatrixX<T>(arms.transpose())) *
                       model.gain.asDiagonal() +
                   model.unexplained;
  // Add the forces that the geometry does not explain in this posture.
  const Eigen::Index muscles = model.gain.size();
  if (at.key >= 0) map += model.posture_unexplained.middleCols(at.key * muscles, muscles);
  return map;
}

/// Computes the map from tensions to the components of the tip's load cell [1] (3, muscles).
template <typename T>
[[nodiscard]] MatrixX<T> cell_force_map(const SpecimenModel<T>& model, const ExperimentPlan& plan,
                                        const PosedSpecimen<T>& at) {
  return at.cell * stated_force_map(model, plan, at);
}

/// Computes the map from tensions to the components of a load cell that does not hold the tip, for
/// a model without a net [1] (3, muscles).
template <typename T>
[[nodiscard]] MatrixX<T> site_force_map(const SpecimenModel<T>& model, const ExperimentPlan& plan,
                                        const PosedSpecimen<T>& at, const PlannedSite& site) {
  const auto axes = [&](int link) -> Mat3<T> {
    return link < 0 ? model.digit.tip_axes : Mat3<T>(at.state[link].X.R * model.digit.tip_axes);
  };
  // Compute the force in the base's axes: of a held segment, or of the mount.
  const MatrixX<T> map = site.link >= 0
                             ? MatrixX<T>(axes(site.link) *
                                          segment_force_map(model.digit, site, at.state, at.angles,
                                                            plan.hold, plan.known) *
                                          model.gain.asDiagonal())
                             : mount_force_map(model, site, at.state,
                                               MatrixX<T>(axes(model.digit.tip_link) *
                                                          stated_force_map(model, plan, at)));
  return plan.components.cast<T>() * (axes(site.axes_link).transpose() * map);
}

/// Function that returns the joint torque of the net in a trial, for the posed specimen [N m]
/// (coordinates).
template <typename T>
using NetTorque = std::function<VectorX<T>(const PosedSpecimen<T>& at, Eigen::Index trial)>;

/// Predicts the force components of every trial [N] (3, trials).
/// @param net_torque  torque in the trials in which muscles pull the model's net: pulls_net();
/// unused
///                    without a net
template <typename T>
[[nodiscard]] Eigen::Matrix<T, 3, Eigen::Dynamic> predict_forces(
    const SpecimenModel<T>& model, const ExperimentPlan& plan,
    const NetTorque<T>& net_torque = {}) {
  Eigen::Matrix<T, 3, Eigen::Dynamic> forces(3, plan.force.cols());
  for (std::size_t k = 0; k < plan.postures.size(); ++k) {
    // Compute the map once for all trials of the posture.
    const PosedSpecimen<T> at = pose_specimen(model, plan, k);
    const MatrixX<T> map = cell_force_map(model, plan, at);
    std::vector<MatrixX<T>> elsewhere(
        plan.sites.size());  // maps of other load cells, computed on demand
    for (Eigen::Index i = 0; i < forces.cols(); ++i) {
      if (plan.posture_of_trial[i] != static_cast<int>(k)) continue;
      // Handle a load cell at another place than the tip.
      if (const int other = site_of(plan, static_cast<std::size_t>(i)); other >= 0) {
        const auto cell = static_cast<std::size_t>(other);
        if (elsewhere[cell].size() == 0)
          elsewhere[cell] = site_force_map(model, plan, at, plan.sites[cell]);
        forces.col(i) = elsewhere[cell] * plan.tension[i].cast<T>();
        continue;
      }
      forces.col(i) = map * plan.tension[i].cast<T>();
      // Add the net, whose force is not linear in tensions.
      if (model.net && pulls_net(*model.net->built, plan.tension[i]))
        forces.col(i) +=
            at.cell * held_tip_forces(model.digit, at.state, plan.hold, plan.known,
                                      model.out_of_plane, MatrixX<T>(net_torque(at, i)));
    }
  }
  return forces;
}

}  // namespace thenar
