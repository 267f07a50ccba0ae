// Texts as gnuplot takes them.
#pragma once
#include <cstddef>
#include <string>

namespace ariadne::batch {

/// Of a UTF-8 text.
std::size_t lettersOf(const std::string& text);

/// Cut where it would take the room of the plot; tables have the whole name.
std::string shortened(const std::string& text);

/// In single quotes nothing but themselves means anything to gnuplot.
std::string inQuotes(const std::string& text);

/// A tick of an axis, shortened: 'label' at.
std::string tick(const std::string& label, double at);

}  // namespace ariadne::batch
