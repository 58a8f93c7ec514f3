// Tests for api/contact_warnings.cpp.

#include "api/contact_warnings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace thenar {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// One contact that presses towards the centre from 0.1 m.
ContactFile one_contact() {
  ContactFile file;
  file.centre_of_mass.setZero();
  file.torque_scale = 0.1;
  FileContact contact;
  contact.position = {0.1, 0, 0};
  contact.normal = {-1, 0, 0};
  contact.friction = 0.5;
  file.contacts = {contact};
  return file;
}

TEST(ContactWarnings, AreNoneWhereNothingIsOdd) {
  EXPECT_TRUE(contact_warnings(one_contact()).empty());
}

TEST(ContactWarnings, NameMillimetresOutwardNormalsAndAngles) {
  ContactFile file = one_contact();
  file.contacts[0].position *= 1000;
  EXPECT_THAT(contact_warnings(file), ElementsAre(HasSubstr("are these millimetres?")));
  file = one_contact();
  file.contacts[0].normal *= -1;
  EXPECT_THAT(contact_warnings(file), ElementsAre(HasSubstr("point away")));
  file = one_contact();
  file.contacts[0].friction = 30;
  EXPECT_THAT(contact_warnings(file), ElementsAre(HasSubstr("is this an angle?")));
}

TEST(ContactWarnings, NameContactsThatStandTwiceUnlessTheyArePatches) {
  ContactFile file = one_contact();
  file.contacts.push_back(file.contacts[0]);
  EXPECT_THAT(contact_warnings(file), ElementsAre(HasSubstr("another contact: contact 1")));
  file.contacts[0].patch = 0;
  file.contacts[1].patch = 1;
  EXPECT_TRUE(contact_warnings(file).empty());
}

}  // namespace
}  // namespace thenar
