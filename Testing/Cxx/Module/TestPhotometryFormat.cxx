// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Photometric files of all versions, TILTs, separators and ends of lines mean the same. Random
// mutations of good files are refused or give sound numbers.

#include "AirlightTestCheck.h"
#include "AirlightTestPhotometry.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>

using namespace airlight;
using namespace airlight_test;

namespace
{
//------------------------------------------------------------------------------
// Versions, TILT, separators and ends of lines of one table.
bool TestStyles(const std::string& file)
{
  Random random(3);
  const LampTable table = RandomTable(random, 2);
  const std::string numbers = TableNumbers(table);
  const std::string modern = "IESNA:LM-63-1995\n[TEST] made up\n";
  const std::string include = "TILT=INCLUDE\n2\n3 0 45\n90 1 0.9\n0.8\n";
  std::string crlf = modern + "TILT=NONE\n" + TableNumbers(table, "\n");
  std::string cr = crlf;
  for (size_t at = 0; (at = crlf.find('\n', at)) != std::string::npos; at += 2)
  {
    crlf.replace(at, 1, "\r\n");
  }
  std::replace(cr.begin(), cr.end(), '\n', '\r');
  const std::string same[] = { "TILT=NONE\n" + numbers, "a label\nTILT=NONE\n" + numbers,
    "IESNA91\n[TEST] 1\nTILT=NONE\n" + numbers, modern + "TILT=NONE\n" + numbers,
    "IESNA:LM-63-2002\n[TEST] 1\nTILT=NONE\n" + numbers,
    "IES:LM-63-2019\n[TEST] 1\nTILT=NONE\n" + numbers, modern + include + numbers,
    modern + "TILT=lamp.tlt\n" + numbers, modern + " Tilt = none \n" + numbers, crlf, cr,
    modern + "TILT=NONE\n" + TableNumbers(table, ","),
    modern + "TILT=NONE\n" + TableNumbers(table, " ,\t"),
    modern + "TILT=NONE\n" + TableNumbers(table, " \n\n "),
    "\xef\xbb\xbf" + modern + "TILT=NONE\n" + numbers, modern + "TILT=NONE\n" + numbers + "\n\x1a",
    modern + "[MORE] caf\xe9 TILT=INCLUDE\nTILT=NONE\n" + numbers,
    modern + "TILT=NONE\n" + TableNumbers(table, " ", "3") };
  Comparison styles("styles of one file (0 alike, 1 not)");
  std::string error;
  const auto first = Photometry::Parse(same[0], "first", error);
  for (const std::string& text : same)
  {
    const auto photometry = WriteAndRead(file, text);
    const bool alike = first && photometry && photometry->Pack() == first->Pack() &&
      photometry->GetMaximum() == first->GetMaximum();
    styles.Add(alike ? 0.0 : 1.0, 0.5, [&] { return text.substr(0, 60); });
  }
  // The ballast-lamp photometric factor of the old versions.
  for (const std::string& start : { std::string(), std::string("IESNA91\n") })
  {
    const auto photometry =
      WriteAndRead(file, start + "TILT=NONE\n" + TableNumbers(table, " ", "3"));
    styles.Add(
      photometry && first ? std::abs(photometry->GetMaximum() / first->GetMaximum() - 3) : 1.0,
      1e-15, [] { return "ballast-lamp photometric factor"; });
  }
  return styles.Report();
}

//------------------------------------------------------------------------------
const char* const Tilted = "IES:LM-63-2019\r\n[TEST] made up\r\nTILT=INCLUDE\r\n1 2\r\n0 90\r\n"
                           "1 0.5\r\n1 1000 1 2 3 2 2 0.1 0.1 0\r\n1 1 40\r\n-30 30\r\n"
                           "-45 0 45\r\n1 2\r\n3 4\r\n5 6\r\n";

const char* const Old = "a lamp\nmade up\nTILT=lamp.tlt\n1 1000 1 2 1 1 1 0 0 0\n1 0.5 40\n0 180\n"
                        "0\n12 13\n";

void CheckSound(const Photometry& photometry, Random& random, const std::string& text)
{
  Check(std::isnormal(photometry.GetMaximum()) && photometry.GetMaximum() > 0.0,
    "largest intensity of\n" + text);
  glm::dvec3 axis;
  glm::dvec3 up;
  RandomFrame(random, axis, up);
  const TestLamp lamp(photometry, axis, up);
  bool finite = true;
  for (const glm::vec4& texel : lamp.Texels32)
  {
    finite = finite && !glm::any(glm::isnan(texel)) && !glm::any(glm::isinf(texel));
  }
  Check(finite, "packed data of\n" + text);
  for (int k = 0; k < 4; ++k)
  {
    const glm::dvec3 direction = lamp.Direction(
      1 + k % 3, 45.0 * random.Index(9) - 180.0, k == 3 ? 90.0 : random.Uniform(-180.0, 180.0));
    const double value = lamp.Look(direction);
    const float single = f32::airlightPhotometry(lamp.In32, glm::vec3(direction));
    Check(value >= 0.0 && value <= 1.0 && single >= 0.0f && single <= 1.0f,
      "intensity outside [0, 1] of\n" + text);
  }
}

std::string Mutate(std::string text, Random& random)
{
  const char* const words[] = { "0", "-1", "1e308", "1e-320", "nan", "inf", "1e999", "999999999",
    "1000000", "90", "180", "360", ",", "\n", "\r", "TILT=INCLUDE", "TILT=NONE", "IESNA91\n", "-",
    ".", "e", "\x1a", "\xff", "\t", "2 2" };
  for (int edits = 1 + random.Index(4); edits > 0; --edits)
  {
    const size_t at = random.Index(static_cast<int>(text.size()) + 1);
    const size_t length = random.Index(random.Index(3) == 0 ? 60 : 4);
    switch (random.Index(6))
    {
      case 0:
        text.erase(at, length);
        break;
      case 1:
        text.insert(at, text.substr(at, length));
        break;
      case 2:
        text.insert(at, 1, static_cast<char>(random.Index(256)));
        break;
      case 3:
        text.replace(at, length, words[random.Index(25)]);
        break;
      case 4:
        text.replace(at, std::min<size_t>(1, text.size() - at), 1, "0123456789"[random.Index(10)]);
        break;
      default:
        text.resize(random.Index(20) == 0 ? at : text.size());
    }
  }
  return text;
}

void TestMutations(const std::string& file)
{
  Random random(2026);
  std::vector<std::string> texts = { Tilted, Old };
  for (int kind = 0; kind < TableKinds; ++kind)
  {
    texts.push_back(TableText(RandomTable(random, kind)));
  }
  int accepted = 0;
  constexpr int Count = 20000;
  for (int i = 0; i < Count; ++i)
  {
    const std::string text = Mutate(texts[i % texts.size()], random);
    std::string error;
    std::shared_ptr<const Photometry> photometry = Photometry::Parse(text, "mutant.ies", error);
    if (photometry)
    {
      ++accepted;
      CheckSound(*photometry, random, text);
    }
    Check(photometry ? error.empty() : error.rfind("mutant.ies:", 0) == 0,
      "error '" + error + "' of\n" + text);
    if (i % 100 == 0) // the way through a file is the same
    {
      std::ofstream(file, std::ios::binary) << text;
      Check(!Photometry::Read(file, error) == !photometry, "file and text differ for\n" + text);
    }
  }
  std::cout << accepted << " of " << Count << " mutants were accepted\n";
  Check(accepted > Count / 20 && accepted < Count * 19 / 20, "mutants are all alike");
}
}

//------------------------------------------------------------------------------
int TestPhotometryFormat(int argc, char* argv[])
{
  const std::string file = GetTemporaryFile(argc, argv, "TestPhotometryFormat.ies");
  Check(TestStyles(file), "styles");
  TestMutations(file);
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
