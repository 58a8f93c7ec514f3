# thenar_library(NAME PUBLIC ... PRIVATE ...)
#
# Makes one library of all .cpp files of a folder. PUBLIC lists libraries of folders below; PRIVATE lists
# third parties, which only .cpp files may include. ALONE lists sources that unity builds leave out, because
# the headers of a third party change the meaning of what follows. An OWN library is not installed.
# GLUE compiles with -O1, in half the time: for folders that only read, call and write.
function(thenar_library name)
  cmake_parse_arguments(ARG "OWN;GLUE" "" "PUBLIC;PRIVATE;ALONE" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS *.cpp)
  add_library(thenar_${name} ${sources})
  add_library(thenar::${name} ALIAS thenar_${name})
  target_include_directories(thenar_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/thenar>)
  target_compile_features(thenar_${name} PUBLIC cxx_std_17)
  target_link_libraries(thenar_${name} PUBLIC ${ARG_PUBLIC}
    PRIVATE $<BUILD_INTERFACE:thenar_warnings> ${ARG_PRIVATE})
  set_target_properties(thenar_${name} PROPERTIES EXPORT_NAME ${name})
  set_source_files_properties(${ARG_ALONE} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  set(prelude library)
  if(ARG_GLUE)
    set(prelude glue)
    target_compile_options(thenar_${name} PRIVATE -O1)
  endif()
  thenar_prelude(thenar_${name} ${prelude} thenar_base ${THENAR_PRELUDE_HEADERS})
  if(NOT ARG_OWN)
    thenar_install_library(${name})
  endif()
endfunction()
