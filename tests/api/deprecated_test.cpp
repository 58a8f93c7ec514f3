// Names of version 0.2 still compile, and mean what their new names do.

#include "thenar/deprecated.h"

#include <type_traits>
#include <variant>

#include <gtest/gtest.h>

#pragma GCC diagnostic ignored "-Wdeprecated-declarations"

namespace thenar {
namespace {

TEST(Deprecated, TypesAreThoseOfToday) {
  EXPECT_TRUE((std::is_same_v<TipHold, TipConstraint>));
  EXPECT_TRUE((std::is_same_v<TipForceAnswer, TipForceResult>));
  EXPECT_TRUE((std::is_same_v<FeasibleForceAnswer, FeasibleForceResult>));
  EXPECT_TRUE((std::is_same_v<MomentArmAnswer, MomentArmResult>));
  EXPECT_TRUE((std::is_same_v<PoseAnswer, PoseResult>));
  EXPECT_TRUE((std::is_same_v<AskPosture, ComputePosture>));
  EXPECT_TRUE((std::is_same_v<NoAnswer, RecordFailure>));
  EXPECT_TRUE((std::is_same_v<DigitSweep, DigitResult>));
  EXPECT_TRUE((std::is_same_v<QualityRequest, ContactQualityRequest>));
  EXPECT_TRUE((std::is_same_v<ContactQuality, ContactQualityResult>));
  EXPECT_TRUE((std::is_same_v<MotionRequest, DigitMotionRequest>));
  EXPECT_TRUE((std::is_same_v<SimulatedMotion, DigitMotionResult>));
  EXPECT_TRUE((std::is_same_v<SimulatedScene, SceneResult>));
  EXPECT_TRUE((std::is_same_v<SceneSweep, SceneSweepResult>));
  EXPECT_TRUE((std::is_same_v<PressedPad, PressResult>));
  EXPECT_TRUE((std::is_same_v<HandComparison, CompareResult>));
  EXPECT_TRUE((std::is_same_v<TendonSolution, TendonSolveResult>));
  EXPECT_TRUE((std::is_same_v<TendonSweep, TendonSweepResult>));
  EXPECT_TRUE((std::is_same_v<NetInference, InferNetResult>));
  EXPECT_TRUE((std::is_same_v<RobotDofKind, DriveCoupling>));
  EXPECT_TRUE((std::is_same_v<SceneJointKind, JointKind>));
  EXPECT_FALSE(trusted(TendonStatus::kUnbalanced));
  EXPECT_EQ(kNmm, 1e-3);
  EXPECT_EQ(kMostSamples, kMaxSceneSamples);
  EXPECT_EQ(kNormal95, kNormal95HalfWidth);
  EXPECT_TRUE((std::is_same_v<Scene, GraspSetup>));
  EXPECT_TRUE((std::is_same_v<SceneBody, GraspBody>));
}

TEST(Deprecated, FunctionsAnswerAsThoseOfToday) {
  TipForceRequest request;
  request.digit.subject = "synek2019_middle";
  request.digit.data = THENAR_DATA_DIR;
  request.tension = {{"FDP", 10}};
  EXPECT_EQ(ask_tip_force(request).points[0].force, compute_tip_force(request).points[0].force);
  FeasibleForceRequest feasible;
  feasible.digit = request.digit;
  feasible.direction = Eigen::Vector3d(0, 0, 1);
  EXPECT_EQ(ask_feasible_force(feasible).points[0].largest->component,
            compute_feasible_force(feasible).points[0].largest->component);
  EXPECT_EQ(ask_moment_arms(request.digit).points[0].arms,
            compute_moment_arms(request.digit).points[0].arms);
  PoseRequest pose;
  pose.model = request.digit.subject;
  pose.data = THENAR_DATA_DIR;
  EXPECT_EQ(std::get<SubjectPoses>(ask_pose(pose)).points[0].tips[0].p,
            std::get<SubjectPoses>(compute_poses(pose)).points[0].tips[0].p);
  ContactQualityRequest contacts;
  contacts.contacts = "two_soft_fingers";
  contacts.data = THENAR_DATA_DIR;
  EXPECT_EQ(contact_quality(contacts).epsilon.lower, measure_contacts(contacts).epsilon.lower);
  // What takes longer is named, and not called.
  EXPECT_NE(&grasp_in_world, nullptr);
  EXPECT_NE(&fit_forces, nullptr);
  EXPECT_NE(&run_scene, nullptr);
  EXPECT_NE(&vary_scene, nullptr);
  EXPECT_NE(&ask_postures, nullptr);
}

}  // namespace
}  // namespace thenar
