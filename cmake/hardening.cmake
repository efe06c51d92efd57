# The flags with which Debian builds its packages (dpkg-buildflags, hardening=+all), and run paths for system libraries
# only.

# An empty or relative entry of the run path would be the folder in which a user calls whirl. CMake pads the run paths
# of builds with empty entries, to rewrite them at installation. So builds have from the first the run path of an
# installation: none, or CMAKE_INSTALL_RPATH. The dynamic linker finds the system's libraries by itself.
set(CMAKE_BUILD_WITH_INSTALL_RPATH ON)

set(CMAKE_POSITION_INDEPENDENT_CODE ON)
include(CheckPIESupported)
check_pie_supported(LANGUAGES C CXX)
add_compile_options(-fstack-protector-strong -Wformat -Wformat-security)
add_link_options(-Wl,-z,relro -Wl,-z,now)
# Checked copies and prints need the optimizer, and sanitizers check more.
if(CMAKE_BUILD_TYPE MATCHES "Rel" AND NOT WHIRL_SANITIZE)
  add_compile_options(-U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=2)
endif()
