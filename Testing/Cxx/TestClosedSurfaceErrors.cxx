int TestClosedSurfaceErrors(int, char*[]) { return 0; }
