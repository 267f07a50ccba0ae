// The files of page/ as they were when the library was built.
#pragma once
#include <string_view>

namespace ariadne::batch {

extern const std::string_view kPageHtml;
extern const std::string_view kPageStyle;

}  // namespace ariadne::batch
