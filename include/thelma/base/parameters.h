#pragma once

#include <thelma/base/statements.h>

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
/// Classes declare their own entries with ParameterHandler::add_parameter or, if they have a unit,
/// add_quantity, which bind a member to an entry. Entries that depend on a choice (the laws of a
/// material) become known in two steps: peek() reads the choices leniently, then everything is
/// declared and read() is strict.
class ParameterFile
{
public:
  /// Throws InputError if the file cannot be read.
  ParameterFile(std::string path, const std::vector<Override>& overrides);

  /// The same from memory, as if it were the file @p name; errors name the file @p shown.
  static ParameterFile from_text(const std::string& text, const std::string& name = "parameters",
                                 const std::string& shown = "");

  /// The same with the sections @p names alone.
  ParameterFile only(const std::vector<std::string>& names) const;

  /// Read only what @p declare declares, ignore everything else.
  void peek(const std::function<void(dealii::ParameterHandler&)>& declare) const;

  /// Read every entry into @p prm. Throws InputError with a sentence for each that is unknown or
  /// invalid, and for each line that cannot be understood, after it has read all others.
  void read(dealii::ParameterHandler& prm) const;

  /// Whether anything is set in the section @p path.
  bool has_section(const std::vector<std::string>& path) const;

  /// Names of the sections in the section @p path in which anything is set, in their order.
  std::vector<std::string> subsections(const std::vector<std::string>& path) const;

  /// Names of the entries that are set in the section @p path.
  std::vector<std::string> entries(const std::vector<std::string>& path) const;

  /// A sentence about a section with file and line before it; any other as it is.
  std::string located(const std::string& sentence) const;

  const std::string& name() const { return path; }

private:
  ParameterFile() = default;

  std::string place(unsigned int line, const std::vector<std::string>& sections) const;

  std::string path, shown;
  Statements statements;
};

/// Where the @p file named in another one is: seen from the working directory or, if there is none,
/// from @p folder, that of the other one.
std::string located(const std::string& file, const std::string& folder);

/// Let @p check look at each value of the map @p entry, of the section @p prm stands in, when it is
/// read; what it throws gets the place added.
void check_values(dealii::ParameterHandler& prm, const std::string& entry,
                  const std::function<void(const std::string&)>& check);

/// Enters a (possibly nested) subsection for the lifetime of the object.
class Section
{
public:
  Section(dealii::ParameterHandler& prm, const std::vector<std::string>& path);
  ~Section();
  Section(const Section&) = delete;
  Section& operator=(const Section&) = delete;

private:
  dealii::ParameterHandler& prm;
  std::size_t depth;
};

} // namespace thelma
