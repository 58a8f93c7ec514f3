# Defines what `cmake --install` installs: public headers, libraries, thenarConfig.cmake and the command.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

function(thenar_install_library name)
  install(TARGETS thenar_${name} EXPORT thenarTargets)
  set_property(GLOBAL APPEND PROPERTY THENAR_LIBRARIES thenar_${name})
endfunction()

# Public headers are what thenar/thenar.h includes, and what these include.
function(thenar_install_headers)
  set(todo thenar/thenar.h)
  set(done "")
  while(todo)
    list(POP_FRONT todo header)
    list(APPEND done ${header})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${header})
    file(STRINGS ${PROJECT_SOURCE_DIR}/${header} lines REGEX "^#include \"")
    foreach(line IN LISTS lines)
      string(REGEX REPLACE "^#include \"([^\"]+)\".*" "\\1" included "${line}")
      if(NOT included IN_LIST done AND NOT included IN_LIST todo)
        list(APPEND todo ${included})
      endif()
    endforeach()
    get_filename_component(folder ${header} DIRECTORY)
    if(folder STREQUAL thenar)
      set(folder "")
    endif()
    install(FILES ${PROJECT_SOURCE_DIR}/${header}
            DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/thenar/${folder})
  endwhile()
endfunction()

# thenar::thenar: every library at once, for programs that include <thenar/thenar.h>.
function(thenar_umbrella)
  get_property(libraries GLOBAL PROPERTY THENAR_LIBRARIES)
  add_library(thenar INTERFACE)
  add_library(thenar::thenar ALIAS thenar)
  target_link_libraries(thenar INTERFACE ${libraries})
  target_include_directories(thenar INTERFACE
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  install(TARGETS thenar EXPORT thenarTargets)
  thenar_install_headers()
endfunction()

install(EXPORT thenarTargets NAMESPACE thenar:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/thenar)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/thenarConfig.cmake.in
  ${PROJECT_BINARY_DIR}/thenarConfig.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/thenar)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/thenarConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/thenarConfig.cmake
              ${PROJECT_BINARY_DIR}/thenarConfigVersion.cmake
              ${PROJECT_SOURCE_DIR}/cmake/dependencies.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/thenar)
# All data, without the code that reads it.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/data/
  DESTINATION ${CMAKE_INSTALL_DATADIR}/thenar PATTERN io EXCLUDE)
