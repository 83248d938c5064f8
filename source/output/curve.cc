#include <thelma/base/error.h>
#include <thelma/output/curve.h>

#include <algorithm>
#include <fcntl.h>
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
    throw WriteError("cannot write '" + file +
                     "'; choose another --output folder or free disk space");
  }
}

bool append_to_file(const std::string& file, const std::string& text)
{
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_APPEND);
  if (descriptor < 0)
    return false;
  // One call, which no signal interrupts once it writes to a disk.
  const off_t size = lseek(descriptor, 0, SEEK_END);
  const bool done =
      ::write(descriptor, text.data(), text.size()) == static_cast<ssize_t>(text.size());
  const bool undone = done || ftruncate(descriptor, size) == 0;
  ::close(descriptor);
  if (!undone)
    throw WriteError("cannot write '" + file +
                     "'; choose another --output folder or free disk space");
  return done;
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

void Curve::set_event(const std::string& event)
{
  if (rows.back().event != event && n_written == rows.size())
    n_written = 0;
  rows.back().event = event;
}

/// The rows from @p first on, with those of the header before them if that is all.
std::string Curve::text_of(const std::size_t first) const
{
  std::ostringstream text;
  text.precision(15);
  if (first == 0) {
    for (const std::string& column : columns)
      text << column << ',';
    text << "event\n";
  }
  for (std::size_t r = first; r < rows.size(); ++r) {
    for (const double value : rows[r].values)
      text << value << ',';
    text << rows[r].event << '\n';
  }
  return text.str();
}

void Curve::write(const std::string& file)
{
  if (n_written == 0 || !append_to_file(file, text_of(n_written)))
    write_file(file, text_of(0));
  n_written = rows.size();
}

const double* Curve::newest(const std::string& column) const
{
  const auto found = std::find(columns.begin(), columns.end(), column);
  return rows.empty() || found == columns.end() ? nullptr
                                                : &rows.back().values[found - columns.begin()];
}

} // namespace thelma
