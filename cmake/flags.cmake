# Compiler flags of all build types.
#
# NDEBUG is never defined: Simbody's State has members under #ifndef NDEBUG, and Debian built its
# library with them; CMake's own Release flags would add it and the program would crash.
set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_CXX_FLAGS_RELEASE "-O3")
# Round a*b + c twice on every processor: whether gcc would join the two operations depends on the code
# around them.
add_compile_options(-ffp-contract=off)
set(CMAKE_CXX_FLAGS_RELWITHDEBINFO "-O2 -g")

option(THENAR_SANITIZE "Build with the address and undefined-behaviour sanitizers" OFF)
option(THENAR_FUZZ "Build fuzzers of the readers with clang's libFuzzer" OFF)

option(THENAR_WERROR "End the build at a warning of gcc" OFF)
add_library(thenar_warnings INTERFACE)
target_compile_options(thenar_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(thenar_warnings INTERFACE $<$<BOOL:${THENAR_WERROR}>:-Werror>
    # gcc 12 at -O3 raises these falsely inside fmt and Eigen
    -Wno-stringop-overflow -Wno-use-after-free -Wno-array-bounds -Wno-maybe-uninitialized)
endif()

if(THENAR_SANITIZE)
  # Switch off two checks of clang. pointer-overflow reports the unused blocks of an empty matrix, which
  # Eigen computes from a null pointer; the address sanitizer finds reads beyond an object. vptr opens
  # pipes, which the mesh reader may not do while it reads.
  add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=all
                      $<$<CXX_COMPILER_ID:Clang>:-fno-sanitize=pointer-overflow,vptr>
                      -fno-omit-frame-pointer)
  # The sources test gcc's macro, which clang 14 does not define.
  add_compile_definitions($<$<CXX_COMPILER_ID:Clang>:__SANITIZE_ADDRESS__=1>)
  add_link_options(-fsanitize=address,undefined)
endif()
if(THENAR_FUZZ)
  # Instrument every library for the coverage of libFuzzer.
  add_compile_options(-fsanitize=fuzzer-no-link,address,bounds,float-cast-overflow
                      -fno-sanitize-recover=all -O1)
  add_link_options(-fsanitize=address,bounds,float-cast-overflow)
endif()

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
  # Allow ccache to keep files with a precompiled header; nothing else is relaxed.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env
      CCACHE_SLOPPINESS=pch_defines,time_macros ${CCACHE_PROGRAM})
endif()
