// A ray between the boundaries of shadows by AirlightGoniometricArc.glsl. One loop, in which each
// pass ends at a boundary, where the ray leaves a cell of the table, or where three nodes end.

void airlightEquiangularRay(AirlightRay ray, inout AirlightEquiangularPixel pixel)
{
  AirlightMedium medium = media.item[0];
  AirlightEquiangular arc = airlightEquiangularRange(medium, ray, ray.lit.x, ray.lit.y);
  AirlightGoniometricArc walk = airlightGoniometricArc(light.photometry, ray, arc);
  float from = ray.lit.x;
  AirlightCounts shadows = airlightStartCounts();
  airlightBeginEquiangular(ray, from, shadows, pixel);
  bool lit = airlightPassing(shadows);
  float litLength = lit ? -from : 0.0;
  AirlightSpectrum sum = AirlightSpectrum(0.0);
  float psi = 0.0;
  float t;
  AirlightCounts weight;
  bool ends = airlightNextBoundary(t, weight) == AIRLIGHT_END;
  float at = airlightAngleAt(arc, ray, t);
  bool more = true;
  for (int left = pixel.boundaries + AIRLIGHT_MAXIMUM_CELLS; more && left > 0; left--)
  {
    float end = min(airlightGoniometricEnd(medium, light.photometry, arc, psi, walk), arc.end);
    // The last part takes what lies beyond the ray's end, too.
    bool stops = !ends && (at <= end || end >= arc.end);
    end = stops ? clamp(at, psi, end) : end;
    sum += lit ? airlightGoniometricPart(medium, arc, walk, psi, end) : AirlightSpectrum(0.0);
    psi = end;
    more = stops || psi < arc.end;
    if (stops)
    {
      shadows = airlightAdd(shadows, weight);
      bool was = lit;
      lit = airlightPassing(shadows);
      float parameter = clamp(t, ray.lit.x, ray.lit.y);
      litLength += was == lit ? 0.0 : lit ? -parameter : parameter;
      ends = airlightNextBoundary(t, weight) == AIRLIGHT_END;
      at = airlightAngleAt(arc, ray, t);
    }
    else
    {
      airlightGoniometricCross(walk);
    }
  }
  pixel.litLength = max(litLength + (lit ? ray.lit.y : 0.0), 0.0);
#if defined(AIRLIGHT_RECORD) || AIRLIGHT_MULTIPLE_LAMP >= 0
  AirlightSpectrum all =
    airlightGoniometricQuadrature(medium, light.photometry, ray, ray.lit.x, ray.lit.y);
#else
  AirlightSpectrum all = AirlightSpectrum(0.0);
#endif
  pixel.whole = airlightEquiangularLight(light, ray, all);
  pixel.sum = airlightEquiangularLight(light, ray, max(sum, AirlightSpectrum(0.0)));
}
