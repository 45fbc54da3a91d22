# Installs into a folder of its own, then builds and runs the ten-line example against it.
set(prefix ${CMAKE_BINARY_DIR}/installed)
add_test(NAME install.Library COMMAND ${CMAKE_COMMAND} -DPREFIX=${prefix}
         -DBUILD=${CMAKE_BINARY_DIR} -P ${CMAKE_SOURCE_DIR}/tests/install/install.cmake)
add_test(NAME install.Example
         COMMAND ${CMAKE_CTEST_COMMAND}
         --build-and-test ${CMAKE_SOURCE_DIR}/tests/install ${CMAKE_BINARY_DIR}/installed-example
         --build-generator ${CMAKE_GENERATOR} --build-noclean
         --build-options -DCMAKE_PREFIX_PATH=${prefix} -DCMAKE_BUILD_TYPE=${CMAKE_BUILD_TYPE}
                         -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}
         --test-command example)
set_tests_properties(install.Library PROPERTIES LABELS install FIXTURES_SETUP installed)
set_tests_properties(install.Example PROPERTIES LABELS install FIXTURES_REQUIRED installed
                     PASS_REGULAR_EXPRESSION "[0-9]+ triangles written")
