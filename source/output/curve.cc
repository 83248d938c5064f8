#include <thelma/base/error.h>
#include <thelma/output/curve.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <unistd.h>

namespace thelma
{

void create_folder(const std::string& folder)
{
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw InputError("command line, --output: cannot create the folder '" + folder + "' (" +
                     error.message() + "); choose another one");
  if (access(folder.c_str(), W_OK | X_OK) != 0)
    throw InputError("command line, --output: cannot write into the folder '" + folder +
                     "'; choose another one");
}

void write_file(const std::string& file, const std::string& content)
{
  const std::string temporary = file + ".part";
  std::ofstream stream(temporary);
  stream << content;
  stream.close();
  std::error_code error;
  if (stream)
    std::filesystem::rename(temporary, file, error);
  if (!stream || error) {
    std::filesystem::remove(temporary, error);
    throw WriteError("cannot write '" + file + "'; choose another --output folder or make room");
  }
}

void remove_file(const std::string& file)
{
  std::error_code error;
  std::filesystem::remove(file, error);
  if (error)
    throw WriteError("cannot remove '" + file + "' (" + error.message() +
                     "); choose another --output folder");
}

void Curve::add(const std::vector<double>& values)
{
  rows.push_back({values, ""});
}

void Curve::write(const std::string& file) const
{
  std::ostringstream text;
  text.precision(15);
  for (const std::string& column : columns)
    text << column << ',';
  text << "event\n";
  for (const Row& row : rows) {
    for (const double value : row.values)
      text << value << ',';
    text << row.event << '\n';
  }
  write_file(file, text.str());
}

const double* Curve::newest(const std::string& column) const
{
  const auto found = std::find(columns.begin(), columns.end(), column);
  return rows.empty() || found == columns.end() ? nullptr
                                                : &rows.back().values[found - columns.begin()];
}

} // namespace thelma
