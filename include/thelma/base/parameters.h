#pragma once

#include <deal.II/base/parameter_handler.h>

#include <functional>
#include <string>
#include <vector>

namespace thelma
{

/// One `Section/Subsection/Entry=value` from the command line.
struct Override {
  std::vector<std::string> sections;
  std::string entry;
  std::string value;

  /// Throws InputError when @p text has not this form.
  static Override parse(const std::string& text);

  std::string path() const;
};

/// A .prm file and the overrides that follow it.
///
/// Classes declare their own entries with ParameterHandler::add_parameter, which binds a member to
/// an entry. Entries that depend on a choice (the laws of a material) become known in two steps:
/// peek() reads the choices leniently, then everything is declared and read() is strict.
class ParameterFile
{
public:
  /// Throws InputError if the file cannot be read.
  ParameterFile(std::string path, const std::vector<Override>& overrides);

  /// The same from memory.
  static ParameterFile from_text(const std::string& text);

  /// Read only what @p declare declares, ignore everything else.
  void peek(const std::function<void(dealii::ParameterHandler&)>& declare) const;

  /// Read every entry into @p prm; throws InputError for the first one that is unknown or invalid.
  void read(dealii::ParameterHandler& prm) const;

  const std::string& name() const { return path; }

private:
  ParameterFile() = default;

  std::string path;
  std::string text;
  unsigned int n_file_lines = 0;
};

/// Where the @p file named in another one is: seen from the working directory or, if there is none,
/// from @p folder, that of the other one.
std::string located(const std::string& file, const std::string& folder);

/// Enters a (possibly nested) subsection for the lifetime of the object.
class Section
{
public:
  Section(dealii::ParameterHandler& prm, std::vector<std::string> path);
  ~Section();
  Section(const Section&) = delete;
  Section& operator=(const Section&) = delete;

private:
  dealii::ParameterHandler& prm;
  std::size_t depth;
};

} // namespace thelma
