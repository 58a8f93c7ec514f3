// Tests for data/io/checked_file.cpp.

#include "data/io/checked_file.h"

#include <gmock/gmock.h>

#include "base/file_io.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

// SHA-256 of "abc", FIPS 180-4.
const std::string kDigestOfAbc = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";

TEST(CheckedFile, EndsWithTheDigestOfItsBytes) {
  EXPECT_THAT(with_checksum("abc"), EndsWith("\nthenar sha256 " + kDigestOfAbc + "\n"));
}

TEST(CheckedFile, ChecksumComesOffAgain) {
  std::string bytes = with_checksum("abc");
  EXPECT_EQ(take_checksum(bytes, "f.h5"), Checksum::kHolds);
  EXPECT_EQ(bytes, "abc");
  EXPECT_EQ(take_checksum(bytes, "f.h5"), Checksum::kAbsent);
  EXPECT_EQ(bytes, "abc");
}

TEST(CheckedFile, EveryChangedByteIsFound) {
  const std::string whole = with_checksum("some bytes");
  for (std::size_t i = 0; i < std::string("some bytes").size(); ++i) {
    std::string changed = whole;
    changed[i] ^= 1;
    EXPECT_THROW((void)take_checksum(changed, "f.h5"), DataError) << i;
  }
}

TEST(CheckedFile, RefusesFilesOfOthersAndLostChecksums) {
  const auto refusal = [](const char* program, Checksum checksum) {
    return message_of<DataError>(
        [&] { require_ours(program, checksum, "f.h5", "a result file of thenar"); });
  };
  EXPECT_THAT(refusal("", Checksum::kAbsent), HasSubstr("wanted a result file of thenar"));
  EXPECT_THAT(refusal(kCheckedProgram, Checksum::kAbsent),
              HasSubstr("checksum (SHA-256) is missing"));
  EXPECT_EQ(refusal(kCheckedProgram, Checksum::kHolds), "nothing was thrown");
  EXPECT_EQ(refusal(kUncheckedProgram, Checksum::kAbsent), "nothing was thrown");
}

class CheckedFiles : public TemporaryFolder {};

TEST_F(CheckedFiles, AreKnownByTheirStartAndEnd) {
  write_file(path("a.h5"), with_checksum("\x89HDF\r\n\x1a\n and more"));
  write_file(path("b.txt"),
             "plain text, long enough to hold a checksum: " + kDigestOfAbc + kDigestOfAbc);
  EXPECT_TRUE(has_hdf5_start(path("a.h5")));
  EXPECT_TRUE(has_checksum(path("a.h5")));
  EXPECT_FALSE(has_hdf5_start(path("b.txt")));
  EXPECT_FALSE(has_checksum(path("b.txt")));
  EXPECT_FALSE(has_hdf5_start(path("missing.h5")));
}

}  // namespace
}  // namespace thenar
