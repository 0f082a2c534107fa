# cmake -DNPM=… -DFOLDER=page -DOUTPUT=folder -P build_viewer_page.cmake: bundles the page in a copy, so that the source folder
# stays as it is.
set(copy ${OUTPUT}/source)
file(GLOB sources ${FOLDER}/*)
file(COPY ${sources} DESTINATION ${copy} PATTERN node_modules EXCLUDE)
if(NOT EXISTS ${copy}/node_modules/.complete OR ${FOLDER}/package-lock.json IS_NEWER_THAN ${copy}/node_modules/.complete)
  execute_process(COMMAND ${NPM} ci --no-audit --no-fund --loglevel=error WORKING_DIRECTORY ${copy} RESULT_VARIABLE failed
    OUTPUT_QUIET)
  if(failed)
    message(FATAL_ERROR "npm could not install what bundles the page")
  endif()
  file(TOUCH ${copy}/node_modules/.complete)
endif()
execute_process(COMMAND ${NPM} run --silent build -- --outdir=${OUTPUT} WORKING_DIRECTORY ${copy} RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "the page could not be bundled")
endif()
