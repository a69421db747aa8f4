# Debian's SuiteSparse 5.12 has no CMake package. Defines SuiteSparse::CHOLMOD.
find_path(SuiteSparse_INCLUDE_DIR cholmod.h PATH_SUFFIXES suitesparse)
set(_libraries "")
foreach(_name cholmod amd colamd camd ccolamd suitesparseconfig openblas)
  find_library(SuiteSparse_${_name}_LIBRARY ${_name} PATH_SUFFIXES openblas-pthread)
  list(APPEND _libraries "${SuiteSparse_${_name}_LIBRARY}")
endforeach()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(SuiteSparse
  REQUIRED_VARS SuiteSparse_cholmod_LIBRARY SuiteSparse_openblas_LIBRARY SuiteSparse_INCLUDE_DIR)
if(SuiteSparse_FOUND AND NOT TARGET SuiteSparse::CHOLMOD)
  add_library(SuiteSparse::CHOLMOD INTERFACE IMPORTED)
  target_include_directories(SuiteSparse::CHOLMOD SYSTEM INTERFACE "${SuiteSparse_INCLUDE_DIR}")
  # OpenBLAS by name and first: the machine's default BLAS may be the slow reference one.
  target_link_libraries(SuiteSparse::CHOLMOD INTERFACE "${SuiteSparse_openblas_LIBRARY}" ${_libraries})
endif()
