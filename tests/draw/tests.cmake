# Pictures: read again, and looked at by a real browser where there is one.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
foreach(name draw viewer)
  add_test(NAME draw.${name} COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_LIST_DIR}/${name}_test.py ${CMAKE_RUNTIME_OUTPUT_DIRECTORY})
  set_tests_properties(draw.${name} PROPERTIES LABELS draw TIMEOUT 600 SKIP_RETURN_CODE 77)
endforeach()
