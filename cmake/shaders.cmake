# Shaders live as .glsl files and travel inside the library: src/NAME/shaders/*.glsl become one
# generated table of (name, text), made anew at build time's configure when a file changes.
function(bozzetto_embed_shaders NAME)
  if(NOT TARGET bozzetto_${NAME})
    return()
  endif()
  file(GLOB shaders CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/src/${NAME}/shaders/*.glsl)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${shaders})
  set(table "")
  foreach(shader IN LISTS shaders)
    get_filename_component(title ${shader} NAME_WLE)
    file(READ ${shader} text)
    string(APPEND table "    {\"${title}\", R\"glsl(${text})glsl\"},\n")
  endforeach()
  set(generated ${CMAKE_CURRENT_BINARY_DIR}/generated/${NAME}/shader_files.cpp)
  file(CONFIGURE OUTPUT ${generated} @ONLY NEWLINE_STYLE UNIX CONTENT
"#include \"${NAME}/shader_files.hpp\"

namespace bozzetto {

std::span<const ShaderFile> shaderFiles() {
  static constexpr ShaderFile kFiles[] = {
${table}  };
  return kFiles;
}

}  // namespace bozzetto
")
  target_sources(bozzetto_${NAME} PRIVATE ${generated})
endfunction()
