# What the module is made of. Each room, a folder of Module, Filters or Rendering, has a
# sources.cmake that calls airlight_sources().

# airlight_sources(
#   CLASSES <class>...          public: <class>.h and <class>.cxx, installed and wrapped for Python
#   PRIVATE_CLASSES <class>...  <class>.h and <class>.cxx, neither installed nor wrapped
#   SOURCES <file>...           other sources
#   HEADERS <file>...           other headers
#   GLSL <file>...)             X.glsl becomes X.h, which declares `extern const char* X`
#
# Names are relative to the folder of the file that calls it. The results are appended to the
# variables classes, private_classes, private_sources, private_headers and glsl.
macro (airlight_sources)
  cmake_parse_arguments(_room "" "" "CLASSES;PRIVATE_CLASSES;SOURCES;HEADERS;GLSL" ${ARGN})
  foreach (kind IN ITEMS CLASSES PRIVATE_CLASSES SOURCES HEADERS GLSL)
    list(TRANSFORM _room_${kind} PREPEND "${CMAKE_CURRENT_LIST_DIR}/")
  endforeach ()
  list(APPEND classes ${_room_CLASSES})
  list(APPEND private_classes ${_room_PRIVATE_CLASSES})
  list(APPEND private_sources ${_room_SOURCES})
  list(APPEND private_headers ${_room_HEADERS})
  list(APPEND glsl ${_room_GLSL})
endmacro ()

# In the order in which they may include one another. Utilities/check-includes.py has the rules.
set(airlight_rooms
  Module
  Module/Density
  Module/Integration
  Module/Medium
  Module/MultipleScattering
  Module/Phase
  Module/Photometry
  Module/Region
  Filters
  Filters/Comparison
  Filters/DataSets
  Filters/Emission
  Filters/Occlusion
  Filters/OpenVDB
  Filters/RayProbes
  Filters/Reference
  Filters/Scene
  Filters/Silhouette
  Rendering
  Rendering/OpenGL
  Rendering/Casters
  Rendering/Scene
  Rendering/Translucency
  Rendering/MapperShaders
  Rendering/ShadowMaps
  Rendering/ShadowVolumes
  Rendering/Composite
  Rendering/Inscatter
  Rendering/Frame
  Rendering/Pass)

get_filename_component(airlight_root "${CMAKE_CURRENT_LIST_DIR}" DIRECTORY)
set(classes)
set(private_classes)
set(private_sources)
set(private_headers)
set(glsl)
foreach (room IN LISTS airlight_rooms)
  include("${airlight_root}/${room}/sources.cmake")
endforeach ()
