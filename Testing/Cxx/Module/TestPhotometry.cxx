// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Photometric files of every type and symmetry: intensities between angles against interpolation by
// hand from the numbers of the files; lumens against the analytic integral.

#include "AirlightTestPhotometry.h"
#include "AirlightTestQuadrature.h"

#include <cstdlib>

using namespace airlight;
using namespace airlight_test;

namespace
{
//------------------------------------------------------------------------------
// An angle of the table or one between or around them.
double RandomAngle(Random& random, const std::vector<double>& angles, double low, double high)
{
  // The ends of a table are left out, where rounding decides between light and none.
  const bool inner = angles.size() > 2 && random.Index(4) == 0;
  return inner ? angles[1 + random.Index(static_cast<int>(angles.size()) - 2)]
               : random.Uniform(low, high);
}

bool TestTables(const std::string& file)
{
  Comparison comparison("intensities of random tables, absolute in those relative to the largest");
  Comparison maximum("the largest intensity, relative");
  Random random(11);
  long lit = 0;
  long dark = 0;
  for (int i = 0; i < 40 * TableKinds; ++i)
  {
    const LampTable table = RandomTable(random, i % TableKinds);
    const std::shared_ptr<const Photometry> photometry = WriteAndRead(file, TableText(table));
    if (!photometry)
    {
      return false;
    }
    const double largest = *std::max_element(table.Candela.begin(), table.Candela.end());
    maximum.Add(std::abs(photometry->GetMaximum() / (1.5 * largest) - 1.0), 1e-15,
      [&] { return Text("table ", i); });
    glm::dvec3 axis;
    glm::dvec3 up;
    RandomFrame(random, axis, up);
    const TestLamp lamp(*photometry, axis, up);
    for (int k = 0; k < 100; ++k)
    {
      const bool isC = table.Type == 1;
      const double v = RandomAngle(random, table.Vertical, isC ? 0.1 : -89.9, isC ? 179.9 : 89.9);
      const double h =
        isC ? random.Uniform(-360.0, 720.0) : RandomAngle(random, table.Horizontal, -89.9, 89.9);
      const double value = lamp.Look(lamp.Direction(table.Type, v, h));
      const double expected = TableValue(table, v, h) / largest;
      (expected > 0.0 ? lit : dark) += 1;
      // The angles of a direction are good to about 1e-15, near the poles (0.1 degrees) to 6e-13;
      // the steepest interval falls from 1 to 0 in a degree or so.
      comparison.Add(std::abs(value - expected), 1e-11, [&] {
        return Text("table ", i, ", type ", table.Type, ", v ", v, ", h ", h, ": ", value,
          ", expected ", expected);
      });
    }
  }
  std::cout << lit << " lit and " << dark << " dark directions\n";
  return AllOk({ &comparison, &maximum }) && lit > 1000 && dark > 1000;
}

//------------------------------------------------------------------------------
struct Sample
{
  double Vertical;
  double Horizontal;
  double Candela;
};

bool TestFile(const std::string& file, int type, double maximum, const std::vector<Sample>& samples)
{
  const std::shared_ptr<const Photometry> photometry = ReadOrTell(file);
  if (!photometry)
  {
    return false;
  }
  Comparison comparison("samples of " + file.substr(file.find_last_of('/') + 1) + ", in candela");
  comparison.Add(std::abs(photometry->GetMaximum() - maximum), 1e-9, [] { return "the largest"; });
  const TestLamp lamp(*photometry, glm::dvec3(0.0, 0.0, -1.0), glm::dvec3(0.0, 1.0, 0.0));
  for (const Sample& sample : samples)
  {
    const double value = photometry->GetMaximum() *
      lamp.Look(lamp.Direction(type, sample.Vertical, sample.Horizontal));
    comparison.Add(std::abs(value - sample.Candela), 1e-7, [&] {
      return Text("v ", sample.Vertical, ", h ", sample.Horizontal, ": ", value, ", expected ",
        sample.Candela);
    });
  }
  return comparison.Report();
}

// Means of numbers read off the files.
bool TestFiles(const std::string& folder)
{
  bool ok = TestFile(folder + "downlight.ies", 1, 2490.0,
    { { 0, 0, 2490.0 }, { 6.25, 77, (2408.4 + 2310.2) / 2 }, { 37.5, 200, (507.5 + 320.1) / 2 },
      { 30, -45, 765.8 }, { 85, 10, 3.1 / 2 }, { 91, 0, 0 }, { 180, 0, 0 } });
  // Above the cut-off 0.57 degrees below the axis it is dark on the left, below it is bright; to
  // the right the cut-off rises. A car's headlamp looks along -z with +y up: right is +x.
  ok = TestFile(folder + "lowbeam.ies", 2, 26613.9,
         { { -1.0, -2.0, 21449.2 }, { 0.5, -2.0, 129.7 }, { -0.5, 1.0, 26613.9 }, { 0, 0, 138.5 },
           { 0, 2.0, 11596.4 }, { 0, -2.0, 136.9 },
           { 0.125, 2.25, (11596.4 + 22989.9 + 636.3 + 3214.4) / 4 },
           { -0.875, -1.5, (21449.2 + 23546.1 + 21927.8 + 24166.4) / 4 }, { 120, 10, 0 } }) &&
    ok;
  // Its factor 1.10001 in the place "future use" of 2019 does not count.
  constexpr double Street = 1.5 * 0.9;
  ok = TestFile(folder + "streetlight.ies", 1, 755.6 * Street,
         { { 65, 60, 755.6 * Street }, { 65, -60, 755.6 * Street }, { 65, 300, 755.6 * Street },
           { 62.5, 7.5, (355.4 + 365.2 + 415.8 + 429.4) / 4 * Street },
           { 72.5, 187.5, (46.4 + 41.0 + 34.3 + 31.1) / 4 * Street } }) &&
    ok;
  // Here the third factor, of 1986, does.
  constexpr double Tube = 10.0 * 0.95 * 0.98;
  constexpr double TubeSample = (31.5 + 30.0 + 31.5 + 30.5) / 4 * Tube;
  ok = TestFile(folder + "tube.ies", 1, 31.5 * Tube,
         { { 7.5, 22.5, TubeSample }, { 7.5, 157.5, TubeSample }, { 7.5, -22.5, TubeSample },
           { 7.5, 202.5, TubeSample }, { 52.5, 67.5, (24 + 17.25 + 26 + 20) / 4 * Tube } }) &&
    ok;
  return ok;
}

//------------------------------------------------------------------------------
// The signs of the axes: tables that shine at horizontal angles around 90 only.
bool TestFrame()
{
  Comparison comparison("towards right, up and left");
  const glm::dvec3 axis(0.0, 0.0, -1.0);
  const glm::dvec3 up(0.0, 1.0, 0.0);
  const glm::dvec3 right(1.0, 0.0, 0.0);
  const LampTable tables[] = { { 1, { 0, 90 }, { 0, 80, 90, 100, 350 },
                                 { 0, 0, 0, 0, 0, 1, 0, 0, 0, 0 } },
    { 2, { -90, 90 }, { -90, 0, 90 }, { 0, 0, 0, 0, 1, 1 } },
    { 3, { -90, 0, 90 }, { -90, 0, 90 }, { 0, 0, 0, 0, 0, 0, 0, 1, 0 } } };
  for (const LampTable& table : tables)
  {
    const auto photometry = ParseOrTell(table);
    if (!photometry)
    {
      return false;
    }
    const TestLamp lamp(*photometry, axis, up);
    const auto add = [&](const glm::dvec3& direction, double expected) {
      comparison.Add(std::abs(lamp.Look(glm::normalize(direction)) - expected), 1e-12,
        [&] { return Text("type ", table.Type, ", expected ", expected); });
    };
    // Type C counts counter-clockwise for who looks along the axis with `up` upwards: 90 degrees
    // are on the left. At 45 degrees every table has fallen to a half of its value there.
    const glm::dvec3 side = table.Type == 1 ? -right : right;
    add(side + axis, 0.5);
    add(0.999 * side + 0.001 * axis, 1.0 - std::atan(0.001 / 0.999) / (90.0 * Degree));
    add(axis - side, 0.0);
    add(axis, 0.0);
    add(axis - up, 0.0);
  }
  return comparison.Report();
}

//------------------------------------------------------------------------------
// Lumens: 2 pi times the sum over the intervals [a, b] of the integral of I sin, I = A + s (x - a):
// A cos a - B cos b + s (sin b - sin a), by parts. Against it the library's intensities by
// quadrature over both angles.
bool TestLumens()
{
  Comparison comparison("lumens of symmetric tables, relative");
  Random random(21);
  for (int i = 0; i < 20; ++i)
  {
    const LampTable table = RandomTable(random, 0);
    std::vector<long double> ends;
    double expected = 0.0;
    for (size_t k = 0; k < table.Vertical.size(); ++k)
    {
      ends.push_back(table.Vertical[k] * Degree);
      if (k > 0)
      {
        const double a = table.Vertical[k - 1] * Degree;
        const double b = table.Vertical[k] * Degree;
        const double atA = 1.5 * table.Candela[k - 1];
        const double atB = 1.5 * table.Candela[k];
        expected += 2.0 * Pi *
          (atA * std::cos(a) - atB * std::cos(b) +
            (atB - atA) / (b - a) * (std::sin(b) - std::sin(a)));
      }
    }
    const auto photometry = ParseOrTell(table);
    if (!photometry)
    {
      return false;
    }
    glm::dvec3 axis;
    glm::dvec3 up;
    RandomFrame(random, axis, up);
    const TestLamp lamp(*photometry, axis, up);
    const auto ring = [&](double v) {
      double sum = 0.0;
      for (int k = 0; k < 8; ++k)
      {
        sum += lamp.Look(lamp.Direction(1, v / Degree, 45.0 * k + 10.0));
      }
      return sum / 8.0 * 2.0 * Pi * std::sin(v) * photometry->GetMaximum();
    };
    const double lumens = Integrate(ring, ends, 1e-12);
    comparison.Add(std::abs(lumens / expected - 1.0), 1e-11,
      [&] { return Text("table ", i, ": ", lumens, ", expected ", expected); });
  }
  return comparison.Report();
}
}

//------------------------------------------------------------------------------
int TestPhotometry(int argc, char* argv[])
{
  bool ok = TestFiles(GetPhotometricFile(argc, argv));
  ok = TestTables(GetTemporaryFile(argc, argv, "TestPhotometry.ies")) && ok;
  ok = TestFrame() && ok;
  ok = TestLumens() && ok;
  return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
