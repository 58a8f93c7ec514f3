# thenar_embed(TARGET NAME FILE...)
#
# Compiles files into TARGET as `const std::map<std::string, std::string_view>& internal::NAME()`,
# file name -> content, so that the program needs no other files at run time.
add_custom_target(thenar_generated)

function(thenar_embed target name)
  set(generated ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  list(TRANSFORM ARGN PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/ OUTPUT_VARIABLE files)
  add_custom_command(OUTPUT ${generated}
    COMMAND ${CMAKE_COMMAND} -DNAME=${name} "-DFILES=${files}" -DOUT=${generated}
            -P ${PROJECT_SOURCE_DIR}/cmake/embed_files.cmake
    DEPENDS ${files} ${PROJECT_SOURCE_DIR}/cmake/embed_files.cmake VERBATIM)
  target_sources(${target} PRIVATE ${generated})
  # A target of its own for `./run tidy`, which compiles nothing.
  add_custom_target(${target}_${name} DEPENDS ${generated})
  add_dependencies(thenar_generated ${target}_${name})
endfunction()
