# Flags for our own code, on one interface target.
add_library(bozzetto_flags INTERFACE)
target_compile_features(bozzetto_flags INTERFACE cxx_std_20)
target_compile_options(bozzetto_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Werror
  # Results do not depend on the instruction set: no fused multiply-add, no reassociation.
  -ffp-contract=off
  # Nobody reads errno; without it square roots in loops become vectors, with the same results.
  -fno-math-errno
  # False alarms of GCC 12 inside std::string (its bug 105651) and std::vector::insert.
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict -Wno-stringop-overflow>
  # Loops that are asked to vectorise may not in a build that hardly optimises.
  # Tables derived at compile time take more steps than clang allows by itself.
  $<$<CXX_COMPILER_ID:Clang>:-Wno-pass-failed -fconstexpr-steps=33554432>
  $<$<CONFIG:Release>:-O3>)
if(BOZZETTO_SANITIZE)
  target_compile_options(bozzetto_flags INTERFACE
    -fsanitize=${BOZZETTO_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer
    # GCC's documentation of -fsanitize: more false alarms of this kind.
    $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  target_link_options(bozzetto_flags INTERFACE -fsanitize=${BOZZETTO_SANITIZE})
  target_compile_definitions(bozzetto_flags INTERFACE BOZZETTO_SANITIZED)
endif()

# bozzetto_module(NAME [USES module...] [THIRD_PARTY target...] [PRIVATE target...])
# Sources are src/NAME/*.cpp (of ui: ui/*.cpp), public headers include/bozzetto/NAME/*.hpp.
function(bozzetto_module NAME)
  cmake_parse_arguments(ARG "" "" "USES;THIRD_PARTY;PRIVATE" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/src/${NAME}/*.cpp)
  set(private ${CMAKE_CURRENT_SOURCE_DIR}/src)
  if(NAME STREQUAL "ui")
    file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/ui/*.cpp)
    set(private ${CMAKE_CURRENT_SOURCE_DIR})
  endif()
  if(NOT sources)
    return()
  endif()
  add_library(bozzetto_${NAME} STATIC ${sources})
  add_library(bozzetto::${NAME} ALIAS bozzetto_${NAME})
  set_target_properties(bozzetto_${NAME} PROPERTIES EXPORT_NAME ${NAME}
                        POSITION_INDEPENDENT_CODE ON)
  target_include_directories(bozzetto_${NAME}
    PUBLIC $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>
           $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
    PRIVATE ${private})
  target_compile_features(bozzetto_${NAME} PUBLIC cxx_std_20)
  target_link_libraries(bozzetto_${NAME} PRIVATE $<BUILD_INTERFACE:bozzetto_flags> ${ARG_PRIVATE})
  target_link_libraries(bozzetto_${NAME} PUBLIC ${ARG_THIRD_PARTY})
  foreach(used IN LISTS ARG_USES)
    if(TARGET bozzetto_${used})
      target_link_libraries(bozzetto_${NAME} PUBLIC bozzetto_${used})
    endif()
  endforeach()
  if(NAME STREQUAL "base" AND BOZZETTO_WITH_TBB)
    target_compile_definitions(bozzetto_base PRIVATE BOZZETTO_WITH_TBB)
  endif()
  set_property(GLOBAL APPEND PROPERTY BOZZETTO_MODULES bozzetto_${NAME})
endfunction()

# The executable: src/cli/*.cpp.
function(bozzetto_program NAME)
  cmake_parse_arguments(ARG "" "" "USES;THIRD_PARTY" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/src/cli/*.cpp)
  if(NOT sources)
    return()
  endif()
  add_executable(${NAME} ${sources})
  target_include_directories(${NAME} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}/src)
  target_link_libraries(${NAME} PRIVATE bozzetto_flags ${ARG_THIRD_PARTY})
  target_compile_definitions(${NAME} PRIVATE BOZZETTO_VERSION="${PROJECT_VERSION}")
  foreach(used IN LISTS ARG_USES)
    if(TARGET bozzetto_${used})
      target_link_libraries(${NAME} PRIVATE bozzetto_${used})
    endif()
  endforeach()
endfunction()
