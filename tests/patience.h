#pragma once

/// How long tests wait for what is to come.

#include <chrono>

namespace thenar {

/// Guards against hangs alone: far longer than any machine takes, and nothing else hangs on it.
inline constexpr std::chrono::minutes kHang{4};

}  // namespace thenar
