# thenar_prelude(TARGET NAME LIKE HEADER...)
#
# Precompiles HEADERs once for all targets of the same NAME, and compiles TARGET with them. These targets must have the same
# compile options, because gcc takes the level of optimisation from the precompiled header. LIKE links to what the headers
# need and to nothing that other targets of NAME do not link to. With -DTHENAR_PRELUDE=OFF, as in the presets dev and tidy,
# each file is compiled with its own includes only.
option(THENAR_PRELUDE "Precompile the headers that most files read" ON)

function(thenar_prelude target name like)
  if(NOT THENAR_PRELUDE)
    return()
  endif()
  set(prelude thenar_prelude_${name})
  if(NOT TARGET ${prelude})
    file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/prelude/${name}.cpp CONTENT "")
    add_library(${prelude} OBJECT ${PROJECT_BINARY_DIR}/prelude/${name}.cpp)
    set_property(TARGET ${prelude} PROPERTY LINK_LIBRARIES
                 $<TARGET_PROPERTY:${like},LINK_LIBRARIES> thenar_warnings)
    get_target_property(options ${target} COMPILE_OPTIONS)  # its own, not those of what it links to
    set_property(TARGET ${prelude} PROPERTY COMPILE_OPTIONS ${options})
    target_precompile_headers(${prelude} PRIVATE ${ARGN})
  endif()
  target_precompile_headers(${target} REUSE_FROM ${prelude})
endfunction()

set(THENAR_PRELUDE_HEADERS <algorithm> <array> <cmath> <filesystem> <functional> <limits> <map>
    <memory> <numeric> <optional> <random> <set> <sstream> <string> <vector>
    <Eigen/Dense> ${PROJECT_SOURCE_DIR}/base/dense.h <fmt/format.h> <fmt/ranges.h>)
