// Outlines of shadow planes, by whether the view enters or leaves the shadow there.

layout(location = 0) out vec4 colour;

void main()
{
  colour = gl_FrontFacing ? vec4(1.0, 0.25, 0.15, 1.0) : vec4(0.25, 0.5, 1.0, 1.0);
}
