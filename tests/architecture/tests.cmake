# The rules of the house.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
add_test(NAME architecture COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_LIST_DIR}/architecture_test.py)
set_tests_properties(architecture PROPERTIES LABELS architecture TIMEOUT 60)
