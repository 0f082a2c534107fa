#pragma once
#include "os/regular_file.h"

namespace ajar {

/// Text as the readers of formats take it: UTF-8 without a mark of byte order. What is in UTF-16 or
/// UTF-32, by its mark or by where its zero bytes are, is converted; all else, binary files among
/// it, is as it was. Source: The Unicode Standard, sections 3.9, 3.10 and 23.8.
FileBytes in_utf8(FileBytes bytes);

}  // namespace ajar
