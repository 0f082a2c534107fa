# Embeds the files of every scenes/<name>/ that has a scene.* into a library: an assembler file that includes the bytes, and a table that
# src/session/scenes/builtin_scenes.h offers.
function(ajar_embed_scenes target)
  set(folder ${PROJECT_SOURCE_DIR}/scenes)
  file(GLOB scenes CONFIGURE_DEPENDS RELATIVE ${folder} ${folder}/*/scene.*)
  set(files "")
  foreach(scene IN LISTS scenes)
    string(REGEX REPLACE "/scene\\.[^/]*$" "" scene "${scene}")
    file(GLOB_RECURSE scene_files CONFIGURE_DEPENDS RELATIVE ${folder} ${folder}/${scene}/*)
    list(APPEND files ${scene_files})
  endforeach()
  list(FILTER files EXCLUDE REGEX "(^|/)\\.|\\.md$|\\.py$")
  list(SORT files)

  set(data "    .section .rodata\n")
  set(declarations "")
  set(entries "")
  set(dependencies "")
  set(index 0)
  foreach(file IN LISTS files)
    string(REGEX REPLACE "/.*" "" scene "${file}")
    string(REGEX REPLACE "^[^/]*/" "" path "${file}")
    string(APPEND data
      "    .global ajar_file_${index}\n    .global ajar_file_${index}_end\n    .balign 16\n"
      "ajar_file_${index}:\n    .incbin \"${folder}/${file}\"\najar_file_${index}_end:\n    .byte 0\n")
    string(APPEND declarations "extern const char ajar_file_${index}[];\nextern const char ajar_file_${index}_end[];\n")
    string(APPEND entries
      "      {\"${scene}\", \"${path}\", bytes(ajar_file_${index}, ajar_file_${index}_end)},\n")
    list(APPEND dependencies ${folder}/${file})
    math(EXPR index "${index} + 1")
  endforeach()
  string(APPEND data "    .section .note.GNU-stack,\"\",%progbits\n")
  # An array cannot be empty, a vector can.
  set(table
"#include <vector>

#include \"session/scenes/builtin_scenes.h\"

extern \"C\" {
${declarations}}

namespace ajar {

std::span<const EmbeddedFile> embedded_files() {
  [[maybe_unused]] const auto bytes = [](const char* begin, const char* end) {
    return std::string_view(begin, static_cast<std::size_t>(end - begin));
  };
  static const std::vector<EmbeddedFile> files{
${entries}  };
  return files;
}

}  // namespace ajar
")
  set(assembly_file ${PROJECT_BINARY_DIR}/generated/embedded_scenes.S)
  set(table_file ${PROJECT_BINARY_DIR}/generated/embedded_scenes.cpp)
  file(CONFIGURE OUTPUT ${assembly_file} CONTENT "${data}" @ONLY)
  file(CONFIGURE OUTPUT ${table_file} CONTENT "${table}" @ONLY)
  set_source_files_properties(${assembly_file} PROPERTIES OBJECT_DEPENDS "${dependencies}")
  target_sources(${target} PRIVATE ${assembly_file} ${table_file})
endfunction()
