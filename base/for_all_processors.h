#pragma once

/// THENAR_FOR_ALL_PROCESSORS before a function compiles it for several processors, one of which is
/// chosen at run time. With -ffp-contract=off all versions give the same bits, as long as the
/// function fixes the order of its sums.

// Address and thread sanitizers are not initialised yet when the loader picks a version.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define THENAR_FOR_ALL_PROCESSORS __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define THENAR_FOR_ALL_PROCESSORS
#endif
