# The page of `ajar view`: TypeScript, bundled by esbuild, which npm installs as package-lock.json says. Without Node, or without
# a network the first time, the program has no page, and `ajar view` says so.
set(page_folder ${PROJECT_SOURCE_DIR}/src/apps/viewer/page)
set(page_output ${PROJECT_BINARY_DIR}/viewer_page)
find_program(AJAR_NODE node)
find_program(AJAR_NPM npm)
set(page_files "")
if(AJAR_NODE AND AJAR_NPM AND EXISTS ${page_folder}/package.json)
  file(MAKE_DIRECTORY ${page_output})
  file(GLOB page_sources CONFIGURE_DEPENDS ${page_folder}/*)
  execute_process(
    COMMAND ${CMAKE_COMMAND} -DNPM=${AJAR_NPM} -DFOLDER=${page_folder} -DOUTPUT=${page_output}
      -P ${PROJECT_SOURCE_DIR}/cmake/build_viewer_page.cmake
    RESULT_VARIABLE page_failed)
  if(page_failed EQUAL 0)
    set(page_files index.html viewer.css viewer.js)
    add_custom_command(OUTPUT ${page_output}/viewer.js ${page_output}/viewer.css ${page_output}/index.html
      COMMAND ${CMAKE_COMMAND} -DNPM=${AJAR_NPM} -DFOLDER=${page_folder} -DOUTPUT=${page_output}
        -P ${PROJECT_SOURCE_DIR}/cmake/build_viewer_page.cmake
      DEPENDS ${page_sources} COMMENT "Bundling the page of ajar view" VERBATIM)
  else()
    message(STATUS "The page of ajar view could not be bundled: the program is built without it")
  endif()
else()
  message(STATUS "Node or npm is not here: the program is built without the page of ajar view")
endif()
ajar_embed(ajar_apps_viewer viewer_files viewer::ServedFile apps/viewer/viewer.h ${page_output} ${page_files})
