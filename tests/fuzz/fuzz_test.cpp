// Files of every kind, changed at random: each is read or refused, without much memory.
//
// THENAR_MUTATIONS sets how many of all kinds together; 510 otherwise.

#include <cstdlib>

#include <gtest/gtest.h>

#include <sys/resource.h>

#include "base/file_io.h"
#include "tests/fuzz/fuzz_kinds.h"
#include "tests/fuzz/mutate.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

constexpr double kMaxMemory = 1.5e9;  // [bytes]

class Mutations : public TemporaryFolder, public testing::WithParamInterface<std::size_t> {};

TEST_P(Mutations, DoNoHarm) {
  const FuzzKind kind = fuzz_kinds(path("")).at(GetParam());
  SCOPED_TRACE(kind.name);
  for (const FuzzSeed& seed : kind.seeds) {
    write_file(path(seed.name), seed.text);
    EXPECT_NO_THROW(kind.read(path(seed.name))) << seed.name;  // else nothing behind is reached
  }
  const char* const wanted = std::getenv("THENAR_MUTATIONS");
  const int count = (wanted == nullptr ? 510 : std::atoi(wanted)) / 17;
  std::mt19937 rng(1);
  for (int i = 0; i < count; ++i) {
    const FuzzSeed& seed = kind.seeds[below(rng, kind.seeds.size())];
    const std::string& other = kind.seeds[below(rng, kind.seeds.size())].text;
    const std::string text = mutated(seed.text, other, rng);
    write_file(path(seed.name), text);
    try {
      read_harmlessly(kind, path(seed.name));
    } catch (const std::exception& harm) {
      const std::string kept = "/tmp/mutated_" + kind.name + "_" + seed.name;
      write_file(kept, text);
      FAIL() << "copy " << i << ", kept as " << kept << ": " << harm.what();
    }
  }
  rusage used{};
  (void)getrusage(RUSAGE_SELF, &used);
  EXPECT_LT(1024.0 * static_cast<double>(used.ru_maxrss), kMaxMemory);
}

INSTANTIATE_TEST_SUITE_P(OfEveryKind, Mutations, testing::Range<std::size_t>(0, 20));

TEST_F(TemporaryFolder, HasTwentyOneKinds) { EXPECT_EQ(fuzz_kinds(path("")).size(), 21U); }

}  // namespace
}  // namespace thenar
