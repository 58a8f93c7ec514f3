#pragma once

/// Copies of what <replicate> of an MJCF file encloses.

#include "data/io/graspit/xml_file.h"

namespace thenar::internal {

/// Puts copies in the place of every <replicate count=".." sep=".." offset=".." euler="..">, copy i
/// in i nested <frame pos="offset" euler="euler">: each is moved and turned in the frame of the one
/// before. Names within get the suffix sep + i, padded with zeros to the digits of count, inner
/// replicates first; tendons, equalities and actuators that name a joint or tendon within are
/// copied along.
/// @throws DataError if a count is not in 1..1000, or copies become too many.
/// Source: the MJCF reference [Todorov2012].
void expand_replicates(const XmlFile& file);

}  // namespace thenar::internal
