#pragma once

/// The same hand with a simpler thumb.

#include "data/io/subject.h"

namespace thenar {

/// The subject with the axes of its thumb as machines have them: each through the joint's centre
/// (see find_anatomy()), flexion about the radial direction square to the bone, abduction about
/// the dorsal one, so that the two of a joint cross at a right angle. Senses of turning, ranges,
/// bones and tendon points stay.
///
/// Hinges whose name ends in "_AA" abduct, all others flex; "_PS" (pronation) turns about the bone.
/// This is the thumb of the founding paper's first hand, the skewed one of its third [Miller2005].
/// @throws InputError if there is no digit "thumb".
[[nodiscard]] Subject orthogonal_thumb(Subject subject);

}  // namespace thenar
