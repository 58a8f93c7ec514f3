#pragma once

/// Origin of a result file.

#include <vector>

#include "base/provenance.h"
#include "base/run_record.h"
#include "data/io/result_file.h"

namespace thenar {

/// Adds texts and hashes of all sources, versions of all programs and libraries, and the run.
void add_origin(const std::vector<SourceText>& sources, const RunRecord& run, ResultFile& file);

}  // namespace thenar
