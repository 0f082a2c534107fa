# What reads and writes images: src/imageio/formats.
find_package(OpenEXR 3 REQUIRED)
find_package(PNG REQUIRED)
find_package(JPEG REQUIRED)
find_package(TIFF REQUIRED)
# Debian 12 has no CMake package of these.
find_library(WEBP_LIBRARY webp REQUIRED)
find_path(WEBP_INCLUDE_DIR webp/decode.h REQUIRED)
find_path(STB_INCLUDE_DIR stb/stb_image.h REQUIRED)
set(AJAR_IMAGE_LIBRARIES OpenEXR::OpenEXR PNG::PNG JPEG::JPEG TIFF::TIFF ${WEBP_LIBRARY})
set(AJAR_IMAGE_INCLUDE_DIRS ${WEBP_INCLUDE_DIR} ${STB_INCLUDE_DIR})
