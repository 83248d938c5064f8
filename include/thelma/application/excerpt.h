#pragma once

#include <string>

namespace thelma
{

/// The paragraphs and items of @p text that have @p word, each item under its heading: headings
/// begin a line, items stand two blanks in, and what belongs to them farther. Capitals do not
/// count.
std::string items_with(const std::string& text, const std::string& word);

/// The subsections and entries of a printed parameter file whose names have @p word, with all that
/// is in them and what is said of them. Capitals do not count.
std::string entries_with(const std::string& parameters, const std::string& word);

} // namespace thelma
