# The library for programs of others: the headers of include/ajar, one static library made of all rooms up to here, and a
# CMake package by which find_package(ajar) offers it as ajar::ajar.
target_compile_definitions(ajar_api PRIVATE AJAR_IMPLEMENTATION)

get_property(rooms GLOBAL PROPERTY ajar_rooms)
set(objects "")
foreach(room IN LISTS rooms)
  string(REPLACE "/" "_" name ${room})
  get_target_property(type ajar_${name} TYPE)
  if(type STREQUAL "STATIC_LIBRARY")
    list(APPEND objects $<TARGET_OBJECTS:ajar_${name}>)
  endif()
endforeach()
add_library(ajar_library STATIC ${objects})
# What the objects need beside themselves, which users of the library must have, too: cmake/ajar-config.cmake.in.
target_link_libraries(ajar_library PRIVATE Imath::Imath embree TBB::tbb ${AJAR_IMAGE_LIBRARIES} ${CMAKE_DL_LIBS} fmt::fmt ZLIB::ZLIB
  pugixml::pugixml tinyobjloader::tinyobjloader)
target_compile_features(ajar_library INTERFACE cxx_std_20)
set_target_properties(ajar_library PROPERTIES OUTPUT_NAME ajar EXPORT_NAME ajar LINKER_LANGUAGE CXX)

include(CMakePackageConfigHelpers)
set(package_folder lib/cmake/ajar)
configure_package_config_file(cmake/ajar-config.cmake.in ${CMAKE_BINARY_DIR}/generated/ajar-config.cmake
  INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/generated/ajar-config-version.cmake COMPATIBILITY SameMinorVersion)
install(TARGETS ajar_library EXPORT ajar-targets ARCHIVE DESTINATION lib COMPONENT library INCLUDES DESTINATION include)
install(EXPORT ajar-targets NAMESPACE ajar:: DESTINATION ${package_folder} COMPONENT library)
install(DIRECTORY include/ajar DESTINATION include COMPONENT library FILES_MATCHING PATTERN "*.h")
install(FILES ${CMAKE_BINARY_DIR}/generated/ajar-config.cmake ${CMAKE_BINARY_DIR}/generated/ajar-config-version.cmake
  DESTINATION ${package_folder} COMPONENT library)
