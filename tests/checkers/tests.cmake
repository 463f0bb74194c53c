# The test certificates: what the checker must answer to each of them.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
add_test(NAME checker.certificates
  COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_LIST_DIR}/run_certificates.py $<TARGET_FILE:confidel-check>)
set_tests_properties(checker.certificates PROPERTIES LABELS checker TIMEOUT 1200)
include(${CMAKE_CURRENT_LIST_DIR}/agreement/tests.cmake)
# A sample of the typed changes; nightly without --most and with --flips. mutation/mutate_checker.py, which changes the checker itself, is nightly too:
# here it only has to find its places and catch some.
add_test(NAME checker.typed_mutations
  COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_LIST_DIR}/mutation/typed_test.py $<TARGET_FILE:confidel-check> --most 1)
set_tests_properties(checker.typed_mutations PROPERTIES LABELS checker TIMEOUT 600)
# The float filter never contradicts the integers.
set(CONFIDEL_CHECK_SOURCE ${PROJECT_SOURCE_DIR}/checkers/gmp)
add_executable(filter-consistency ${CMAKE_CURRENT_LIST_DIR}/filter/consistency.cpp ${CONFIDEL_CHECK_SOURCE}/points.cpp
  ${CONFIDEL_CHECK_SOURCE}/sphere.cpp ${CONFIDEL_CHECK_SOURCE}/filter.cpp ${CONFIDEL_CHECK_SOURCE}/cluster.cpp ${CONFIDEL_CHECK_SOURCE}/index.cpp)
target_include_directories(filter-consistency PRIVATE ${PROJECT_SOURCE_DIR})
target_link_libraries(filter-consistency PRIVATE PkgConfig::GMPXX Threads::Threads)
add_test(NAME checker.filter COMMAND filter-consistency)
set_tests_properties(checker.filter PROPERTIES LABELS checker TIMEOUT 600)
