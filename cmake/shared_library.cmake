# The library as other languages load it: one file with the C face (include/ajar/c.h) and nothing else to be seen from outside, and the
# program around it. Python's package is made of both.
add_library(ajar_shared SHARED src/apps/shared/shared_command_line.cpp $<TARGET_OBJECTS:ajar_api_c>)
target_link_libraries(ajar_shared PRIVATE ajar_api ajar_cli)
set_target_properties(ajar_shared PROPERTIES OUTPUT_NAME ajar
  LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/shared/lib
  LINK_DEPENDS ${CMAKE_SOURCE_DIR}/cmake/shared_library.map)
# Hidden visibility is not enough: templates of the standard library are visible, and some of their data would be one for all
# libraries of a process (STB_GNU_UNIQUE), whoever else made them.
target_link_options(ajar_shared PRIVATE "LINKER:--version-script=${CMAKE_SOURCE_DIR}/cmake/shared_library.map"
  LINKER:--exclude-libs,ALL LINKER:--no-undefined LINKER:--gc-sections)

add_executable(ajar_shared_program src/apps/shared/program.cpp)
target_link_libraries(ajar_shared_program PRIVATE ajar_options ajar_shared)
set_target_properties(ajar_shared_program PROPERTIES OUTPUT_NAME ajar INSTALL_RPATH "$ORIGIN/../lib"
  BUILD_WITH_INSTALL_RPATH ON RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/shared/bin)

install(TARGETS ajar_shared LIBRARY DESTINATION lib COMPONENT python)
install(TARGETS ajar_shared_program RUNTIME DESTINATION bin COMPONENT python)
