// What is scattered along one part of a ray (AirlightEquiangular.glsl): the polynomial that meets
// the integrand at eight nodes, and its integral.

struct AirlightEquiangularPanel
{
  real middle;
  real inverseReach;
  AirlightSpectrum whole; // half of the integral over the part
  AirlightSpectrum even0;
  AirlightSpectrum even1;
  AirlightSpectrum even2;
  AirlightSpectrum even3;
  AirlightSpectrum odd0;
  AirlightSpectrum odd1;
  AirlightSpectrum odd2;
  AirlightSpectrum odd3;
};

// Where half the angle that is left has this sine and cosine.
AIRLIGHT_FN AirlightSpectrum airlightEquiangularSample(
  AIRLIGHT_IN(AirlightMedium) medium, AIRLIGHT_IN(AirlightEquiangular) arc, real sine, real cosine)
{
  sine = max(sine, real(1e-15));
  return airlightPhaseHalves(medium.phase, sine * sine, cosine * cosine) *
    exp2(arc.start + arc.slope * (cosine / sine));
}

// The sum and the difference of the values of two nodes, `off` after and before the middle, where
// half the angle that is left has the sine and the cosine of `half1`. No arrays: software renderers
// keep none in registers.
AIRLIGHT_FN void airlightEquiangularPair(AIRLIGHT_IN(AirlightMedium) medium,
  AIRLIGHT_IN(AirlightEquiangular) arc, real2 half1, real off, AIRLIGHT_OUT(AirlightSpectrum) sum,
  AIRLIGHT_OUT(AirlightSpectrum) gap)
{
  real2 o = airlightSineCosine(real(0.5) * off);
  real sc = half1.x * o.y;
  real cs = half1.y * o.x;
  real cc = half1.y * o.y;
  real ss = half1.x * o.x;
  AirlightSpectrum after = airlightEquiangularSample(medium, arc, sc - cs, cc + ss);
  AirlightSpectrum before = airlightEquiangularSample(medium, arc, sc + cs, cc - ss);
  sum = after + before;
  gap = after - before;
}

// The eight nodes of Gauss and Legendre around a middle: sums and differences of the pairs, from
// the innermost on.
struct AirlightEquiangularNodes
{
  AirlightSpectrum s0;
  AirlightSpectrum s1;
  AirlightSpectrum s2;
  AirlightSpectrum s3;
  AirlightSpectrum d0;
  AirlightSpectrum d1;
  AirlightSpectrum d2;
  AirlightSpectrum d3;
};

AIRLIGHT_FN AirlightEquiangularNodes airlightEquiangularNodes(AIRLIGHT_IN(AirlightMedium) medium,
  AIRLIGHT_IN(AirlightEquiangular) arc, real middle, real reach)
{
  AirlightEquiangularNodes n;
  real2 half1 = airlightSineCosine(real(0.5) * (arc.left - middle));
  airlightEquiangularPair(medium, arc, half1, reach * real(0.18343464249564978), n.s0, n.d0);
  airlightEquiangularPair(medium, arc, half1, reach * real(0.52553240991632899), n.s1, n.d1);
  airlightEquiangularPair(medium, arc, half1, reach * real(0.79666647741362673), n.s2, n.d2);
  airlightEquiangularPair(medium, arc, half1, reach * real(0.96028985649753618), n.s3, n.d3);
  return n;
}

// The part from psi0 to psi1. With y in [-1, 1] along it and z = y^2, what is before y is
//
//   E(1) + y E(2 z - 1) - (1 - z) O(2 z - 1)
//
// with cubics E, of the nodes' sums, and O, of their differences; so at y = -1 it is 0 to the bit.
AIRLIGHT_FN AirlightEquiangularPanel airlightEquiangularPanel(
  AIRLIGHT_IN(AirlightMedium) medium, AIRLIGHT_IN(AirlightEquiangular) arc, real psi0, real psi1)
{
  AirlightEquiangularPanel part;
  part.middle = real(0.5) * (psi0 + psi1);
  real reach = real(0.5) * (psi1 - psi0);
  part.inverseReach = real(1.0) / reach;
  AirlightEquiangularNodes n = airlightEquiangularNodes(medium, arc, part.middle, reach);
  part.even0 = reach *
    (real(0.255673747222) * n.s0 + real(0.221805968253) * n.s1 +
      real(0.0253799423589) * n.s2 + real(-0.00285965783329) * n.s3);
  part.even1 = reach *
    (real(-0.152398985846) * n.s0 + real(0.00711579102774) * n.s1 +
      real(0.165152275338) * n.s2 + real(-0.0198690805204) * n.s3);
  part.even2 = reach *
    (real(0.147003529978) * n.s0 + real(-0.231036877713) * n.s1 +
      real(0.064803171746) * n.s2 + real(0.0192301759894) * n.s3);
  part.even3 = reach *
    (real(-0.0689363996646) * n.s0 + real(0.158968441372) * n.s1 +
      real(-0.144144872217) * n.s2 + real(0.0541128305095) * n.s3);
  part.odd0 = reach *
    (real(0.00757419981627) * n.d0 + real(-0.0040837883702) * n.d1 +
      real(0.18858661277) * n.d2 + real(0.104672729119) * n.d3);
  part.odd1 = reach *
    (real(0.141475364289) * n.d0 + real(-0.228653715794) * n.d1 +
      real(-0.0346463856799) * n.d2 + real(0.126852396324) * n.d3);
  part.odd2 = reach *
    (real(-0.0368131538904) * n.d0 + real(0.200815580834) * n.d1 +
      real(-0.271467418821) * n.d2 + real(0.122345043081) * n.d3);
  part.odd3 = reach *
    (real(-0.328832923192) * n.d0 + real(0.264678987586) * n.d1 +
      real(-0.1583181504) * n.d2 + real(0.0493067029454) * n.d3);
  part.whole = ((part.even3 + part.even2) + part.even1) + part.even0;
  return part;
}

// Twice that whole, of a part in which nothing ends.
AIRLIGHT_FN AirlightSpectrum airlightEquiangularPanelSum(
  AIRLIGHT_IN(AirlightMedium) medium, AIRLIGHT_IN(AirlightEquiangular) arc, real psi0, real psi1)
{
  real reach = real(0.5) * (psi1 - psi0);
  AirlightEquiangularNodes n =
    airlightEquiangularNodes(medium, arc, real(0.5) * (psi0 + psi1), reach);
  return reach *
    ((real(0.36268378337836198) * n.s0 + real(0.31370664587788729) * n.s1) +
      (real(0.22238103445337447) * n.s2 + real(0.10122853629037626) * n.s3));
}

// The integral from the part's beginning to psi, or to its nearer end.
AIRLIGHT_FN AirlightSpectrum airlightEquiangularPanelTo(
  AIRLIGHT_IN(AirlightEquiangularPanel) part, real psi)
{
  real y = clamp((psi - part.middle) * part.inverseReach, real(-1.0), real(1.0));
  real z = y * y;
  real w = z + z - real(1.0);
  AirlightSpectrum even = ((part.even3 * w + part.even2) * w + part.even1) * w + part.even0;
  AirlightSpectrum odd = ((part.odd3 * w + part.odd2) * w + part.odd1) * w + part.odd0;
  return (part.whole + y * even) - (real(1.0) - z) * odd;
}
