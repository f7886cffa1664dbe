int TestClosedSurfacePass(int, char*[]) { return 0; }
