#pragma once

/// Subjects whose hands the tests dress.

#include "data/io/anthropometry.h"
#include "data/io/subject.h"

namespace thenar::sample {

inline Subject subject(const std::string& name) {
  return read_subject(std::string(THENAR_DATA_DIR "/subjects/") + name + ".toml");
}

/// A flat hand of simple axes. @param size  length and breadth [m]
inline Subject scaled(const HandSize& size = {0.195, 0.085}) {
  return scale_hand(read_proportions(THENAR_DATA_DIR "/anthropometry/buchholz1992.toml"), size);
}

}  // namespace thenar::sample
