# What reads all kinds of files, for the fuzzer and for the test that mutates files without it.
include_guard(GLOBAL)
add_library(thenar_fuzz_kinds INTERFACE)
target_sources(thenar_fuzz_kinds INTERFACE ${CMAKE_CURRENT_LIST_DIR}/fuzz_kinds.cpp)
target_link_libraries(thenar_fuzz_kinds INTERFACE thenar::compare thenar::robot thenar::world_io
                      thenar::robot_io thenar::scene_io thenar::pad_io)
