# What reads and writes images: src/imageio/formats, and for the formats that it leaves out OpenImageIO, in a library of its own
# that is loaded when one of them is read (src/imageio/openimageio).
set(AJAR_IMAGE_LIBRARIES OpenEXR::OpenEXR PNG::PNG JPEG::JPEG)
set(AJAR_IMAGE_PACKAGES OpenEXR PNG JPEG)
find_package(OpenEXR 3 REQUIRED)
find_package(PNG REQUIRED)
find_package(JPEG REQUIRED)
if(AJAR_OPENIMAGEIO)
  find_package(OpenImageIO REQUIRED)
  # Debian 12's OpenImageIO target names OpenCV's headers, which its package does not depend on; its public
  # headers that we use do not need them, and a path that does not exist stops CMake.
  foreach(property INTERFACE_INCLUDE_DIRECTORIES INTERFACE_SYSTEM_INCLUDE_DIRECTORIES)
    get_target_property(paths OpenImageIO::OpenImageIO ${property})
    list(FILTER paths EXCLUDE REGEX "opencv")
    set_target_properties(OpenImageIO::OpenImageIO PROPERTIES ${property} "${paths}")
  endforeach()
endif()

# What is loaded goes where src/imageio/openimageio/openimageio_module.cpp looks for it.
function(ajar_openimageio_module)
  add_library(ajar_openimageio MODULE src/imageio/openimageio/module/decoder.cpp)
  target_link_libraries(ajar_openimageio PRIVATE ajar_imageio OpenImageIO::OpenImageIO)
  # Nothing of what it shares with the program is to be seen from outside.
  set_target_properties(ajar_openimageio PROPERTIES CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  target_link_options(ajar_openimageio PRIVATE LINKER:--exclude-libs,ALL)
  install(TARGETS ajar_openimageio LIBRARY DESTINATION lib/ajar)
  install(TARGETS ajar_openimageio LIBRARY DESTINATION lib/ajar COMPONENT library EXCLUDE_FROM_ALL)
  install(TARGETS ajar_openimageio LIBRARY DESTINATION lib/ajar COMPONENT python EXCLUDE_FROM_ALL)
endfunction()
