#include <thelma/base/start_up.h>

#include <gtest/gtest.h>

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  const thelma::Process process(argv[0]);
  return RUN_ALL_TESTS();
}
