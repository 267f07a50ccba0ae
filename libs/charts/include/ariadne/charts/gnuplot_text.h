// Texts and colours as gnuplot takes them.
#pragma once
#include <cstddef>
#include <string>

namespace ariadne::charts {

/// Of a UTF-8 text.
std::size_t lettersOf(const std::string& text);

/// Cut where it would take the room of the plot; tables have the whole name.
std::string shortened(const std::string& text);

/// In single quotes nothing but themselves means anything to gnuplot.
std::string inQuotes(const std::string& text);

/// A tick of an axis, shortened: 'label' at.
std::string tick(const std::string& label, double at);

/// Of Okabe and Ito's, told apart by the colour-blind too; without black, the axes' colour, and
/// yellow, which is hard to see on white. Seven, then again the first.
const char* colourOf(std::size_t i);

}  // namespace ariadne::charts
