# Included when cmake configures, which says what cpack will miss, and by cpack, which stops: without
# `file` it would do so without a word why, without dpkg-dev it would forget all dependencies.
find_program(THELMA_FILE file)
find_program(THELMA_SHLIBDEPS dpkg-shlibdeps)
if(NOT THELMA_FILE OR NOT THELMA_SHLIBDEPS)
  if(NOT THELMA_COMPLAINT)
    set(THELMA_COMPLAINT FATAL_ERROR)
  endif()
  message(${THELMA_COMPLAINT}
    "cpack needs what is missing here: apt-get install --no-install-recommends file dpkg-dev")
endif()
