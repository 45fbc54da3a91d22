# A fresh prefix: nothing that an older install left may help the example.
file(REMOVE_RECURSE ${PREFIX} ${BUILD}/installed-example)
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${PREFIX}
                COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
