# Pages that the program writes of itself: man pages and completions of the shell, made by the build and installed
# where their readers look, and the test that docs/ says the same. Not in builds with sanitizers, which are not for use.
if(AJAR_SANITIZE)
  return()
endif()
find_package(Python3 REQUIRED COMPONENTS Interpreter)
set(pages_folder ${PROJECT_BINARY_DIR}/pages)
set(pages_scripts ${PROJECT_SOURCE_DIR}/cmake/pages)
add_custom_command(OUTPUT ${pages_folder}/man1/ajar.1
  COMMAND ${Python3_EXECUTABLE} -B ${pages_scripts}/shell_pages.py $<TARGET_FILE:ajar> ${pages_folder}
  DEPENDS ajar ${pages_scripts}/shell_pages.py ${pages_scripts}/program_help.py
  COMMENT "Writing man pages and completions")
add_custom_target(ajar_pages ALL DEPENDS ${pages_folder}/man1/ajar.1)
install(DIRECTORY ${pages_folder}/man1 TYPE MAN)
install(FILES ${pages_folder}/bash/ajar DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(FILES ${pages_folder}/zsh/_ajar DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions)
install(FILES ${pages_folder}/fish/ajar.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)

add_test(NAME shell_pages COMMAND ${Python3_EXECUTABLE} -B ${pages_scripts}/shell_pages_test.py $<TARGET_FILE:ajar>)
add_test(NAME docs COMMAND ${Python3_EXECUTABLE} -B ${PROJECT_SOURCE_DIR}/cmake/check_docs.py ${PROJECT_SOURCE_DIR} $<TARGET_FILE:ajar>)
set_tests_properties(shell_pages docs PROPERTIES LABELS "pages;quick")
