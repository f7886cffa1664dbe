# Compiles the files of a folder together, which takes a third of the compiler's time. A file that
# forgets to include a header compiles all the same, and a change compiles a whole folder again: so
# this is for fresh builds that nobody changes (demo, continuous integration, ParaView's tests, wheel,
# fuzzers). Who changes the library compiles each file by itself, as clang-tidy does.
# Names in the anonymous namespaces of one folder must differ.

get_target_property(library "${_vtk_build_module}" ALIASED_TARGET)
set_target_properties("${library}" PROPERTIES
  UNITY_BUILD      ON
  UNITY_BUILD_MODE GROUP)
get_target_property(sources "${library}" SOURCES)
foreach (source IN LISTS sources)
  if (source MATCHES "/([A-Za-z]+)/([A-Za-z]+)/[A-Za-z]+\\.cxx$")
    set_source_files_properties("${source}"
      PROPERTIES UNITY_GROUP "${CMAKE_MATCH_1}${CMAKE_MATCH_2}")
  endif ()
endforeach ()
