# Debian's package of OpenIGTLink 1.11 has neither a target nor a version file. Defines OpenIGTLink::OpenIGTLink.
find_path(OpenIGTLink_INCLUDE_DIR igtlMessageHeader.h PATH_SUFFIXES openigtlink)
find_library(OpenIGTLink_LIBRARY OpenIGTLink)
# The version is in the library's name only: libOpenIGTLink.so.1.11.
if(OpenIGTLink_LIBRARY)
  file(REAL_PATH "${OpenIGTLink_LIBRARY}" _file)
  if(_file MATCHES "\\.so\\.([0-9.]+)$")
    set(OpenIGTLink_VERSION "${CMAKE_MATCH_1}")
  endif()
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(OpenIGTLink
  REQUIRED_VARS OpenIGTLink_LIBRARY OpenIGTLink_INCLUDE_DIR VERSION_VAR OpenIGTLink_VERSION)
if(OpenIGTLink_FOUND AND NOT TARGET OpenIGTLink::OpenIGTLink)
  add_library(OpenIGTLink::OpenIGTLink UNKNOWN IMPORTED)
  set_target_properties(OpenIGTLink::OpenIGTLink PROPERTIES IMPORTED_LOCATION "${OpenIGTLink_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${OpenIGTLink_INCLUDE_DIR}")
endif()
