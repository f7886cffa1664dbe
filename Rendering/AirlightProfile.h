#pragma once
#include <ctime>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <vtk_glew.h>
struct Prof { std::string n; double t0; static double cpu(){ timespec t; clock_gettime(CLOCK_PROCESS_CPUTIME_ID,&t); return t.tv_sec*1e3+t.tv_nsec*1e-6; }
 static std::map<std::string,std::pair<double,int>>& m(){ static std::map<std::string,std::pair<double,int>> x; static bool once=(atexit([]{ for(auto&e:m()) fprintf(stderr,"%s %.1f ms x %d\n",e.first.c_str(),e.second.first/e.second.second,e.second.second);}),true); (void)once; return x;}
 bool on=getenv("AIRPROF")!=nullptr;
 Prof(const char*name):n(name){ if(on){glFinish(); t0=cpu();} }
 ~Prof(){ if(on){glFinish(); static std::map<std::string,int> skip; if(skip[n]++<2) return; auto&e=m()[n]; e.first+=cpu()-t0; e.second++; } } };
