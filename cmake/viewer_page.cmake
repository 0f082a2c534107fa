# The page of `ajar view`: TypeScript, bundled by esbuild, which npm installs as package-lock.json says. Without Node, or without
# a network the first time, the program has no page, and `ajar view` says so.
set(page_output ${PROJECT_BINARY_DIR}/viewer_page)
set(page_files index.html viewer.css viewer.js)
find_program(AJAR_NPM npm)
set(bundle ${CMAKE_COMMAND} -DNPM=${AJAR_NPM} -DSOURCE=${PROJECT_SOURCE_DIR}/src -DOUTPUT=${page_output}
  -P ${PROJECT_SOURCE_DIR}/cmake/build_viewer_page.cmake)
if(AJAR_NPM)
  execute_process(COMMAND ${bundle} RESULT_VARIABLE page_failed)
endif()
if(AJAR_NPM AND page_failed EQUAL 0)
  file(GLOB page_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/apps/viewer/page/*.*
    ${PROJECT_SOURCE_DIR}/src/study/report/page/*.js)
  set(page_outputs ${page_files})
  list(TRANSFORM page_outputs PREPEND ${page_output}/)
  add_custom_command(OUTPUT ${page_outputs} COMMAND ${bundle} DEPENDS ${page_sources}
    COMMENT "Bundling the page of ajar view" VERBATIM)
else()
  set(page_files "")
  message(STATUS "npm is not here, or could not bundle the page of ajar view: the program is built without it")
endif()
ajar_embed(ajar_apps_viewer viewer_files viewer::ServedFile apps/viewer/viewer.h ${page_output} ${page_files})
