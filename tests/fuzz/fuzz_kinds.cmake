# What reads all kinds of files, for the fuzzer and for the test that mutates files without it.
include_guard(GLOBAL)
add_library(thenar_fuzz_kinds INTERFACE)
target_sources(thenar_fuzz_kinds INTERFACE
  ${CMAKE_CURRENT_LIST_DIR}/fuzz_kinds.cpp
  ${PROJECT_SOURCE_DIR}/apps/compare_file.cpp ${PROJECT_SOURCE_DIR}/apps/contact_doubts.cpp
  ${PROJECT_SOURCE_DIR}/apps/contact_file.cpp)
target_link_libraries(thenar_fuzz_kinds INTERFACE thenar::report_answers)
