# The library for programs of others, in C++ and in C (include/ajar), and the program, which is a `main` around it.
# CMake finds the library as ajar::ajar, pkg-config as ajar. Python's package is made of both.
target_include_directories(ajar_api PUBLIC ${PROJECT_SOURCE_DIR}/include)
target_compile_definitions(ajar_api PRIVATE AJAR_IMPLEMENTATION)
target_compile_definitions(ajar_api_c PRIVATE AJAR_IMPLEMENTATION)
# Its headers say nothing of visibility; library.map does.
set_target_properties(ajar_api PROPERTIES CXX_VISIBILITY_PRESET default)

add_library(ajar_library SHARED src/apps/shared/shared_command_line.cpp
  $<TARGET_OBJECTS:ajar_api> $<TARGET_OBJECTS:ajar_api_c>)
add_library(ajar::ajar ALIAS ajar_library)
target_link_libraries(ajar_library PRIVATE ajar_apps_cli)
target_include_directories(ajar_library INTERFACE $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>)
target_compile_features(ajar_library INTERFACE cxx_std_20)
set_target_properties(ajar_library PROPERTIES OUTPUT_NAME ajar EXPORT_NAME ajar
  LINK_DEPENDS ${PROJECT_SOURCE_DIR}/cmake/library.map)
# A wheel has no symbolic links: each name would be another copy.
if(NOT SKBUILD)
  set_target_properties(ajar_library PROPERTIES VERSION ${PROJECT_VERSION}
    SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
endif()
# Hidden visibility is not enough: templates of the standard library are visible, and some of their data would be one for all
# libraries of a process (STB_GNU_UNIQUE), whoever else made them.
target_link_options(ajar_library PRIVATE "LINKER:--version-script=${PROJECT_SOURCE_DIR}/cmake/library.map"
  LINKER:--exclude-libs,ALL LINKER:--gc-sections)
# Sanitizers are defined by the program.
if(NOT AJAR_SANITIZE)
  target_link_options(ajar_library PRIVATE LINKER:--no-undefined)
endif()

add_executable(ajar src/apps/shared/program.cpp)
target_link_libraries(ajar PRIVATE ajar_options ajar_library)
file(RELATIVE_PATH bin_to_lib ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
set_target_properties(ajar PROPERTIES INSTALL_RPATH "$ORIGIN/${bin_to_lib}")

# Components: program and runtime are a program that runs, runtime and library what others compile with.
install(TARGETS ajar RUNTIME COMPONENT program)
install(TARGETS ajar_library EXPORT ajar LIBRARY COMPONENT runtime NAMELINK_COMPONENT library
  INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY include/ajar TYPE INCLUDE COMPONENT library FILES_MATCHING PATTERN "*.h")

include(CMakePackageConfigHelpers)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/ajar)
set(version_file ${PROJECT_BINARY_DIR}/generated/ajar-config-version.cmake)
write_basic_package_version_file(${version_file} COMPATIBILITY SameMinorVersion)
install(EXPORT ajar NAMESPACE ajar:: FILE ajar-config.cmake DESTINATION ${package_folder} COMPONENT library)
install(FILES ${version_file} DESTINATION ${package_folder} COMPONENT library)

set(pc_folder ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
file(RELATIVE_PATH AJAR_PREFIX_FROM_PC ${CMAKE_INSTALL_PREFIX}/${pc_folder} ${CMAKE_INSTALL_PREFIX})
configure_file(cmake/ajar.pc.in ${PROJECT_BINARY_DIR}/generated/ajar.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/generated/ajar.pc DESTINATION ${pc_folder} COMPONENT library)
