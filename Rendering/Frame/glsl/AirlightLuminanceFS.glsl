// The mean of the logarithm of luminance over a block of pixels, and how many of them have any.

uniform sampler2D radiances;
uniform ivec2 corner; // of the picture in the texture
uniform ivec2 size;   // of the picture
uniform ivec2 blockSize;

layout(location = 0) out vec4 logarithm;

void main()
{
  ivec2 first = ivec2(gl_FragCoord.xy) * blockSize;
  ivec2 last = min(first + blockSize, size);
  float sum = 0.0;
  float count = 0.0;
  for (int y = first.y; y < last.y; ++y)
  {
    for (int x = first.x; x < last.x; ++x)
    {
      vec3 radiance = texelFetch(radiances, corner + ivec2(x, y), 0).rgb;
      float luminance = dot(radiance, vec3(0.2126, 0.7152, 0.0722)); // of Rec. 709
      if (luminance > 1e-30 && luminance < 1e30)
      {
        sum += log2(luminance);
        count += 1.0;
      }
    }
  }
  logarithm = vec4(sum / max(count, 1.0), count, 0.0, 0.0);
}
