#include <thelma/application/run_command.h>
#include <thelma/base/error.h>
#include <thelma/output/curve.h>

#include <filesystem>
#include <fstream>

namespace thelma
{
namespace
{
constexpr char file_name[] = "/command.txt";
}

RunCommand RunCommand::here(const std::vector<std::string>& arguments)
{
  return {std::filesystem::current_path().string(), arguments};
}

RunCommand RunCommand::read(const std::string& folder)
{
  std::ifstream file(folder + file_name);
  RunCommand command;
  if (!std::getline(file, command.directory))
    throw InputError("command line, --restart: '" + folder +
                     "' contains no run to continue; start one with --output");
  for (std::string line; std::getline(file, line);)
    command.arguments.push_back(line);
  return command;
}

void RunCommand::write(const std::string& folder) const
{
  std::string text = directory + "\n";
  for (const std::string& argument : arguments)
    text += argument + "\n";
  write_file(folder + file_name, text);
}

std::vector<std::string> arguments_for(const std::string& file,
                                       const std::vector<Override>& overrides)
{
  std::vector<std::string> arguments{file};
  for (const Override& change : overrides) {
    arguments.emplace_back("--set");
    arguments.push_back(change.path() + "=" + change.value);
  }
  return arguments;
}

} // namespace thelma
