# The test certificates: what the checker must answer to each of them.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
add_test(NAME checker.certificates
  COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_LIST_DIR}/run_certificates.py $<TARGET_FILE:confidel-check>)
set_tests_properties(checker.certificates PROPERTIES LABELS checker TIMEOUT 1200)
include(${CMAKE_CURRENT_LIST_DIR}/agreement/tests.cmake)
