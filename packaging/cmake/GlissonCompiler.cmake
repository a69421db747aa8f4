# Flags that hold for the whole house. Never -march=native: what is shipped dispatches at run time.
find_program(GLISSON_CCACHE ccache)
if(GLISSON_CCACHE)
  # Without the sloppiness nothing that reads a precompiled header is kept. With the base, clones share one cache. The
  # last two spare hashing a precompiled header of 400 MB for each unit, and a run of the preprocessor for each new one.
  set(GLISSON_LAUNCHER "${CMAKE_COMMAND}" -E env CCACHE_SLOPPINESS=pch_defines,time_macros
    "CCACHE_BASEDIR=${PROJECT_SOURCE_DIR}" CCACHE_NOHASHDIR=1 CCACHE_INODECACHE=1 CCACHE_DEPEND=1 "${GLISSON_CCACHE}")
  set(CMAKE_C_COMPILER_LAUNCHER ${GLISSON_LAUNCHER})
  set(CMAKE_CXX_COMPILER_LAUNCHER ${GLISSON_LAUNCHER})
endif()

add_library(glisson_flags INTERFACE)
target_compile_options(glisson_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual -Wcast-align
  -Werror
  # The same bits on every machine and thread count: no fused multiply-add behind our back.
  -ffp-contract=off)
if(GLISSON_PCH)
  target_compile_options(glisson_flags INTERFACE -Winvalid-pch)
  if(GLISSON_CCACHE AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(glisson_flags INTERFACE -fpch-preprocess)
  elseif(GLISSON_CCACHE)
    # A precompiled header from the cache is older than the headers of a fresh clone; that they are the same is known.
    target_compile_options(glisson_flags INTERFACE "SHELL:-Xclang -fno-pch-timestamp")
  endif()
endif()

# Sanitizers need memory and counts need files that a confined reader has given up.
if(GLISSON_COVERAGE OR GLISSON_SANITIZER)
  add_compile_definitions(GLISSON_INSTRUMENTED)
endif()
if(GLISSON_COVERAGE)
  # Lines of libraries' headers are not ours to count. Clang inlines nothing that is not counted into what is: that costs
  # little here, but under AddressSanitizer tests took many times as long. So counts have a build of their own.
  add_compile_options(-fprofile-instr-generate -fcoverage-mapping
    -fprofile-list=${PROJECT_SOURCE_DIR}/packaging/sanitizers/uncounted.list)
  add_link_options(-fprofile-instr-generate)
endif()
if(GLISSON_SANITIZER)
  add_compile_options(-fsanitize=${GLISSON_SANITIZER} -fno-omit-frame-pointer -g1)
  add_link_options(-fsanitize=${GLISSON_SANITIZER})
  if(GLISSON_SANITIZER MATCHES "undefined")
    add_compile_options(-fno-sanitize-recover=undefined -fno-sanitize=vptr)
    # UBSan asks our own lines. In libraries' headers its questions make a build half as long again; Eigen's assertions
    # are on, and AddressSanitizer sees the memory there.
    if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
      add_compile_options(-fsanitize-ignorelist=${PROJECT_SOURCE_DIR}/packaging/sanitizers/ubsan.ignore)
    endif()
  endif()
  # GCC 12 sees phantoms in Eigen's and libstdc++'s inlined code once it is instrumented.
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(glisson_flags INTERFACE -Wno-maybe-uninitialized -Wno-stringop-overflow
      -Wno-array-bounds -Wno-null-dereference)
  endif()
endif()

# Some 700 programs and libraries are linked, most of them tests: gold, which comes with binutils, takes a quarter of
# the time that the usual linker takes.
include(CheckLinkerFlag)
check_linker_flag(CXX -fuse-ld=gold GLISSON_HAS_GOLD)
if(GLISSON_HAS_GOLD)
  add_link_options(-fuse-ld=gold)
endif()
