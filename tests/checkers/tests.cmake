# The test certificates: what the checker must answer to each of them.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
add_test(NAME checker.certificates
  COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_LIST_DIR}/run_certificates.py $<TARGET_FILE:confidel-check>)
set_tests_properties(checker.certificates PROPERTIES LABELS checker TIMEOUT 1200)
include(${CMAKE_CURRENT_LIST_DIR}/agreement/tests.cmake)
# Every bit of small certificates, in one process; here of the smallest.
file(GLOB CONFIDEL_CHECK_FILES CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/checkers/gmp/*.cpp)
list(FILTER CONFIDEL_CHECK_FILES EXCLUDE REGEX "/main\\.cpp$")
add_executable(bit-flips ${CMAKE_CURRENT_LIST_DIR}/flips/flips.cpp ${CONFIDEL_CHECK_FILES})
target_include_directories(bit-flips PRIVATE ${PROJECT_SOURCE_DIR})
set_target_properties(bit-flips PROPERTIES CXX_EXTENSIONS ON)
target_link_libraries(bit-flips PRIVATE PkgConfig::GMPXX ${CONFIDEL_CHECK_ZSTD} OpenSSL::Crypto Threads::Threads)
# A sample of the typed changes; nightly without --most and with --flips. mutation/mutate_checker.py, which changes the checker itself, is nightly too:
# here it only has to find its places and catch some.
add_test(NAME checker.typed_mutations
  COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_LIST_DIR}/mutation/typed_test.py $<TARGET_FILE:confidel-check> --most 1 --flips $<TARGET_FILE:bit-flips>)
set_tests_properties(checker.typed_mutations PROPERTIES LABELS checker TIMEOUT 600)
# The float filter never contradicts the integers.
set(CONFIDEL_CHECK_SOURCE ${PROJECT_SOURCE_DIR}/checkers/gmp)
add_executable(filter-consistency ${CMAKE_CURRENT_LIST_DIR}/filter/consistency.cpp ${CONFIDEL_CHECK_SOURCE}/points.cpp
  ${CONFIDEL_CHECK_SOURCE}/sphere.cpp ${CONFIDEL_CHECK_SOURCE}/filter.cpp ${CONFIDEL_CHECK_SOURCE}/cluster.cpp ${CONFIDEL_CHECK_SOURCE}/index.cpp)
target_include_directories(filter-consistency PRIVATE ${PROJECT_SOURCE_DIR})
target_link_libraries(filter-consistency PRIVATE PkgConfig::GMPXX Threads::Threads)
add_test(NAME checker.filter COMMAND filter-consistency)
set_tests_properties(checker.filter PROPERTIES LABELS checker TIMEOUT 600)
