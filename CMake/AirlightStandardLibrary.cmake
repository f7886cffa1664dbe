# Which strings and lists of libstdc++ VTK was built with. VTK's wheels of 9.5 for Linux have those
# from before GCC 5, distributions have the new ones, and a program that mixes them does not link.

set(AIRLIGHT_OLD_STANDARD_LIBRARY OFF)
if (NOT AIRLIGHT_STANDARD_LIBRARY_VTK STREQUAL VTK_DIR) # another VTK than last time
  unset(AIRLIGHT_STANDARD_LIBRARY_ABI CACHE)
  unset(AIRLIGHT_LINKS_WITH_ABI_0 CACHE)
  unset(AIRLIGHT_LINKS_WITH_ABI_1 CACHE)
  set(AIRLIGHT_STANDARD_LIBRARY_VTK "${VTK_DIR}" CACHE INTERNAL "VTK_DIR of this answer")
endif ()
if (CMAKE_SYSTEM_NAME STREQUAL "Linux")
  set(abi_source "${CMAKE_BINARY_DIR}/AirlightStandardLibrary.cxx")
  file(CONFIGURE OUTPUT "${abi_source}" CONTENT [[
#include <vtksys/SystemTools.hxx>
int main()
{
  return vtksys::SystemTools::GetCurrentWorkingDirectory().empty();
}
]])
  foreach (abi IN ITEMS 1 0)
    if (NOT DEFINED AIRLIGHT_STANDARD_LIBRARY_ABI)
      try_compile(AIRLIGHT_LINKS_WITH_ABI_${abi} "${CMAKE_BINARY_DIR}"
        SOURCES             "${abi_source}"
        LINK_LIBRARIES      VTK::vtksys
        COMPILE_DEFINITIONS -D_GLIBCXX_USE_CXX11_ABI=${abi})
      if (AIRLIGHT_LINKS_WITH_ABI_${abi})
        set(AIRLIGHT_STANDARD_LIBRARY_ABI "${abi}" CACHE INTERNAL "_GLIBCXX_USE_CXX11_ABI of VTK")
      endif ()
    endif ()
  endforeach ()
  if (NOT DEFINED AIRLIGHT_STANDARD_LIBRARY_ABI)
    message(FATAL_ERROR
      "A program does not link with VTK's library vtksys. Was ${VTK_DIR} built with another compiler?")
  endif ()
  if (AIRLIGHT_STANDARD_LIBRARY_ABI EQUAL 0)
    set(AIRLIGHT_OLD_STANDARD_LIBRARY ON)
    add_compile_definitions(_GLIBCXX_USE_CXX11_ABI=0)
    message(STATUS "VTK has the strings of the old libstdc++, and so gets Airlight")
  endif ()
endif ()
