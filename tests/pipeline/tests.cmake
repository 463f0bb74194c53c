# The real programs, from file to verdict.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
function(add_pipeline_test name script)
  add_test(NAME pipeline.${name}
    COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/${script} ${CMAKE_RUNTIME_OUTPUT_DIRECTORY} ${ARGN})
  set_tests_properties(pipeline.${name} PROPERTIES LABELS pipeline TIMEOUT 900 SKIP_RETURN_CODE 77)
endfunction()
add_pipeline_test(inputs_default inputs_test.py)
add_pipeline_test(inputs_graded inputs_test.py --strategy graded)
add_pipeline_test(command_line command_line_test.py)
add_pipeline_test(data data_test.py)
add_pipeline_test(global global_test.py)
add_pipeline_test(planar planar_test.py)
add_pipeline_test(lemmas lemmas_test.py)
