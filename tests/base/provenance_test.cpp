// Tests for base/provenance.h.

#include "base/provenance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>

namespace thenar {
namespace {

// The examples of FIPS 180-2, appendix B.1 and B.3, and the empty text.
TEST(Sha256, MatchesThePublishedExamples) {
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256(std::string(1000000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST(Sha256, SeesEveryByteAlsoZero) {
  EXPECT_NE(sha256(std::string("a\0b", 3)), sha256(std::string("a\0c", 3)));
}

TEST(Versions, NameEverythingThatComputes) {
  const auto all = versions();
  for (const char* name : {"thenar", "compiler", "Eigen", "Ceres", "Ipopt", "NLopt", "CLP", "HDF5",
                           "Qhull", "SUNDIALS", "Simbody"})
    EXPECT_EQ(all.count(name), 1U) << name;
  for (const auto& [name, version] : all) {
    EXPECT_FALSE(version.empty()) << name;
    EXPECT_TRUE(std::any_of(version.begin(), version.end(), isdigit)) << name << " " << version;
  }
}

}  // namespace
}  // namespace thenar
