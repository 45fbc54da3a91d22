# cmake --install, then find_package(bozzetto) and bozzetto::sculptor.
include(CMakePackageConfigHelpers)
get_property(modules GLOBAL PROPERTY BOZZETTO_MODULES)
install(TARGETS ${modules} EXPORT bozzettoTargets)
if(TARGET bozzetto)
  install(TARGETS bozzetto)
endif()
install(DIRECTORY include/bozzetto DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT bozzettoTargets NAMESPACE bozzetto::
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/bozzetto)
configure_package_config_file(cmake/bozzettoConfig.cmake.in
  ${CMAKE_CURRENT_BINARY_DIR}/bozzettoConfig.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/bozzetto)
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/bozzettoConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/bozzettoConfig.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/bozzettoConfigVersion.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/bozzetto)
