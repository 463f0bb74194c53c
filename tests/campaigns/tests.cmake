# Campaigns: fixed seeds of every family, the runner, shrinking, searching.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
add_test(NAME campaigns.runner COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_LIST_DIR}/campaign_test.py ${CMAKE_RUNTIME_OUTPUT_DIRECTORY})
add_test(NAME campaigns.replay COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_LIST_DIR}/replay_test.py ${CMAKE_RUNTIME_OUTPUT_DIRECTORY})
set_tests_properties(campaigns.runner campaigns.replay PROPERTIES LABELS campaigns TIMEOUT 900)
