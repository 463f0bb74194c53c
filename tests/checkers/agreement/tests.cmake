# The GMP checker and the one extracted from Coq: the same verdicts. Skipped where the latter is not built (./run proofs builds it).
set(CONFIDEL_VERIFIED ${PROJECT_SOURCE_DIR}/checkers/verified/build/confidel-check-verified)
add_test(NAME checker.agreement
  COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_LIST_DIR}/agreement_test.py ${CMAKE_RUNTIME_OUTPUT_DIRECTORY} ${CONFIDEL_VERIFIED}
  WORKING_DIRECTORY ${PROJECT_BINARY_DIR})
add_test(NAME checker.mutants
  COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_LIST_DIR}/../verified/mutants.py $<TARGET_FILE:confidel-check> ${CONFIDEL_VERIFIED} 800
  WORKING_DIRECTORY ${PROJECT_BINARY_DIR})
set_tests_properties(checker.agreement checker.mutants PROPERTIES LABELS checker TIMEOUT 900 SKIP_RETURN_CODE 77)
