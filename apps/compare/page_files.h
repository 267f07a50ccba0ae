// The files of page/ as they were when the program was built.
#pragma once
#include <string_view>

namespace ariadne::compare_app {

extern const std::string_view kPageHtml;
extern const std::string_view kPageStyle;

}  // namespace ariadne::compare_app
