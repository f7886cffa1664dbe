# Reads the headers that most files of the library include once instead of for each file, which
# saves a third of the compiler's time. A file that forgets to include one compiles all the same: so
# this is for builds beside a plain one, as those for ParaView's tests, the wheel and the fuzzers.

get_target_property(library "${_vtk_build_module}" ALIASED_TARGET)
target_precompile_headers("${library}"
  PRIVATE
    <algorithm> <array> <cmath> <cstdint> <functional> <limits> <map> <memory> <string> <vector>
    <glm/glm.hpp>
    <vtkActor.h> <vtkCamera.h> <vtkCellArray.h> <vtkImageData.h> <vtkInformation.h> <vtkLight.h>
    <vtkMath.h> <vtkMatrix4x4.h> <vtkNew.h> <vtkObjectFactory.h> <vtkOpenGLRenderWindow.h>
    <vtkOpenGLState.h> <vtkPointData.h> <vtkPolyData.h> <vtkRenderer.h> <vtkShaderProgram.h>
    <vtkSmartPointer.h> <vtkTextureObject.h>)
# The shaders' text includes nothing.
set_source_files_properties(${glsl_sources}
  PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
