#pragma once

/// All public headers of thenar at once:
///
///     #include <thenar/thenar.h>
///
/// The headers below, and those that they include, are installed; all others are private. Folders
/// are listed from the lowest layer up (docs/architecture.md).

// base: errors, units, rigid motions, files, progress, threads.
#include "base/bounded_normal.h"
#include "base/cache.h"
#include "base/error.h"
#include "base/fidelity.h"
#include "base/file_io.h"
#include "base/nearest_name.h"
#include "base/numbers.h"
#include "base/parallel_for.h"
#include "base/progress.h"
#include "base/provenance.h"
#include "base/random_stream.h"
#include "base/spatial.h"
#include "base/special_functions.h"
#include "base/units.h"

// solvers: linear, cone, nonlinear and least-squares programs, hulls, stiff differential equations.
#include "solvers/arrow_factor.h"
#include "solvers/bound_prices.h"
#include "solvers/bounded_least_squares.h"
#include "solvers/cone_program.h"
#include "solvers/convex_hull.h"
#include "solvers/least_squares.h"
#include "solvers/linear_complementarity.h"
#include "solvers/linear_program.h"
#include "solvers/nonlinear_program.h"
#include "solvers/orthogonal_solve.h"
#include "solvers/stiff_ode.h"

// dynamics: impulses of contacts and joints in one time step.
#include "contact/contact_problem.h"
#include "contact/contact_solver.h"

// geometry: solids as signed distances, meshes.
#include "geometry/cached_mesh.h"
#include "geometry/mass_properties.h"
#include "geometry/mesh_check.h"
#include "geometry/mesh_from_distance.h"
#include "geometry/mesh_parts.h"
#include "geometry/repair_to_solid.h"
#include "geometry/rounded_shape.h"
#include "geometry/shape.h"
#include "geometry/shape_mass.h"
#include "geometry/shape_spec.h"
#include "geometry/solid.h"
#include "geometry/triangle_mesh.h"

// geometry/collision: distances and contacts of two solids.
#include "geometry/collision/collision_tree.h"
#include "geometry/collision/curvature.h"
#include "geometry/collision/patch_reduction.h"
#include "geometry/collision/patch_search.h"
#include "geometry/collision/signed_distance.h"

// geometry/manifold: contacts of bodies in motion.
#include "geometry/manifold/broad_phase.h"
#include "geometry/manifold/collision_body.h"
#include "geometry/manifold/collision_pair.h"
#include "geometry/manifold/collision_world.h"
#include "geometry/manifold/contact_manifold.h"
#include "geometry/manifold/first_contact.h"

// data/io: subjects, experiments, nets, fits and posteriors as files.
#include "data/io/anthropometry.h"
#include "data/io/checked_file.h"
#include "data/io/dh.h"
#include "data/io/experiment.h"
#include "data/io/file_guard.h"
#include "data/io/file_kind.h"
#include "data/io/fit_settings.h"
#include "data/io/inference_file.h"
#include "data/io/net_description.h"
#include "data/io/result_file.h"
#include "data/io/subject.h"
#include "data/io/toml_node.h"
#include "data/io/toml_table.h"
#include "data/io/toml_text.h"
#include "data/io/units.h"

// data/io/mesh: meshes of other programs.
#include "data/io/mesh/bounded_process.h"
#include "data/io/mesh/foreign_mesh.h"
#include "data/io/mesh/mesh_file.h"
#include "data/io/mesh/reader_answer.h"
#include "data/io/mesh/repair_shape.h"
#include "data/io/mesh/shape_toml.h"
#include "data/io/mesh/transformed_primitive.h"
#include "data/io/mesh/triangle_soup.h"

// data/io/pad: finger pads as plain data.
#include "data/io/pad/pad.h"
#include "data/io/pad/pad_digest.h"

// data/io/graspit: files of GraspIt!.
#include "data/io/graspit/graspit_link.h"
#include "data/io/graspit/graspit_transform.h"
#include "data/io/graspit/xml_file.h"

// data/io/robot: robot hands: TOML, URDF, MJCF, GraspIt!.
#include "data/io/robot/import_robot.h"
#include "data/io/robot/link_poses.h"
#include "data/io/robot/robot.h"
#include "data/io/robot/urdf.h"

// data/io/world: objects, materials, worlds.
#include "data/io/world/graspit_body.h"
#include "data/io/world/graspit_world.h"
#include "data/io/world/materials.h"
#include "data/io/world/world.h"

// data/io/scene: moving scenes as plain data.
#include "data/io/scene/scene.h"

// hand: the hand as a tree of links, by Simbody and in closed form.
#include "hand/chain.h"
#include "hand/hand.h"
#include "hand/multibody.h"
#include "hand/passive_moment.h"
#include "hand/skeleton.h"
#include "hand/skeleton_hand.h"
#include "hand/tip_manipulability.h"

// hand/skin: skin, flesh and mass.
#include "hand/skin/hand_anatomy.h"
#include "hand/skin/human_surfaces.h"
#include "hand/skin/skin_landmarks.h"

// tendons/wrapping: shortest paths over bones.
#include "tendons/wrapping/arm_slopes.h"
#include "tendons/wrapping/bone_surface.h"
#include "tendons/wrapping/fitted_path.h"
#include "tendons/wrapping/path_arms.h"
#include "tendons/wrapping/wrapped_string.h"

// tendons: tendons of a digit: paths, moment arms, lengths.
#include "tendons/digit_tendons.h"
#include "tendons/explain_digit.h"
#include "tendons/linear_tendons.h"
#include "tendons/name_conventions.h"
#include "tendons/path.h"
#include "tendons/tendon_model.h"
#include "tendons/tip_statics.h"
#include "tendons/vanishing_arms.h"

// tendons/forces: fingertip forces and what limits them.
#include "tendons/forces/feasible_force_set.h"
#include "tendons/forces/max_tip_force.h"
#include "tendons/forces/max_tip_load.h"
#include "tendons/forces/pinch_statics.h"
#include "tendons/forces/posture_sensitivity.h"
#include "tendons/forces/tip_force.h"
#include "tendons/forces/tip_map.h"
#include "tendons/forces/tip_wrench.h"

// tendons/net: the extensor mechanism as a floating net.
#include "tendons/net/band_course.h"
#include "tendons/net/build_tendons.h"
#include "tendons/net/net.h"
#include "tendons/net/net_derivatives.h"
#include "tendons/net/net_statics.h"
#include "tendons/net/net_tendons.h"
#include "tendons/net/posture_sweep.h"
#include "tendons/net/solve_net.h"
#include "tendons/net/tendon_actuator.h"

// tendons/muscle: Hill-type muscles and motion.
#include "tendons/muscle/simulate.h"
#include "tendons/muscle/trajectory_table.h"

// tendons/topology: which bands a net has, inferred from tests.
#include "tendons/topology/candidate_net.h"
#include "tendons/topology/search_nets.h"
#include "tendons/topology/select_bands.h"

// hand_versions: whole human hands.
#include "hand_versions/closing_synergy.h"
#include "hand_versions/human_hand.h"

// sampling/methods: samplers that are asked and told.
#include "sampling/methods/laplace_covariance.h"
#include "sampling/methods/parallel_tempering.h"
#include "sampling/methods/sampler.h"
#include "sampling/methods/state_bytes.h"
#include "sampling/methods/target.h"

// sampling/run: chains, files, processes.
#include "sampling/run/communicator.h"
#include "sampling/run/draws.h"
#include "sampling/run/run_chains.h"

// sampling/diagnostics: has the sampler converged?.
#include "sampling/diagnostics/autocovariance.h"
#include "sampling/diagnostics/convergence.h"
#include "sampling/diagnostics/learnt_directions.h"
#include "sampling/diagnostics/leave_one_out.h"
#include "sampling/diagnostics/modes.h"
#include "sampling/diagnostics/order_statistics.h"
#include "sampling/diagnostics/predictive.h"
#include "sampling/diagnostics/simulation_based_calibration.h"
#include "sampling/diagnostics/split_chains.h"
#include "sampling/diagnostics/uniform_ranks.h"

// kinematics_fit: fits of kinematic parameters to measured forces.
#include "kinematics_fit/bands/hood_comparison.h"
#include "kinematics_fit/bands/net_records.h"
#include "kinematics_fit/cross_validation.h"
#include "kinematics_fit/fit.h"
#include "kinematics_fit/fit_coordinates.h"
#include "kinematics_fit/fit_problem.h"
#include "kinematics_fit/fit_residuals.h"
#include "kinematics_fit/force_jacobian.h"
#include "kinematics_fit/misfit.h"
#include "kinematics_fit/model/experiment_plan.h"
#include "kinematics_fit/model/fit_parameters.h"
#include "kinematics_fit/model/force_site.h"
#include "kinematics_fit/model/parameter.h"
#include "kinematics_fit/model/predict_forces.h"
#include "kinematics_fit/model/specimen_model.h"
#include "kinematics_fit/prediction.h"
#include "kinematics_fit/specimen_prior.h"
#include "kinematics_fit/trivial_prediction.h"

// posterior: the posterior of a hand.
#include "posterior/find_modes.h"
#include "posterior/force_density.h"
#include "posterior/hand_posterior.h"

// posterior/run: sampled posteriors and their files.
#include "posterior/run/posterior_file.h"
#include "posterior/run/posterior_quantities.h"
#include "posterior/run/posterior_summary.h"
#include "posterior/run/predict_draws.h"
#include "posterior/run/sample_posterior.h"

// grasp/contact: contacts, friction, soft fingers.
#include "grasp/contact/contact.h"
#include "grasp/contact/contact_patch.h"
#include "grasp/contact/friction_pyramid.h"
#include "grasp/contact/scaled_wrench.h"
#include "grasp/contact/soft_pads.h"
#include "grasp/contact/wrench_set.h"

// grasp/limits: which contact forces joints, limits and motors support.
#include "grasp/limits/drive_torques.h"
#include "grasp/limits/force_set.h"
#include "grasp/limits/grasp_force.h"
#include "grasp/limits/joint_limits.h"
#include "grasp/limits/wrench_support.h"

// grasp/quality: quality of grasps.
#include "grasp/quality/epsilon.h"
#include "grasp/quality/grasp_matrix.h"
#include "grasp/quality/grasp_stiffness.h"
#include "grasp/quality/inscribed_ball.h"
#include "grasp/quality/manipulability.h"
#include "grasp/quality/planar_grasp.h"
#include "grasp/quality/robustness.h"
#include "grasp/quality/task_margin.h"
#include "grasp/quality/volume.h"
#include "grasp/quality/wrench_set_mesh.h"

// grasp/closing: closing a hand on an object.
#include "grasp/closing/approach_sampling.h"
#include "grasp/closing/close_hand.h"
#include "grasp/closing/closing_drives.h"
#include "grasp/closing/fingertip_paths.h"
#include "grasp/closing/grasp.h"
#include "grasp/closing/setup.h"
#include "grasp/closing/tendon_closing.h"

// grasp/robot: robot hands that close.
#include "grasp/robot/infer_hand.h"
#include "grasp/robot/robot_hand.h"
#include "grasp/robot/robot_tips.h"

// grasp/compare: hands compared on objects and tasks.
#include "grasp/compare/compare_hands.h"
#include "grasp/compare/comparison.h"
#include "grasp/compare/grasp_loads.h"
#include "grasp/compare/pregrasp.h"

// api: hands, subjects, objects, worlds by name, and the questions that people ask.
#include "api/close.h"
#include "api/compare.h"
#include "api/explain.h"
#include "api/feasible_force.h"
#include "api/fit.h"
#include "api/grasp.h"
#include "api/grasp_measures.h"
#include "api/import.h"
#include "api/moment_arms.h"
#include "api/named/data_folders.h"
#include "api/named/digit_result.h"
#include "api/named/digits.h"
#include "api/named/files.h"
#include "api/named/hands.h"
#include "api/named/pads.h"
#include "api/named/portable_world.h"
#include "api/named/posture.h"
#include "api/named/worlds.h"
#include "api/pads/calibrate_pad.h"
#include "api/pads/fit_pad.h"
#include "api/pads/press_object.h"
#include "api/pads/press_pad.h"
#include "api/pose.h"
#include "api/posterior.h"
#include "api/predict.h"
#include "api/quality.h"
#include "api/read_motion.h"
#include "api/robot_pose.h"
#include "api/scenes/compare_rungs.h"
#include "api/scenes/read_scene_run.h"
#include "api/scenes/scene_account.h"
#include "api/scenes/simulate_scene.h"
#include "api/scenes/world_scene.h"
#include "api/simulate.h"
#include "api/tendon_infer.h"
#include "api/tendon_solve.h"
#include "api/tendon_warnings.h"
#include "api/tip_force.h"
#include "api/validate.h"
#include "live/live_digit.h"
#include "live/live_fit.h"
#include "live/live_picture.h"

#include "thenar/deprecated.h"
