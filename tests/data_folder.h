#pragma once

/// Where the sample data lie.

#include <string>

namespace thenar {

inline const std::string kData = THENAR_DATA_DIR;

}  // namespace thenar
