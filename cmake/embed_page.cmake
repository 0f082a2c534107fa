# Embeds the files of src/study/report/page/ into a library: an assembler file that includes the bytes, and the table that
# src/study/report/page_files.h offers.
function(ajar_embed_page target)
  set(folder ${PROJECT_SOURCE_DIR}/src/study/report/page)
  file(GLOB files CONFIGURE_DEPENDS RELATIVE ${folder} ${folder}/*.html ${folder}/*.css ${folder}/*.js)
  list(SORT files)
  set(data "    .section .rodata\n")
  set(declarations "")
  set(entries "")
  set(dependencies "")
  set(index 0)
  foreach(file IN LISTS files)
    set(symbol ajar_page_${index})
    string(APPEND data "    .global ${symbol}\n    .global ${symbol}_end\n${symbol}:\n"
      "    .incbin \"${folder}/${file}\"\n${symbol}_end:\n    .byte 0\n")
    string(APPEND declarations "extern const char ${symbol}[];\nextern const char ${symbol}_end[];\n")
    string(APPEND entries
      "      {\"${file}\", {${symbol}, static_cast<std::size_t>(${symbol}_end - ${symbol})}},\n")
    list(APPEND dependencies ${folder}/${file})
    math(EXPR index "${index} + 1")
  endforeach()
  string(APPEND data "    .section .note.GNU-stack,\"\",%progbits\n")
  set(table
"#include <vector>

#include \"study/report/page_files.h\"

extern \"C\" {
${declarations}}

namespace ajar {

std::span<const PageFile> page_files() {
  static const std::vector<PageFile> files{
${entries}  };
  return files;
}

}  // namespace ajar
")
  set(assembly_file ${PROJECT_BINARY_DIR}/generated/embedded_page.S)
  set(table_file ${PROJECT_BINARY_DIR}/generated/embedded_page.cpp)
  file(CONFIGURE OUTPUT ${assembly_file} CONTENT "${data}" @ONLY)
  file(CONFIGURE OUTPUT ${table_file} CONTENT "${table}" @ONLY)
  set_source_files_properties(${assembly_file} PROPERTIES OBJECT_DEPENDS "${dependencies}")
  target_sources(${target} PRIVATE ${assembly_file} ${table_file})
endfunction()
