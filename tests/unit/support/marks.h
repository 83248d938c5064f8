#pragma once

/// What tests/CMakeLists.txt reads of a suite, each on a line of its own; for the compiler no more
/// than a word that it knows.
#define SLOW(suite) static_assert(true, #suite)         ///< takes 15 s and more
#define ON_TWO_RANKS(suite) static_assert(true, #suite) ///< as well
