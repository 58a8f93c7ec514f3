#pragma once

/// Origin of a result file.

#include <vector>

#include "base/run_record.h"
#include "data/io/result_file.h"
#include "base/provenance.h"

namespace thenar {

/// Adds texts and hashes of all sources, versions of all that computed, and the run.
void add_origin(const std::vector<SourceText>& sources, const RunRecord& run, ResultFile& file);

}  // namespace thenar
