# What users get: the installation, programs built against it, the Debian package.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
add_test(NAME install COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_LIST_DIR}/install_test.py ${PROJECT_BINARY_DIR} ${CMAKE_CXX_COMPILER})
set_tests_properties(install PROPERTIES LABELS install TIMEOUT 600 SKIP_RETURN_CODE 77)
