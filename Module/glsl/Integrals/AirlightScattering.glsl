// What a light scatters into a ray, for every kind of light. A ray's lit intervals are summed one
// by one:
//
//   real3 tail = airlightTail3(light, ray, entry); // once per boundary
//   sum += airlightInterval3(light, ray, entry, tail, exit, airlightTail3(light, ray, exit));

// The integral from t to infinity per unit sigmaS I, for each channel; t from the ray's origin.
AIRLIGHT_FN real3 airlightTail3(
  AIRLIGHT_MEDIA_IN AIRLIGHT_IN(AirlightLight) light, AIRLIGHT_IN(AirlightRay) ray, real t)
{
#ifdef AIRLIGHT_GRID_STEPS
  // There it is the optical depth before t.
  return airlightDepthOn(ray.origin, ray.direction, ray.range.x, t);
#else
  if (AIRLIGHT_LIGHT_KIND != AIRLIGHT_POINT_CLOSED)
  {
    return real3(real(0.0));
  }
  real x = airlightFromFoot(ray, t);
  t -= ray.range.x;
  real3 sigmaT = airlightMedia.item[0].sigmaT;
  real red = airlightTail(airlightMedia.item[0].phase, sigmaT.x, ray.foot, t, x);
  if (airlightIsGrey(airlightMedia.item[0]))
  {
    return real3(red);
  }
  return real3(red, airlightTail(airlightMedia.item[0].phase, sigmaT.y, ray.foot, t, x),
    airlightTail(airlightMedia.item[0].phase, sigmaT.z, ray.foot, t, x));
#endif
}

#ifdef AIRLIGHT_GRID_STEPS
// The integral on [t0, t1] per unit of the light's intensity; `depth` becomes that before t1.
real3 airlightSteppedIntegral(
  AirlightLight light, AirlightRay ray, real t0, inout real3 depth, real t1)
{
#ifdef AIRLIGHT_EVERYWHERE
  return airlightBesideAndIn(light, ray, t0, depth, t1);
#else
  return airlightGridInterval(light, ray, t0, depth, t1);
#endif
}
#endif

// Radiance scattered into the ray on [t0, t1], which lies inside ray.lit; tail0 and tail1 are the
// values of airlightTail3 at its ends.
AIRLIGHT_FN real3 airlightInterval3(AIRLIGHT_MEDIA_IN AIRLIGHT_IN(AirlightLight) light,
  AIRLIGHT_IN(AirlightRay) ray, real t0, real3 tail0, real t1, real3 tail1)
{
  real3 integral;
#ifdef AIRLIGHT_GRID_STEPS
  integral = airlightSteppedIntegral(light, ray, t0, tail0, t1);
#elif defined(AIRLIGHT_EVERYWHERE)
  integral = airlightBesideAndIn(light, ray, t0, tail0, t1);
#else
  if (AIRLIGHT_LIGHT_KIND == AIRLIGHT_POINT_CLOSED)
  {
    real x0 = airlightFromFoot(ray, t0);
    real way = airlightWayBetween(ray, t0, t1);
    integral = airlightMedia.item[0].sigmaS *
      airlightSegmentFromTails(
        airlightMedia.item[0].phase, airlightMedia.item[0].sigmaT, ray.foot, x0, way, tail0, tail1);
  }
  else if (AIRLIGHT_LIGHT_KIND == AIRLIGHT_DIRECTIONAL_CLOSED)
  {
    integral = airlightDirectionalClosed(airlightMedia.item[0], light, ray, t0, t1);
  }
  else if (AIRLIGHT_LIGHT_KIND == AIRLIGHT_DIRECTIONAL_HEIGHT)
  {
    integral = airlightDirectionalHeight(airlightMedia.item[0], light, ray, t0, t1);
  }
  else
  {
    integral = airlightQuadrature(AIRLIGHT_MEDIA_OUT light, ray, t0, t1);
  }
#endif
  return light.intensity * integral;
}

// The same over a run of the ray that is lit or not: `tail`, the value of airlightTail3 at t0,
// becomes that at t1.
AIRLIGHT_FN real3 airlightRun3(AIRLIGHT_MEDIA_IN AIRLIGHT_IN(AirlightLight) light,
  AIRLIGHT_IN(AirlightRay) ray, bool lit, real t0, AIRLIGHT_INOUT(real3) tail, real t1)
{
#ifdef AIRLIGHT_GRID_STEPS
  // Steps come upon the optical depth on their way.
  real3 integral = real3(0.0);
  if (lit)
  {
    integral = light.intensity * airlightSteppedIntegral(light, ray, t0, tail, t1);
  }
  else
  {
    tail += airlightDepthOn(ray.origin, ray.direction, t0, t1);
  }
  return integral;
#else
  real3 tail0 = tail;
  tail = airlightTail3(AIRLIGHT_MEDIA_OUT light, ray, t1);
  return lit ? airlightInterval3(AIRLIGHT_MEDIA_OUT light, ray, t0, tail0, t1, tail)
             : real3(real(0.0));
#endif
}
