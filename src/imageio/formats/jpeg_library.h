#pragma once
// The library's header needs what comes before it.
// clang-format off
#include <cstddef>
#include <cstdio>
#include <jpeglib.h>
// clang-format on

#include "imageio/formats/library_calls.h"

namespace ajar::image_formats {

/// Its calls, and what it does about errors: it ends them. Warnings mean lost data, of which it
/// would make grey; they are errors.
struct JpegCalls : jpeg_error_mgr, LibraryCalls {
  explicit JpegCalls(const char* failure) : jpeg_error_mgr{}, LibraryCalls(failure) {
    jpeg_std_error(this);
    error_exit = [](j_common_ptr codec) {
      char text[JMSG_LENGTH_MAX] = {};
      codec->err->format_message(codec, text);
      of(codec).fail(text);
    };
    emit_message = [](j_common_ptr codec, int level) {
      if (level < 0) codec->err->error_exit(codec);
    };
    output_message = [](j_common_ptr) {};
  }
  template <typename Codec>
  static JpegCalls& of(Codec* codec) {
    return static_cast<JpegCalls&>(*codec->err);
  }
};

}  // namespace ajar::image_formats
