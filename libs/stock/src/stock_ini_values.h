// Values of an INI as MRPT's CConfigFileBase reads them, except that rubbish is an error.
#pragma once
#include <string>
#include <vector>

#include "ariadne/io/ini_text.h"

namespace ariadne::stock {

/// The number that the value starts with. Throws core::UsageError when there is none.
double mrptNumber(const io::IniEntry& entry);
int mrptInteger(const io::IniEntry& entry);
bool mrptBool(const io::IniEntry& entry);
/// The index of the name, or the number itself when it is one of 0 .. names.size() - 1.
std::size_t mrptEnum(const io::IniEntry& entry, const std::vector<std::string>& names);

}  // namespace ariadne::stock
