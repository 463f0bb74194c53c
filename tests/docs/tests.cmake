# README.md and docs/: what they show runs, links exist, sizes are those of today.
find_package(Python3 3.9 REQUIRED COMPONENTS Interpreter)
add_test(NAME docs.console COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_LIST_DIR}/console_blocks.py ${CMAKE_RUNTIME_OUTPUT_DIRECTORY})
add_test(NAME docs.links COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_LIST_DIR}/links.py)
add_test(NAME docs.trust_sizes COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_LIST_DIR}/trust_sizes.py ${CMAKE_RUNTIME_OUTPUT_DIRECTORY})
add_test(NAME docs.results COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_LIST_DIR}/results_test.py ${CMAKE_RUNTIME_OUTPUT_DIRECTORY})
add_test(NAME docs.paper_audit COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_LIST_DIR}/paper_audit.py ${CMAKE_RUNTIME_OUTPUT_DIRECTORY})
set_tests_properties(docs.console docs.links docs.trust_sizes docs.results docs.paper_audit PROPERTIES LABELS docs TIMEOUT 300)
