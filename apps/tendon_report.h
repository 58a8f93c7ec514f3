#pragma once

#include <string>

#include "apps/tendon_question.h"
#include "report/pages/tendons.h"

namespace thenar {

/// A page with the net in space and the charts of a sweep, with the provenance of its numbers.
/// @throws InputError if it cannot be written.
void write_tendon_report(const TendonQuestion& question, const TendonCase& at,
                         const TendonSweep& sweep, const std::string& path);

}  // namespace thenar
