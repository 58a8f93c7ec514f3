# Installs the build tree BUILD below WORK, then configures, builds and runs this folder with what
# was installed, and asks the installed command for its version. SOURCE is this folder.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status)
  if(status)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}: ${status}")
  endif()
endfunction()

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix)

# What was installed may be moved: it names neither the sources nor the build tree.
file(GLOB targets ${WORK}/prefix/lib*/cmake/thenar/*.cmake ${WORK}/prefix/lib*/*/cmake/thenar/*.cmake)
foreach(file IN LISTS targets)
  file(STRINGS ${file} found REGEX "${BUILD}")
  if(found)
    message(FATAL_ERROR "${file} names the build tree: ${found}")
  endif()
endforeach()

run(${CMAKE_COMMAND} -S ${SOURCE} -B ${WORK}/build -G Ninja -DCMAKE_PREFIX_PATH=${WORK}/prefix
    "-DCMAKE_CXX_FLAGS=${FLAGS}")
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${WORK}/build/uses_thenar ${WORK}/prefix/share/thenar/subjects/synek2019_middle.toml)
run(${WORK}/prefix/bin/thenar --version)

# The installed command finds every subject, scene, hand, table of proportions .. of data/.
function(names_of out)
  execute_process(COMMAND ${WORK}/prefix/bin/thenar list --csv ${ARGN} WORKING_DIRECTORY ${WORK}
                  OUTPUT_VARIABLE names RESULT_VARIABLE status)
  if(status)
    message(FATAL_ERROR "thenar list ${ARGN}: ${status}")
  endif()
  string(REGEX REPLACE ",[^\n]*" "" names "${names}")  # kinds alone; files have other folders
  set(${out} "${names}" PARENT_SCOPE)
endfunction()
names_of(installed)
names_of(wanted --data ${SOURCE}/../../data)
if(NOT installed STREQUAL wanted)
  message(FATAL_ERROR "installed things:\n${installed}\nwanted:\n${wanted}")
endif()
