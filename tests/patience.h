#pragma once

/// How much longer than in a release work may take in the build at hand.

namespace thenar {

#ifdef __SANITIZE_ADDRESS__
inline constexpr double kPatience = 20;  // sanitizers take 5 to 20 times as long [1]
#else
inline constexpr double kPatience = 1;
#endif

}  // namespace thenar
