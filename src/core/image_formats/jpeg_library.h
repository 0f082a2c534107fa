#pragma once
// The library's header needs what comes before it.
// clang-format off
#include <cstddef>
#include <cstdio>
#include <jpeglib.h>
// clang-format on

#include <string>

#include "core/error.h"

namespace ajar::image_formats {

/// What libjpeg says, as exceptions: on x86-64 they pass through its functions, which all have
/// unwind tables. Warnings mean lost data, of which it would make grey.
inline jpeg_error_mgr* raise_errors(jpeg_error_mgr& manager) {
  jpeg_std_error(&manager);
  const auto raise = [](j_common_ptr codec) {
    char text[JMSG_LENGTH_MAX] = {};
    codec->err->format_message(codec, text);
    throw IoError("the image is damaged (" + std::string(text) + ")");
  };
  manager.error_exit = raise;
  manager.emit_message = [](j_common_ptr codec, int level) {
    if (level < 0) codec->err->error_exit(codec);
  };
  manager.output_message = [](j_common_ptr) {};
  return &manager;
}

}  // namespace ajar::image_formats
