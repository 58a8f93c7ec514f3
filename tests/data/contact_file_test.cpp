// Tests for data/io/contact_file.cpp; tests/apps/quality_command_test.py has all its messages.

#include "data/io/contact_file.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

TEST(ContactFile, MakesNormalsUnitAndKeepsTheirLength) {
  const ContactFile file =
      parse_contacts("a.json",
                     R"({"centre_of_mass": [0, 0, 1], "torque_scale": 0.5, "contacts": [
          {"position": [1, 2, 3], "normal": [0, 3, 4], "friction": 0.5, "patch": 2}]})");
  ASSERT_EQ(file.contacts.size(), 1U);
  EXPECT_EQ(file.contacts[0].normal_length, 5);
  EXPECT_EQ(file.contacts[0].normal, Eigen::Vector3d(0, 0.6, 0.8));
  EXPECT_EQ(file.contacts[0].patch, 2);
  EXPECT_EQ(file.centre_of_mass, Eigen::Vector3d(0, 0, 1));
  EXPECT_TRUE(file.warnings.empty());
}

TEST(ContactFile, OfTwoNumbersIsPlanar) {
  const ContactFile file =
      parse_contacts("a.json", R"({"centre_of_mass": [0, 0], "torque_scale": 1, "contacts": [
                     {"wrenches": [[1, 2, 3]]}], "task": {"loads": [[4, 5, 6]]}})");
  EXPECT_TRUE(file.planar);
  EXPECT_EQ(file.contacts[0].wrenches[0], (FileWrench() << 1, 2, 0, 0, 0, 3).finished());
  EXPECT_EQ(file.task.loads[0], (FileWrench() << 4, 5, 0, 0, 0, 6).finished());
}

TEST(ContactFile, CountsLinesFromTheFirstOfTheText) {
  EXPECT_EQ(message_of<DataError>([] { (void)parse_contacts("stdin", "{}", 7); }),
            "stdin:7: the file has no 'centre_of_mass'");
}

}  // namespace
}  // namespace thenar
