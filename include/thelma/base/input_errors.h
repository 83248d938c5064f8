#pragma once

#include <thelma/base/error.h>

#include <string>
#include <vector>

namespace thelma
{

/// Collects what is wrong with the input, so that all of it is reported at once: independent steps
/// run one after the other, then raise() throws.
class InputErrors
{
public:
  /// Run @p action and collect its InputError. Whether there was none.
  template <typename Action>
  bool collect(const Action& action)
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
  void add_unexplained(const InputErrors& found);

  const std::vector<std::string>& sentences() const { return list; }

  /// Throws InputError if there is any.
  void raise() const;

private:
  std::vector<std::string> list;
};

} // namespace thelma
