# Embeds files of `folder` into a library: an assembler file that includes their bytes, and a function `name` that `header`
# declares, of entries {path, bytes} of `type`, or {first folder, rest of the path, bytes}.
function(ajar_embed target name type header folder)
  set(data "    .section .rodata\n")
  set(declarations "")
  set(entries "")
  set(dependencies "")
  set(index 0)
  foreach(file IN LISTS ARGN)
    set(symbol ajar_${name}_${index})
    string(REGEX REPLACE "^([^/]*)/" "\\1\", \"" path "${file}")
    string(APPEND data
      "    .global ${symbol}\n    .global ${symbol}_end\n    .balign 16\n"
      "${symbol}:\n    .incbin \"${folder}/${file}\"\n${symbol}_end:\n    .byte 0\n")
    string(APPEND declarations "extern const char ${symbol}[];\nextern const char ${symbol}_end[];\n")
    string(APPEND entries
      "      {\"${path}\", {${symbol}, static_cast<std::size_t>(${symbol}_end - ${symbol})}},\n")
    list(APPEND dependencies ${folder}/${file})
    math(EXPR index "${index} + 1")
  endforeach()
  string(APPEND data "    .section .note.GNU-stack,\"\",%progbits\n")
  # An array cannot be empty, a vector can.
  set(table
"#include <vector>

#include \"${header}\"

extern \"C\" {
${declarations}}

namespace ajar {

std::span<const ${type}> ${name}() {
  static const std::vector<${type}> files{
${entries}  };
  return files;
}

}  // namespace ajar
")
  set(assembly_file ${PROJECT_BINARY_DIR}/generated/${name}.S)
  set(table_file ${PROJECT_BINARY_DIR}/generated/${name}.cpp)
  file(CONFIGURE OUTPUT ${assembly_file} CONTENT "${data}" @ONLY)
  file(CONFIGURE OUTPUT ${table_file} CONTENT "${table}" @ONLY)
  set_source_files_properties(${assembly_file} PROPERTIES OBJECT_DEPENDS "${dependencies}")
  target_sources(${target} PRIVATE ${assembly_file} ${table_file})
endfunction()

# Every scenes/NAME/ that has a scene.*.
set(folder ${PROJECT_SOURCE_DIR}/scenes)
file(GLOB scenes CONFIGURE_DEPENDS RELATIVE ${folder} ${folder}/*/scene.*)
set(files "")
foreach(scene IN LISTS scenes)
  get_filename_component(scene ${scene} DIRECTORY)
  file(GLOB_RECURSE scene_files CONFIGURE_DEPENDS RELATIVE ${folder} ${folder}/${scene}/*)
  list(APPEND files ${scene_files})
endforeach()
list(FILTER files EXCLUDE REGEX "(^|/)\\.|\\.md$|\\.py$")
list(SORT files)
ajar_embed(ajar_session embedded_files EmbeddedFile session/scenes/builtin_scenes.h ${folder} ${files})

# The page of reports.
set(folder ${PROJECT_SOURCE_DIR}/src/study/report/page)
file(GLOB files CONFIGURE_DEPENDS RELATIVE ${folder} ${folder}/*.html ${folder}/*.css ${folder}/*.js)
list(SORT files)
ajar_embed(ajar_study_report page_files PageFile study/report/page_files.h ${folder} ${files})
