#pragma once

#include <string>
#include <vector>

namespace thelma
{

/// The table curve.csv: a row per accepted step, columns `name_unit`, the last one `event`.
class Curve
{
public:
  explicit Curve(std::vector<std::string> columns) : columns(std::move(columns)) {}

  /// @p values has one number per column.
  void add(const std::vector<double>& values);

  /// Mark the newest row.
  void set_event(const std::string& event);

  /// Bring @p file, always the same one, up to date: append the rows that it lacks or, if that is
  /// not enough, replace it; both atomically.
  /// Throws WriteError if there is no room.
  void write(const std::string& file);

  bool empty() const { return rows.empty(); }
  std::size_t n_rows() const { return rows.size(); }
  const std::vector<std::string>& names() const { return columns; }

  /// Newest value of @p column, or nothing if there is no such column or row.
  const double* newest(const std::string& column) const;

  template <class Archive>
  void serialize(Archive& archive, unsigned int)
  {
    archive& rows;
  }

private:
  struct Row {
    std::vector<double> values;
    std::string event;

    template <class Archive>
    void serialize(Archive& archive, unsigned int)
    {
      archive& values& event;
    }
  };
  std::string text_of(std::size_t first) const;

  std::vector<std::string> columns;
  std::vector<Row> rows;
  std::size_t n_written = 0; ///< rows as they stand in the file
};

/// Throws InputError if the folder cannot be created or written into.
void create_folder(const std::string& folder);

/// Append @p text to @p file atomically. Whether that succeeded.
bool append_to_file(const std::string& file, const std::string& text);

/// Write @p content to @p file through a temporary file, so that a reader never sees half of it.
/// Throws WriteError if there is no room.
void write_file(const std::string& file, const std::string& content);

/// Remove @p file if it is there. Throws WriteError if it cannot be removed.
void remove_file(const std::string& file);

} // namespace thelma
