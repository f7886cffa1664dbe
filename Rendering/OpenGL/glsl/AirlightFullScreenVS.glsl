#version 150
// One triangle that covers the viewport, without any vertex data.

// Software renderers take as long to read a uniform as for a dozen operations, for each group of
// pixels; what a triangle's corners say they have at hand.
uniform ivec2 airlightViewport; // as in AirlightCameraShader.glsl
uniform vec4 airlightTargetPixels;
uniform vec3 airlightRayDirection[3];
uniform vec4 airlightConstants[24]; // of AirlightConstants.glsl
flat out vec4 airlightFlatPixels;
flat out vec3 airlightFlatDirection[3];
flat out vec4 airlightFlatConstants[24];

void main()
{
  vec2 scale = airlightTargetPixels.xy;
  airlightFlatPixels = vec4(scale, airlightTargetPixels.zw - scale * vec2(airlightViewport));
  airlightFlatDirection = airlightRayDirection;
  airlightFlatConstants = airlightConstants;
  gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
}
