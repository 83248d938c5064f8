#pragma once

#include <string>
#include <vector>

namespace thelma
{

/// `set ENTRY = VALUE` in a nest of sections, at a line of a parameter file; 0: the command line.
struct Statement {
  unsigned int line;
  std::vector<std::string> sections;
  std::string entry, value;
};

/// A line that opens a section.
struct OpenedSection {
  unsigned int line;
  std::vector<std::string> path;
};

/// The text of a parameter file taken apart. `#` begins a comment, a backslash at its end continues
/// a line, runs of blanks count as one.
struct Statements {
  struct Problem {
    unsigned int line;
    std::string sentence;
  };

  explicit Statements(const std::string& text);
  Statements() = default;

  std::vector<Statement> entries;
  std::vector<OpenedSection> sections;
  std::vector<Problem> problems; ///< lines that are neither

private:
  void add(unsigned int number, const std::string& line);

  std::vector<OpenedSection> open;
};

} // namespace thelma
