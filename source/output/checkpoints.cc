#include <thelma/base/error.h>
#include <thelma/output/checkpoints.h>
#include <thelma/output/curve.h>

#include <array>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <unistd.h>
#include <zlib.h>

namespace thelma
{
namespace
{

constexpr char kind[] = "Thelma checkpoint 1\n";

struct Header {
  std::uint64_t number, size, checksum;
};

std::uint64_t checksum(const std::uint64_t number, const std::string& content)
{
  const std::array<std::uint64_t, 2> numbers{{number, content.size()}};
  const auto of_numbers =
      crc32_z(0, reinterpret_cast<const Bytef*>(numbers.data()), sizeof(numbers));
  return crc32_z(of_numbers, reinterpret_cast<const Bytef*>(content.data()), content.size());
}

/// Have the system write all it holds back of a file or folder.
bool flush(const std::string& name)
{
  const int descriptor = ::open(name.c_str(), O_RDONLY);
  const bool done = descriptor >= 0 && fsync(descriptor) == 0;
  ::close(descriptor);
  return done;
}

} // namespace

std::string Checkpoints::name(const unsigned int slot) const
{
  return folder + "/checkpoint." + std::to_string(slot);
}

void Checkpoints::write(const std::string& content)
{
  std::vector<std::string> damaged;
  if (!has_searched)
    find_newest(damaged);
  const std::uint64_t number = newest ? *newest + 1 : 0;
  const std::string file = name(number % 2), temporary = folder + "/checkpoint.part";
  Header header{};
  header.number = number;
  header.size = content.size();
  header.checksum = checksum(number, content);
  std::ofstream stream(temporary, std::ios::binary);
  stream.write(kind, sizeof(kind));
  stream.write(reinterpret_cast<const char*>(&header), sizeof(header));
  stream.write(content.data(), static_cast<std::streamsize>(content.size()));
  stream.close();
  std::error_code error;
  const bool written = stream && flush(temporary);
  if (written)
    std::filesystem::rename(temporary, file, error);
  if (!written || error) {
    std::filesystem::remove(temporary, error);
    throw WriteError("cannot write the checkpoint '" + file +
                     "'; free disk space, the previous one is kept");
  }
  flush(folder);
  newest = number;
}

std::optional<Checkpoints::Content> Checkpoints::content(const std::string& file)
{
  std::ifstream stream(file, std::ios::binary);
  std::array<char, sizeof(kind)> start{};
  Header header{};
  stream.read(start.data(), start.size());
  stream.read(reinterpret_cast<char*>(&header), sizeof(header));
  if (!stream || std::memcmp(start.data(), kind, sizeof(kind)) != 0)
    return {};
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (text.size() != header.size || checksum(header.number, text) != header.checksum)
    return {};
  return Content{header.number, text};
}

void Checkpoints::find_newest(std::vector<std::string>& damaged)
{
  newest.reset();
  has_searched = true;
  for (const unsigned int slot : {0u, 1u}) {
    std::error_code unreachable;
    if (!std::filesystem::exists(name(slot), unreachable))
      continue;
    if (const auto found = content(name(slot)); !found || found->number % 2 != slot)
      damaged.push_back(name(slot));
    else if (!newest || found->number > *newest)
      newest = found->number;
  }
}

std::optional<std::string> Checkpoints::read(std::vector<std::string>& damaged)
{
  find_newest(damaged);
  if (!newest)
    return {};
  return content(newest_file())->text;
}

bool Checkpoints::has_any() const
{
  std::error_code unreachable;
  return std::filesystem::exists(name(0), unreachable) ||
         std::filesystem::exists(name(1), unreachable);
}

void Checkpoints::remove() const
{
  for (const std::string& file : {name(0), name(1), folder + "/checkpoint.part"})
    remove_file(file);
}

} // namespace thelma
