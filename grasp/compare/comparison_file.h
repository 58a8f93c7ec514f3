#pragma once

/// Files of comparisons of hands (JSON), written after every cell, with a checksum, and resumable.

#include <functional>
#include <string>
#include <vector>

#include "base/provenance.h"
#include "base/run_record.h"
#include "data/io/json_node.h"
#include "grasp/compare/comparison.h"

namespace thenar {

/// Comparison that an earlier run left in a file.
struct SavedComparison {
  std::vector<HandOnObject> cells;
  JsonNode
      provenance;  // provenance of that run, with "earlier_runs"; null: no file, or one without it
};

/// Converts a comparison to JSON, without durations; keys contain units. Unknown values are null,
/// infinite ones "infinite".
[[nodiscard]] JsonNode comparison_node(const Comparison& comparison);

/// Computes the SHA-256 of a comparison without its member "sha256", which holds the checksum.
[[nodiscard]] std::string comparison_checksum(const JsonNode& file);

/// Reads cells in the format of comparison_node() and checks the range of each number.
/// @param path  name of the file, for messages
/// @throws DataError `path:line:` if a value is missing or out of range.
[[nodiscard]] std::vector<HandOnObject> parse_cells(const JsonNode& list, const std::string& path);

/// Reads the comparison that an earlier run left; an empty one if there is no such file.
/// @param inputs  inputs of this run by name; the file must have the same, or the error names one
/// @param name    function that returns today's name of a hand, for files that use older names
/// @param files   files that this run reads; errors list those that have changed
/// @throws DataError, InputError if the file has other inputs, or a wrong checksum or none.
[[nodiscard]] SavedComparison read_comparison(
    const std::string& path, const JsonNode& inputs,
    const std::function<std::string(const std::string&)>& name, const FileDigests& files = {});

/// Returns the provenance of a file that `run` continues: that run and its files, and earlier runs.
/// @param before  SavedComparison::provenance
[[nodiscard]] JsonNode continued_provenance(const JsonNode& before, const RunRecord& run,
                                            const FileDigests& files = {});

/// Writes a comparison with its inputs, its checksum and, unless it is null, its provenance.
/// @throws InputError if the file cannot be written.
void write_comparison(const std::string& path, const Comparison& comparison, const JsonNode& inputs,
                      const JsonNode& provenance);

}  // namespace thenar
