# What can be said about proofs/coq without Coq: docs name what exists, nothing is left unproved. The proofs themselves: ./run proofs.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
add_test(NAME proofs.pages COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_LIST_DIR}/pages_test.py)
set_tests_properties(proofs.pages PROPERTIES LABELS docs TIMEOUT 60)
