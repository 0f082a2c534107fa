# Lists the scene formats, src/import/FOLDER/format.cpp each, for `formats()` of src/import/format.h. Generated, because a linker leaves
# out what a library registers by itself, and a list by hand would name formats outside of their folders.
function(ajar_list_formats target)
  set(root ${PROJECT_SOURCE_DIR}/src/import)
  file(GLOB files CONFIGURE_DEPENDS RELATIVE ${root} ${root}/*/format.cpp)
  list(SORT files)
  set(declarations "")
  set(entries "")
  foreach(file IN LISTS files)
    get_filename_component(folder ${file} DIRECTORY)
    string(APPEND declarations "namespace ajar::${folder} {\nFormat format();\n}\n")
    string(APPEND entries "      ${folder}::format(),\n")
  endforeach()
  set(table
"#include \"import/format.h\"

${declarations}
namespace ajar {

const std::vector<Format>& formats() {
  static const std::vector<Format> kFormats{
${entries}  };
  return kFormats;
}

}  // namespace ajar
")
  set(table_file ${PROJECT_BINARY_DIR}/generated/formats.cpp)
  file(CONFIGURE OUTPUT ${table_file} CONTENT "${table}" @ONLY)
  target_sources(${target} PRIVATE ${table_file})
endfunction()
