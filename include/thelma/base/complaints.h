#pragma once

#include <thelma/base/error.h>

#include <string>
#include <vector>

namespace thelma
{

/// Gathers what is wrong with the input, so that all of it is said at once: steps that do not need
/// each other are tried one after the other, then raise() throws.
class Complaints
{
public:
  /// Whether @p action ends without an InputError; that is kept.
  template <typename Action>
  bool allow(const Action& action)
  {
    try {
      action();
      return true;
    } catch (const InputError& error) {
      for (const std::string& sentence : error.sentences())
        add(sentence);
      return false;
    }
  }

  /// Says nothing twice.
  void add(const std::string& sentence);

  /// Add those of @p found that nothing said so far explains: what seems to be missing may only be
  /// misspelt, and what an entry means may hang on a choice beside it.
  void add_unexplained(const Complaints& found);

  const std::vector<std::string>& sentences() const { return list; }

  /// Throws InputError if there is any.
  void raise() const;

private:
  std::vector<std::string> list;
};

} // namespace thelma
