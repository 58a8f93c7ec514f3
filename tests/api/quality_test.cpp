// Tests for api/quality.cpp; tests/apps/quality_command_test.py derives many more numbers.

#include "api/quality.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

/// Two fingers of friction 0.5 that press along x, at the distance of the torque scale.
ContactQualityRequest pinch(const std::string& more) {
  ContactQualityRequest request;
  request.contacts = "pinch";
  request.text = R"({"centre_of_mass": [0, 0, 0], "torque_scale": 1, "contacts": [
    {"position": [-1, 0, 0], "normal": [1, 0, 0], "friction": 0.5},
    {"position": [1, 0, 0], "normal": [-1, 0, 0], "friction": 0.5}])" +
                 more + "}";
  return request;
}

// Wrenches of unit forces are longer than 1; a proof needs 10 roundings of 32 eps each.
TEST(ContactQualityResult, HasNoGapBelowRounding) {
  ContactQualityRequest request = pinch("");
  request.gap = 320 * std::numeric_limits<double>::epsilon();
  EXPECT_NE(message_of([&] { (void)measure_contacts(request); }).find("wanted a gap of at least"),
            std::string::npos);
  request.gap = 1e-9;
  EXPECT_NO_THROW((void)measure_contacts(request));
}

// Nothing stops a turn about the line between two hard points.
TEST(ContactQualityResult, OfTwoHardPointsLacksOneDirection) {
  const ContactQualityResult found = measure_contacts(pinch(""));
  EXPECT_FALSE(found.epsilon.force_closure);
  EXPECT_EQ(found.epsilon.rank, 5);
  EXPECT_EQ(found.grasp_matrix->internal_forces, 1);
  EXPECT_FALSE(found.task.has_value());
}

// A pull of 1 N across takes 2 mu N = 1: a sum of normal forces of 1 / mu.
TEST(ContactQualityResult, FindsTheLeastGraspForceOfATask) {
  const ContactQualityResult found =
      measure_contacts(pinch(R"(, "task": {"loads": [[0, 1, 0, 0, 0, 0], [0, 0, 0, 1, 0, 0]]})"));
  ASSERT_TRUE(found.task.has_value());
  EXPECT_NEAR(found.task->grasp_forces[0].value(), 2, 1e-7);
  EXPECT_TRUE(std::isinf(found.task->grasp_forces[1].value()));
  EXPECT_EQ(found.task->lower, 0);
}

TEST(ContactQualityResult, TakesContactsByName) {
  ContactQualityRequest request;
  request.contacts = "two_soft_fingers";
  request.data = THENAR_DATA_DIR;
  EXPECT_TRUE(measure_contacts(request).epsilon.force_closure);
}

TEST(ContactQualityResult, RefusesPyramidsOfTwoEdges) {
  ContactQualityRequest request = pinch("");
  request.edges = 2;
  EXPECT_EQ(message_of<InputError>([&] { (void)measure_contacts(request); }),
            "wanted pyramids of 3 to 1000 edges, got 2");
}

}  // namespace
}  // namespace thenar
