// The documents' glossary (doc/explanation/concepts.md), for words that are explained on a page.
#pragma once
#include <string>
#include <string_view>

namespace ariadne::page {

/// What a term of the glossary means; empty for a word that it has not.
std::string_view meaningOf(std::string_view term);

/// The text as HTML. Where one of its words names something of the glossary (`ate_rmse_m`, "Neff",
/// "arm"), the meaning of the first shows when somebody points at the text.
std::string explained(const std::string& text);

}  // namespace ariadne::page
