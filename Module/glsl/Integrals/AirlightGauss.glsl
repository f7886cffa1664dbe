// Gauss-Legendre nodes on [-1, 1] as (position, weight) for the positive half; the negative half
// mirrors it. Sixteen nodes in double precision, eight in single.
#ifdef AIRLIGHT_DOUBLE
#define AIRLIGHT_GAUSS_COUNT 16
#else
#define AIRLIGHT_GAUSS_COUNT 8
#endif

AIRLIGHT_FN real2 airlightGaussNode(int k)
{
#ifdef AIRLIGHT_DOUBLE
  if (k == 0)
    return real2(0.095012509837637454, 0.18945061045506859);
  if (k == 1)
    return real2(0.28160355077925892, 0.18260341504492361);
  if (k == 2)
    return real2(0.45801677765722737, 0.16915651939500262);
  if (k == 3)
    return real2(0.61787624440264377, 0.14959598881657676);
  if (k == 4)
    return real2(0.755404408355003, 0.12462897125553403);
  if (k == 5)
    return real2(0.86563120238783176, 0.095158511682492591);
  if (k == 6)
    return real2(0.9445750230732326, 0.062253523938647706);
  return real2(0.98940093499164994, 0.027152459411754037);
#else
  if (k == 0)
    return real2(0.18343464249564978, 0.36268378337836177);
  if (k == 1)
    return real2(0.52553240991632899, 0.31370664587788705);
  if (k == 2)
    return real2(0.79666647741362673, 0.22238103445337434);
  return real2(0.96028985649753618, 0.10122853629037669);
#endif
}

// Weights that give, from the values at the nodes, the integrand's coefficients of the Legendre
// polynomials of degrees 6 and 7 (for the negative node the latter changes its sign). Where these
// are small the integrand is smooth; a kink between the outermost nodes cannot hide from both of
// them.
AIRLIGHT_FN real2 airlightRoughWeight(int k)
{
#ifdef AIRLIGHT_DOUBLE
  return real2(real(0.0) * real(k)); // not needed: see AirlightAdaptiveQuadrature.h
#else
  if (k == 0)
    return real2(-0.26738967142620357, -0.7849065579218125);
  if (k == 1)
    return real2(0.6166048635025356, 0.6317745531190043);
  if (k == 2)
    return real2(-0.5591073831433642, -0.3778969370845917);
  return real2(0.2098921910670325, 0.11769245644771324);
#endif
}

#ifndef AIRLIGHT_DOUBLE
// From an end of the interval to the nearest node.
#define AIRLIGHT_GAUSS_GAP 0.039710143502463824

// Weights of the positive and of the negative node in the value that the nodes' polynomial has at
// 1; at -1 they change places.
AIRLIGHT_FN real2 airlightEndWeight(int k)
{
  if (k == 0)
    return real2(-0.512655633801369, 0.35373041810644235);
  if (k == 1)
    return real2(0.7101568903172436, -0.2208713667044393);
  if (k == 2)
    return real2(-0.9912041583117182, 0.11217721020871663);
  return real2(1.580687063030956, -0.032020422845832466);
}
#endif

// How much the integral over a panel with these coefficients may be wrong by, relative to half the
// panel's width. Kinks, wherever they are, cost 0.1 of the root of the sum of their squares in the
// median, 0.5 at most.
AIRLIGHT_FN real3 airlightRough(real3 even, real3 odd)
{
  return real(0.5) * sqrt(even * even + odd * odd);
}
