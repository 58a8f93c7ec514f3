#pragma once

/// The files of the thumb study, as the tests read them.

#include <string>

#include "studies/thumb/thumb_study.h"
#include "studies/thumb/thumb_truth.h"

namespace thenar::sample {

inline ThumbStudyInputs study_inputs() { return thumb_study_inputs(THENAR_DATA_DIR); }

inline TendonDigit thumb_of(const SourceText& source) {
  return build_tendon_digit(parse_subject(source.text, source.path), "thumb");
}

/// The true thumb in the frame of the start.
inline TendonDigit true_thumb(const ThumbStudyInputs& inputs) {
  return in_frame_of(thumb_of(inputs.start), thumb_of(inputs.truth));
}

}  // namespace thenar::sample
