# thenar_prelude(TARGET NAME HEADER...)
#
# Compiles TARGET with HEADERs read once for all targets that ask for NAME (same flags, please).
# Off (-DTHENAR_PRELUDE=OFF, as in the presets dev and tidy) every file stands on its own includes.
option(THENAR_PRELUDE "Precompile the headers that most files read" ON)

function(thenar_prelude target name)
  if(NOT THENAR_PRELUDE)
    return()
  endif()
  set(prelude thenar_prelude_${name})
  if(NOT TARGET ${prelude})
    file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/prelude/${name}.cpp CONTENT "")
    add_library(${prelude} OBJECT ${PROJECT_BINARY_DIR}/prelude/${name}.cpp)
    foreach(property LINK_LIBRARIES COMPILE_OPTIONS)
      set_property(TARGET ${prelude} PROPERTY ${property} $<TARGET_PROPERTY:${target},${property}>)
    endforeach()
    target_precompile_headers(${prelude} PRIVATE ${ARGN})
  endif()
  target_precompile_headers(${target} REUSE_FROM ${prelude})
endfunction()

set(THENAR_PRELUDE_HEADERS <algorithm> <array> <cmath> <filesystem> <functional> <limits> <map>
    <memory> <numeric> <optional> <random> <set> <sstream> <string> <vector>
    <Eigen/Dense> ${PROJECT_SOURCE_DIR}/base/dense.h <fmt/format.h> <fmt/ranges.h>)
