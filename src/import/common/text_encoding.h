#pragma once
#include "os/regular_file.h"

namespace ajar {

/// Text as the readers of formats take it: UTF-8 without a byte order mark. UTF-16 and UTF-32,
/// recognised by a mark or by their zero bytes, are converted; other bytes are unchanged. Source:
/// The Unicode Standard, sections 3.9, 3.10 and 23.8.
FileBytes in_utf8(FileBytes bytes);

}  // namespace ajar
