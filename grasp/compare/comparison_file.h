#pragma once

/// Files of comparisons of hands (JSON): written after every pair, sealed, and gone on with.

#include <functional>
#include <string>
#include <vector>

#include "base/provenance.h"
#include "base/run_record.h"
#include "data/io/json_node.h"
#include "grasp/compare/comparison.h"

namespace thenar {

/// Comparison that an earlier run left in a file.
struct KeptComparison {
  std::vector<HandOnObject> cells;
  JsonNode provenance;  // the run that wrote it, and "earlier_runs"; null: no file, or an older one
};

/// Everything but how long it took; units are in the names. null: not known; "infinite".
[[nodiscard]] JsonNode comparison_node(const Comparison& comparison);

/// SHA-256 of everything in a comparison but this checksum itself, which its member "sha256" keeps.
[[nodiscard]] std::string comparison_checksum(const JsonNode& file);

/// Cells as comparison_node() writes them, each number held against its range.
/// @param path  only names the file in messages
/// @throws DataError `path:line:` for what is missing or out of range.
[[nodiscard]] std::vector<HandOnObject> parse_cells(const JsonNode& list, const std::string& path);

/// Reads what an earlier run left; nothing if there is no such file.
/// @param inputs  that it must have come from, by name: another value is refused by that name
/// @param name    of today of a hand, for files that call hands by older names
/// @param files   that this comparison reads: those that have changed are named
/// @throws DataError, InputError if the file holds something else, or its checksum does not hold or
/// is missing.
[[nodiscard]] KeptComparison read_comparison(
    const std::string& path, const JsonNode& inputs,
    const std::function<std::string(const std::string&)>& name, const FileDigests& files = {});

/// Provenance of a file that `run` goes on with: that run and its files, and the runs before it.
/// @param before  KeptComparison::provenance
[[nodiscard]] JsonNode next_provenance(const JsonNode& before, const RunRecord& run,
                                       const FileDigests& files = {});

/// Writes a comparison with its inputs, its provenance if there is one, and its checksum.
/// @throws InputError if the file cannot be written.
void write_comparison(const std::string& path, const Comparison& comparison, const JsonNode& inputs,
                      const JsonNode& provenance);

}  // namespace thenar
