#pragma once

/// Named arrays of a file held against a list of those that its format wants.

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace thenar::internal {

/// Kind of an entry of a file, and range of its numbers.
enum class Holds {
  kFinite,  // numbers that are finite
  kAny,     // numbers, which may be NaN or infinite where something is not known
  kCount,   // whole numbers from 0, below 2^31
  kSeed,    // whole numbers from 0, below 2^32
  kTexts,   // texts
  kGroups,  // no entry, but the groups that stand at '*': as many as the length says
};

/// An entry that files of a format hold.
struct LayoutRow {
  // '*' stands for any text; what stands before it is a scope, in which the rest repeats.
  std::string key;
  // Lengths by their names: those of one name agree, within a scope or, where an entry of no scope
  // has it, in the file. "3": that length; "instant+": at least 1; "..": any more dimensions.
  std::vector<std::string> shape;
  Holds holds = Holds::kFinite;
  // "": must be there; "?": may be absent, as a list of names that is then empty; another word: all
  // entries of that word are there, or none.
  std::string presence = "";
};
using Layout = std::vector<LayoutRow>;

/// An entry that was found.
struct FoundEntry {
  const std::vector<double>* numbers;  // null: texts
  std::vector<std::size_t> shape;
};
using FoundEntries = std::map<std::string, FoundEntry>;

/// @param path  of the file, for messages
/// @throws DataError for an entry that is absent, of another type or shape, or holds other numbers
void check_entries(const FoundEntries& found, const Layout& layout, const std::string& path);

}  // namespace thenar::internal
