// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Meshes prepared for shadows and their silhouettes: the same bytes whatever the number of threads.

#include "AirlightTestCheck.h"
#include "AirlightTestSoup.h"
#include "Silhouette/AirlightSilhouette.h"

#include "vtkSMPTools.h"
#include "vtkSphereSource.h"

#include <cstdlib>
#include <cstring>
#include <string>

using namespace airlight_test;

// GCC and Clang tell of ThreadSanitizer differently.
#if defined(__SANITIZE_THREAD__)
#define AIRLIGHT_THREAD_SANITIZER
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define AIRLIGHT_THREAD_SANITIZER
#endif
#endif

namespace
{
template <typename Item>
bool Same(const std::vector<Item>& a, const std::vector<Item>& b)
{
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Item)) == 0;
}

void TestThreads()
{
  // Several times what one thread takes at a time, with open, pair and triple edges.
  Random random(3);
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(300);
  sphere->SetPhiResolution(300);
  sphere->Update();
  TriangleList triangles = GetFans(sphere->GetOutput());
  for (size_t i = triangles.size() - 1; i > 0; --i)
  {
    std::swap(triangles[i], triangles[static_cast<size_t>(random.Uniform(0.0, i + 1.0))]);
  }
  triangles.resize(triangles.size() - 5000);
  triangles.insert(triangles.end(), triangles.begin(), triangles.begin() + 2000);
  const vtkSmartPointer<vtkPolyData> soup = MakeSoup(triangles);
  const glm::dvec4 light(3.0, 1.0, 2.0, 1.0);
  std::vector<airlight::CasterMesh> meshes;
  std::vector<std::vector<airlight::SilhouetteEdge>> silhouettes;
  std::vector<std::pair<int, std::string>> threads{ { 1, "Sequential" }, { 1, "STDThread" },
    { 2, "STDThread" } };
#ifndef AIRLIGHT_THREAD_SANITIZER // which cannot see the locks inside of TBB
  threads.emplace_back(2, "TBB");
#endif
  for (const auto& [count, backend] : threads)
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ count, backend, false }, [&] {
      meshes.emplace_back(soup);
      silhouettes.push_back(FindSilhouette(meshes.back(), light));
    });
    const airlight::CasterMesh& a = meshes.front();
    const airlight::CasterMesh& b = meshes.back();
    Check(Same(a.Points, b.Points) && Same(a.SourcePoints, b.SourcePoints) &&
        Same(a.Triangles, b.Triangles) && Same(a.Planes, b.Planes) &&
        Same(a.PairEnds, b.PairEnds) && Same(a.PairUses, b.PairUses) &&
        Same(a.OtherEnds, b.OtherEnds) && Same(a.OtherUses, b.OtherUses) &&
        Same(a.FirstUse, b.FirstUse),
      Text("the same mesh with ", count, " threads of ", backend));
    Check(Same(silhouettes.front(), silhouettes.back()),
      Text("the same silhouette with ", count, " threads of ", backend));
  }
  Check(meshes.front().OtherEnds.size() > 5000 && meshes.front().PairEnds.size() > 100000,
    "the mesh for the threads has edges of all kinds");
  EdgeWeights found;
  for (const airlight::SilhouetteEdge& edge : silhouettes.front())
  {
    const std::vector<glm::dvec3>& points = meshes.front().Points;
    found[{ ToPosition(points[edge.A]), ToPosition(points[edge.B]) }] = edge.Weight;
  }
  Check(found == SumDirections(triangles, light), "the large mesh's silhouette by the definition");
}
}

//------------------------------------------------------------------------------
int TestSilhouetteThreads(int, char*[])
{
  TestThreads();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
