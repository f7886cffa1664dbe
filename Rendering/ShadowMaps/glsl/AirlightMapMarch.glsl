// The steps of a march along a ray.

uniform int marchSteps;
uniform float marchScale; // directional light: the length on which its light fades

// The part of a ray that is marched and how its steps divide it: for lights at a place into equal
// angles seen from there, for directional lights into lengths that grow slowly.
struct AirlightMarch
{
  AirlightRay ray;
  float from; // point light: distance from the foot; directional: distance along the ray
  float to;
  float turn; // point light: the whole angle
  bool point;
};

AirlightMarch airlightMarch(AirlightRay ray)
{
  AirlightMarch march;
  march.ray = ray;
  march.point = !airlightIsDirectional(light);
  march.from = ray.lit.x;
  march.to = ray.lit.y;
  march.turn = 0.0;
  if (march.point)
  {
    march.from = airlightFromFoot(ray, ray.lit.x);
    march.to = airlightFromFoot(ray, ray.lit.y);
    march.turn = airlightAngle(ray.foot.h * (march.to - march.from),
      ray.foot.h * ray.foot.h + march.from * march.to);
  }
  return march;
}

// The parameter of a step's end: distance from the foot, or a share of the way.
float airlightMarchStep(AirlightMarch march, int step)
{
  float share = float(step) / float(marchSteps);
  if (!march.point)
  {
    return share;
  }
  if (step == marchSteps)
  {
    return march.to;
  }
  float c = cos(share * march.turn);
  float s = sin(share * march.turn);
  float h = march.ray.foot.h;
  float x = h * (march.from * c + h * s) / max(h * c - march.from * s, 1e-30);
  return clamp(x, march.from, march.to);
}

// The parameter in the middle of two.
float airlightMarchMiddle(AirlightMarch march, float a, float b)
{
  if (!march.point)
  {
    return 0.5 * (a + b);
  }
  float h = march.ray.foot.h;
  float k = sqrt(h * h + a * a) / sqrt(h * h + b * b);
  return (a + b * k) / (1.0 + k);
}

// The distance along the ray.
float airlightMarchDistance(AirlightMarch march, float x)
{
  if (march.point)
  {
    return march.ray.range.x + march.ray.foot.tL + x;
  }
  float way = march.to - march.from;
  return march.from + way * x / (x + (1.0 - x) * (1.0 + 0.25 * way / marchScale));
}

vec3 airlightMarchPoint(AirlightMarch march, float x)
{
  return march.ray.origin + airlightMarchDistance(march, x) * march.ray.direction;
}
