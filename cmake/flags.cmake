# Our own flags, the same in every build type that matters.
#
# NDEBUG is never defined: Simbody's State has members under #ifndef NDEBUG, and Debian built its
# library with them; CMake's own Release flags would add it and the program would crash.
set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_CXX_FLAGS_RELEASE "-O3")
# a*b + c is rounded twice on every processor, wherever the code stands: where gcc joins the two
# depends on what stands around them.
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
  # Eigen steps from the null pointer of an empty matrix to its blocks, which nobody reads; clang
  # alone minds. Reads beyond an object are the address sanitizer's. To look at types clang opens
  # pipes, which the mesh reader may not while it reads.
  add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=all
                      $<$<CXX_COMPILER_ID:Clang>:-fno-sanitize=pointer-overflow,vptr>
                      -fno-omit-frame-pointer)
  # The sources ask for gcc's word, which clang 14 does not say.
  add_compile_definitions($<$<CXX_COMPILER_ID:Clang>:__SANITIZE_ADDRESS__=1>)
  add_link_options(-fsanitize=address,undefined)
endif()
if(THENAR_FUZZ)
  # Every library tells libFuzzer where it has been.
  add_compile_options(-fsanitize=fuzzer-no-link,address,bounds,float-cast-overflow
                      -fno-sanitize-recover=all -O1)
  add_link_options(-fsanitize=address,bounds,float-cast-overflow)
endif()

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
  # Sloppy only so far that files with a precompiled header are kept, too.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env
      CCACHE_SLOPPINESS=pch_defines,time_macros ${CCACHE_PROGRAM})
endif()
