# The starter tools travel inside the library: data/tools/* become one generated table of
# (name, text), made anew at build time's configure when a file changes.
function(bozzetto_embed_starters NAME)
  if(NOT TARGET bozzetto_${NAME})
    return()
  endif()
  file(GLOB files CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/data/tools/*.json
       ${CMAKE_CURRENT_SOURCE_DIR}/data/tools/*.jsonl)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${files})
  set(table "")
  foreach(file IN LISTS files)
    get_filename_component(title ${file} NAME)
    file(READ ${file} text)
    string(APPEND table "    {\"${title}\", R\"tool(${text})tool\"},\n")
  endforeach()
  set(generated ${CMAKE_CURRENT_BINARY_DIR}/generated/${NAME}/starter_files.cpp)
  file(CONFIGURE OUTPUT ${generated} @ONLY NEWLINE_STYLE UNIX CONTENT
"#include \"${NAME}/starters.hpp\"

namespace bozzetto {

std::span<const StarterFile> starterFiles() {
  static constexpr StarterFile kFiles[] = {
${table}  };
  return kFiles;
}

}  // namespace bozzetto
")
  target_sources(bozzetto_${NAME} PRIVATE ${generated})
endfunction()
