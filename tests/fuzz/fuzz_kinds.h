#pragma once

/// Every kind of file that thenar reads, with files to begin from, for tests that break them.

#include <functional>
#include <string>
#include <vector>

namespace thenar {

/// A whole file of some kind.
struct FuzzSeed {
  std::string name;  // of the file: its ending may tell what it is
  std::string text;
};

/// One kind of input.
struct FuzzKind {
  std::string name;                              // "subject"
  std::vector<FuzzSeed> seeds;                   // good files
  std::function<void(const std::string&)> read;  // a path; throws Error where the file is none
  double cost = 1;                               // of one reading, against others
};

/// All seventeen (for libFuzzer all but comparisons, whose reader needs much more). What files name
/// stands in `folder` afterwards, where copies are to be read.
[[nodiscard]] std::vector<FuzzKind> fuzz_kinds(const std::string& folder);

/// What holds after any reading. @throws std::logic_error if it does not
void read_harmlessly(const FuzzKind& kind, const std::string& path);

}  // namespace thenar
