// The words that let one text be GLSL and, through GLM, C++ (see AirlightMath.h for its C++ side).
#define real float
#define real2 vec2
#define real3 vec3
#define real4 vec4
#define bool3 bvec3
#define AIRLIGHT_FN
#define AIRLIGHT_OUT(T) out T
#define AIRLIGHT_IN(T) T
#define AIRLIGHT_DATA_MEMBER
