#pragma once

/// Types of thumbs as text, fields and rows.

#include <string>

#include "base/provenance.h"
#include "report/fields.h"
#include "studies/questions/study.h"

namespace thenar {

/// Returns a text with shares of the types, the order at the MCP joint beside the published share,
/// assumptions, and the Denavit-Hartenberg parameters of each type.
[[nodiscard]] std::string text_of(const ThumbTypesResult& result);

[[nodiscard]] Fields fields_of(const ThumbTypesResult& result);

/// Returns a table with a row for each type and axis: mean and sd of theta, d, a and alpha.
[[nodiscard]] Table table_of(const ThumbTypesResult& result);

/// Returns the digests of the files that the thumbs were drawn from.
[[nodiscard]] FileDigests files_of(const ThumbTypesResult& result);

/// Returns a table with a row for each type: draws, share and its 95 % interval.
[[nodiscard]] Table share_table(const ThumbTypesResult& result);

/// Returns the order at the MCP joint in words: "MCP flexion axis distal in 60.1 % (58.5 .. 61.7)
/// of 3550 draws; published 65.2 %; ..".
[[nodiscard]] std::string order_words(const ThumbTypesResult& result);

/// Returns the assumed numbers in words: "Assumed, not measured: CMC1_FE along_sd_ratio, ..".
[[nodiscard]] std::string assumed_words(const ThumbTypesResult& result);

}  // namespace thenar
