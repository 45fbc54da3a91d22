# Files that travel inside a library: they become one generated table of (name, text), made anew at
# build time's configure when a file changes.
#   bozzetto_embed(MODULE HEADER name TYPE Struct FUNCTION name TITLE NAME|NAME_WLE FILES glob...)
# MODULE/HEADER.hpp declares the struct and `std::span<const Struct> function()`.
function(bozzetto_embed MODULE)
  if(NOT TARGET bozzetto_${MODULE})
    return()
  endif()
  cmake_parse_arguments(ARG "" "HEADER;TYPE;FUNCTION;TITLE" "FILES" ${ARGN})
  list(TRANSFORM ARG_FILES PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
  file(GLOB files CONFIGURE_DEPENDS ${ARG_FILES})
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${files})
  set(table "")
  foreach(file IN LISTS files)
    get_filename_component(title ${file} ${ARG_TITLE})
    file(READ ${file} text)
    string(APPEND table "    {\"${title}\", R\"file(${text})file\"},\n")
  endforeach()
  set(generated ${CMAKE_CURRENT_BINARY_DIR}/generated/${MODULE}/${ARG_HEADER}.cpp)
  file(CONFIGURE OUTPUT ${generated} @ONLY NEWLINE_STYLE UNIX CONTENT
"#include \"${MODULE}/${ARG_HEADER}.hpp\"

namespace bozzetto {

std::span<const ${ARG_TYPE}> ${ARG_FUNCTION}() {
  static constexpr ${ARG_TYPE} kFiles[] = {
${table}  };
  return kFiles;
}

}  // namespace bozzetto
")
  target_sources(bozzetto_${MODULE} PRIVATE ${generated})
endfunction()
