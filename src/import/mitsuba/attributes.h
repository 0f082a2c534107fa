#pragma once
#include "core/warnings.h"
#include "import/mitsuba/xml_file.h"

namespace ajar::mitsuba {

/// Warns of attributes that elements of Mitsuba's scenes do not have, with the nearest name that
/// they have, of attributes that say the same twice, and of elements in others that have none in
/// them. Values are not looked at, and neither are elements of other names.
void check_attributes(const XmlFile& file, Warnings& warnings);

}  // namespace ajar::mitsuba
