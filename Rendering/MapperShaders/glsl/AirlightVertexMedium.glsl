// Added to a mapper's vertex shader where the medium before its surface is evaluated at vertices.

uniform int airlightParallel;
uniform vec3 airlightRayDirection[3]; // parallel projection: the first is the common direction
uniform mat4 airlightVertexToEye;     // to the world's axes, from the eye
out vec3 airlightPassesVSOutput;
out vec3 airlightAddedVSOutput;

void airlightAtVertex(vec3 point)
{
  float t = airlightParallel != 0 ? max(dot(point, airlightRayDirection[0]), 0.0) : length(point);
  vec3 direction = airlightParallel != 0 ? airlightRayDirection[0]
    : t > 0.0                            ? point / t
                                         : vec3(0.0, 0.0, 1.0);
  // In a perspective nothing but rounding is left of it.
  vec3 origin = airlightParallel != 0 ? point - t * direction : vec3(0.0);
  airlightPassesVSOutput = exp(-airlightDepth(origin, direction, t));
  airlightAddedVSOutput = airlightInscatterToFragment(origin, direction, t);
}
