// Light of a sky, whose radiance differs by direction, that a medium scatters into a ray: a
// hemisphere of two colours, and spherical harmonics to order 2. The phase function is contained in
// the numbers: harmonics of order l are multiplied by its l-th Legendre moment, and of a hemisphere
// there is what its bright half contributes less its dark half, as a function of the height of the
// ray's direction. See "Sky" in Documentation/physics.md.

struct AirlightSky
{
  int on;
  real3 linear[3];    // of x, y and z
  real3 quadratic[5]; // of xy, yz, zx, x^2 - y^2 and 3 z^2 - 1
  real3 contrast;     // half of the hemispheres' difference
  real3 up;           // unit vector
  real2 angle;        // y = angle.y atan(angle.x dot(up, direction)), from -1 to 1
  real4 odd[3];       // of the Chebyshev polynomials T_1(y), T_3(y), T_5(y), ...
};

// Clenshaw's sum of odd polynomials: T_(k+2) = 2 T_2 T_k - T_(k-2).
AIRLIGHT_FN real airlightOddSum(AIRLIGHT_IN(AirlightSky) sky, real y)
{
  real step = real(4.0) * y * y - real(2.0);
  real first = real(0.0);
  real second = real(0.0);
  for (int k = 11; k >= 0; k--)
  {
    real next = sky.odd[k / 4][k % 4] + step * first - second;
    second = first;
    first = next;
  }
  return y * (first - second);
}

// What is to be added to the constant part, before the sum is made positive.
AIRLIGHT_FN real3 airlightSkyPart(AIRLIGHT_IN(AirlightSky) sky, real3 d)
{
  real3 sum = d.x * sky.linear[0] + d.y * sky.linear[1] + d.z * sky.linear[2];
  sum += d.x * d.y * sky.quadratic[0] + d.y * d.z * sky.quadratic[1] +
    d.z * d.x * sky.quadratic[2] + (d.x * d.x - d.y * d.y) * sky.quadratic[3] +
    (real(3.0) * d.z * d.z - real(1.0)) * sky.quadratic[4];
  real y = sky.angle.y * atan(sky.angle.x * dot(sky.up, d));
  return sum + airlightOddSum(sky, y) * sky.contrast;
}
