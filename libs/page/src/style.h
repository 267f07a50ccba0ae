// The style sheet of all our pages.
#pragma once
#include <string_view>

namespace ariadne::page {

/// libs/page/page.css as it was when the library was built.
extern const std::string_view kStyle;

}  // namespace ariadne::page
