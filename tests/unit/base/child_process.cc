// However a child process ends, the parent goes on with an answer or with a complaint.

#include <thelma/base/child_process.h>
#include <thelma/base/error.h>

#include <gtest/gtest.h>

#include <csignal>
#include <stdexcept>
#include <unistd.h>

namespace
{

using namespace thelma;

/// What the parent throws.
std::string complaint_of(const std::function<std::string()>& action)
{
  try {
    return "answer: " + in_child_process(action, 1e11, "it fails");
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(ChildProcess, WhateverItThrowsIsTold)
{
  const pid_t parent = getpid();
  EXPECT_EQ(complaint_of([]() { return "42"; }), "answer: 42");
  EXPECT_EQ(complaint_of([]() -> std::string { throw InputError("a sentence"); }), "a sentence");
  EXPECT_EQ(complaint_of([]() -> std::string { throw std::out_of_range("map::at"); }),
            "it fails (map::at)");
  EXPECT_EQ(complaint_of([]() -> std::string { throw 7; }), "it fails (unknown error)");
  EXPECT_NE(complaint_of([]() -> std::string { throw std::bad_alloc(); }).find("memory"),
            std::string::npos);
  EXPECT_NE(complaint_of([]() -> std::string { _exit(3); }).find("it exited"), std::string::npos);
  EXPECT_NE(complaint_of([]() -> std::string {
              std::raise(SIGSEGV);
              return "";
            }).find("Segmentation"),
            std::string::npos);
  EXPECT_EQ(getpid(), parent) << "a child ran on";
}

} // namespace
