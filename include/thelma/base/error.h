#pragma once

#include <deal.II/base/mpi.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace thelma
{

/// Exit codes of the program (README, "Exit codes").
enum class ExitCode {
  success = 0,
  bad_input = 1,
  expectation_failed = 2,
  not_converged = 3,
  stopped = 4,
  internal_error = 70
};

/// The user asked for something impossible; what() is one sentence that names the place, the value
/// and the remedy, or several, one to a line. Thrown by every rank of a run alike, so that none
/// waits for the others. A sentence that begins with `section A/B, entry 'C': ` gets the line of
/// the parameter file added.
class InputError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
  explicit InputError(const std::vector<std::string>& sentences);

  std::vector<std::string> sentences() const;
};

/// A file cannot be written, for one because the disk is full; nothing is wrong with the scene.
class WriteError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// What to say of std::bad_alloc.
constexpr char out_of_memory[] =
    "out of memory; choose a coarser mesh in the section Mesh, or a machine with more";

/// A factorisation does not fit into memory, which no shorter step changes. Thrown by every rank of
/// a run alike.
class OutOfMemory : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// @p value as a sentence has it, with at most six digits: `293`, `-0.5`, `1e-09`.
std::string as_text(double value);

/// `a, b, c`, the tail of every "known ones are" sentence.
std::string comma_separated(const std::vector<std::string>& words);

/// The one of @p known that @p word is most likely a misspelling of; empty if there is none.
std::string closest(const std::string& word, const std::vector<std::string>& known);

/// `; did you mean 'b'? Known: a, b, c`, the end of a sentence about an unknown @p word.
std::string did_you_mean(const std::string& word, const std::vector<std::string>& known);

/// Run @p action on rank 0 of @p comm alone and let every rank throw the InputError or WriteError
/// it may have thrown.
template <typename Action>
void on_rank_0(const MPI_Comm comm, Action action)
{
  std::string complaint;
  bool is_about_writing = false;
  if (dealii::Utilities::MPI::this_mpi_process(comm) == 0) {
    try {
      action();
    } catch (const InputError& error) {
      complaint = error.what();
    } catch (const WriteError& error) {
      complaint = error.what();
      is_about_writing = true;
    }
  }
  complaint = dealii::Utilities::MPI::broadcast(comm, complaint);
  if (complaint.empty())
    return;
  if (dealii::Utilities::MPI::broadcast(comm, is_about_writing))
    throw WriteError(complaint);
  throw InputError(complaint);
}

} // namespace thelma
