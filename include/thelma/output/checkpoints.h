#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace thelma
{

/// The last two checkpoints of a run, in its folder. A new one atomically replaces the older, so
/// that a sound one remains whenever the program dies.
///
/// A file is a line with its kind, its number and size, a checksum of both and of the content, and
/// the content.
class Checkpoints
{
public:
  explicit Checkpoints(std::string folder) : folder(std::move(folder)) {}

  /// Throws WriteError if there is no room.
  void write(const std::string& content);

  /// The newest sound one, if there is one; names the files that are damaged.
  std::optional<std::string> read(std::vector<std::string>& damaged);

  std::string newest_file() const { return name(*newest % 2); }
  bool has_any() const;
  void remove() const;

private:
  struct Content {
    std::uint64_t number;
    std::string text;
  };

  std::string name(unsigned int slot) const;
  void find_newest(std::vector<std::string>& damaged);
  static std::optional<Content> content(const std::string& file);

  std::string folder;
  bool has_searched = false;
  std::optional<std::uint64_t> newest; ///< its number; its slot is that modulo 2
};

} // namespace thelma
