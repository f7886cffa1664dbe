// The medium: coefficients, phase function and region.

struct AirlightMedium
{
  real3 sigmaS;  // scattering coefficient, 1/world
  real3 sigmaT;  // extinction coefficient, 1/world
  real3 ambient; // ambient radiance
  AirlightPhase phase;
  AirlightRegion region;
};

// (1 - exp(-sigma l))/sigma, the optical length of a way of length l; its limit l for sigma -> 0.
AIRLIGHT_FN real airlightOpticalLength(real sigma, real l)
{
  real depth = sigma * l;
  if (depth < real(0.02))
  {
    return l *
      (real(1.0) -
        depth * (real(0.5) -
        depth * (real(0.16666666666666667) -
        depth * (real(0.041666666666666667) -
        depth * (real(0.0083333333333333333) -
        depth * (real(0.0013888888888888889) - depth * real(0.00019841269841269841)))))));
  }
  return (real(1.0) - exp(-depth)) / sigma;
}

// Ambient radiance scattered into `inside` units of the ray: albedo L (1 - transmittance).
AIRLIGHT_FN real3 airlightAmbient(AIRLIGHT_IN(AirlightMedium) medium, real inside)
{
  return medium.sigmaS * medium.ambient *
    real3(airlightOpticalLength(medium.sigmaT.x, inside),
      airlightOpticalLength(medium.sigmaT.y, inside),
      airlightOpticalLength(medium.sigmaT.z, inside));
}

// True where all channels fade alike, so that one of them serves for three.
AIRLIGHT_FN bool airlightIsGrey(AIRLIGHT_IN(AirlightMedium) medium)
{
  return medium.sigmaT.x == medium.sigmaT.y && medium.sigmaT.x == medium.sigmaT.z;
}
