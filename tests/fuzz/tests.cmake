# What fuzzing (nightly.py) has found worth keeping, and absurd sizes.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
add_test(NAME fuzz.replay COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_LIST_DIR}/replay_test.py ${CMAKE_RUNTIME_OUTPUT_DIRECTORY})
set_tests_properties(fuzz.replay PROPERTIES LABELS fuzz TIMEOUT 600)
