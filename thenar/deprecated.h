#pragma once

/// Names of version 0.2, for one version more: each says which name it has now.

#include "api/compare.h"
#include "api/feasible_force.h"
#include "api/fit.h"
#include "api/grasp.h"
#include "api/moment_arms.h"
#include "api/pads/press_pad.h"
#include "api/pose.h"
#include "api/quality.h"
#include "api/scenes/simulate_scene.h"
#include "api/simulate.h"
#include "api/tendon_infer.h"
#include "api/tendon_solve.h"
#include "api/tip_force.h"
#include "base/special_functions.h"
#include "base/units.h"
#include "data/io/robot/drive_coupling.h"
#include "data/io/scene/joint_kind.h"
#include "data/io/scene/scene.h"
#include "grasp/closing/setup.h"

namespace thenar {

using DigitSweep [[deprecated("DigitResult")]] = DigitResult;
using TipHold [[deprecated("TipConstraint")]] = TipConstraint;
using RobotDofKind [[deprecated("DriveCoupling")]] = DriveCoupling;
using SceneJointKind [[deprecated("JointKind")]] = JointKind;
[[deprecated("kNewtonMillimetre")]] inline constexpr double kNmm = kNewtonMillimetre;
[[deprecated("kNormal95HalfWidth")]] inline constexpr double kNormal95 = kNormal95HalfWidth;
[[deprecated("kMaxSceneSamples")]] inline constexpr double kMostSamples = kMaxSceneSamples;
using TipForceAnswer [[deprecated("TipForceResult")]] = TipForceResult;
using FeasibleForceAnswer [[deprecated("FeasibleForceResult")]] = FeasibleForceResult;
using MomentArmAnswer [[deprecated("MomentArmResult")]] = MomentArmResult;
using PoseAnswer [[deprecated("PoseResult")]] = PoseResult;
using AskPosture [[deprecated("ComputePosture")]] = ComputePosture;
using NoAnswer [[deprecated("RecordFailure")]] = RecordFailure;
using QualityRequest [[deprecated("ContactQualityRequest")]] = ContactQualityRequest;
using ContactQuality [[deprecated("ContactQualityResult")]] = ContactQualityResult;
using MotionRequest [[deprecated("DigitMotionRequest")]] = DigitMotionRequest;
using SimulatedMotion [[deprecated("DigitMotionResult")]] = DigitMotionResult;
using SimulatedScene [[deprecated("SceneResult")]] = SceneResult;
using SceneSweep [[deprecated("SceneSweepResult")]] = SceneSweepResult;
using PressedPad [[deprecated("PressResult")]] = PressResult;
using HandComparison [[deprecated("CompareResult")]] = CompareResult;
using TendonSolution [[deprecated("TendonSolveResult")]] = TendonSolveResult;
using TendonSweep [[deprecated("TendonSweepResult")]] = TendonSweepResult;
using NetInference [[deprecated("InferNetResult")]] = InferNetResult;
using Scene [[deprecated("GraspSetup")]] = GraspSetup;
using SceneBody [[deprecated("GraspBody")]] = GraspBody;

[[deprecated("compute_tip_force()")]] [[nodiscard]] inline TipForceResult ask_tip_force(
    const TipForceRequest& request, const Progress& progress = {}) {
  return compute_tip_force(request, progress);
}
[[deprecated("compute_feasible_force()")]] [[nodiscard]] inline FeasibleForceResult
ask_feasible_force(const FeasibleForceRequest& request, const Progress& progress = {}) {
  return compute_feasible_force(request, progress);
}
[[deprecated("compute_moment_arms()")]] [[nodiscard]] inline MomentArmResult ask_moment_arms(
    const DigitRequest& request, const Progress& progress = {}) {
  return compute_moment_arms(request, progress);
}
[[deprecated("compute_poses()")]] [[nodiscard]] inline PoseResult ask_pose(
    const PoseRequest& request, const Progress& progress = {}) {
  return compute_poses(request, progress);
}
[[deprecated("compute_postures()")]] inline void ask_postures(DigitResult& result,
                                                              const ComputePosture& compute,
                                                              const RecordFailure& record,
                                                              const Progress& progress) {
  compute_postures(result, compute, record, progress);
}
[[deprecated("is_trusted()")]] [[nodiscard]] constexpr bool trusted(TendonStatus status) {
  return is_trusted(status);
}
[[deprecated("measure_contacts()")]] [[nodiscard]] inline ContactQualityResult contact_quality(
    const ContactQualityRequest& request) {
  return measure_contacts(request);
}
[[deprecated("measure_grasp()")]] [[nodiscard]] inline GraspResult grasp_in_world(
    const GraspRequest& request, const Progress& progress = {}) {
  return measure_grasp(request, progress);
}
[[deprecated("fit_digit()")]] [[nodiscard]] inline FitResult fit_forces(
    const FitRequest& request, const Progress& progress = {}) {
  return fit_digit(request, progress);
}
[[deprecated("simulate_scene()")]] [[nodiscard]] inline SceneResult run_scene(
    const SceneRequest& request, const Progress& progress = {}) {
  return simulate_scene(request, progress);
}
[[deprecated("sweep_scene()")]] [[nodiscard]] inline std::optional<SceneSweepResult> vary_scene(
    const SceneRequest& request, const Progress& progress = {}) {
  return sweep_scene(request, progress);
}

}  // namespace thenar
