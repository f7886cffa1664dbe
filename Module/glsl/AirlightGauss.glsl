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

// Weights of a coarser rule on every other node, exact for cubic polynomials: what it differs by tells
// whether the nodes are enough.
AIRLIGHT_FN real airlightCoarseWeight(int k)
{
#ifdef AIRLIGHT_DOUBLE
  return real(k - k); // not needed: see AirlightAdaptive.cxx
#else
  if (k == 0)
    return real(0.5013801971792156);
  return k == 2 ? real(0.4986198028207845) : real(0.0);
#endif
}
