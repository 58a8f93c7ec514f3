# What `cmake --install` puts down: headers, libraries, thenarConfig.cmake and the command.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

function(thenar_install_library name)
  install(TARGETS thenar_${name} EXPORT thenarTargets)
  file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR})
  file(GLOB headers CONFIGURE_DEPENDS *.h)
  install(FILES ${headers} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/thenar/${folder})
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
install(DIRECTORY ${PROJECT_SOURCE_DIR}/data/subjects ${PROJECT_SOURCE_DIR}/data/experiments
                  ${PROJECT_SOURCE_DIR}/data/robots ${PROJECT_SOURCE_DIR}/data/objects
                  ${PROJECT_SOURCE_DIR}/data/worlds ${PROJECT_SOURCE_DIR}/data/contacts
                  ${PROJECT_SOURCE_DIR}/data/fits ${PROJECT_SOURCE_DIR}/data/nets
  DESTINATION ${CMAKE_INSTALL_DATADIR}/thenar)
