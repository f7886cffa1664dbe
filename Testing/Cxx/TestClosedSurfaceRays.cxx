int TestClosedSurfaceRays(int, char*[]) { return 0; }
