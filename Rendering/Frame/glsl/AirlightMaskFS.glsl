// Depths of a mask, before anything is drawn: what is at 0 hides all.

uniform sampler2D mask;

void main() { gl_FragDepth = texelFetch(mask, ivec2(gl_FragCoord.xy), 0).r; }
