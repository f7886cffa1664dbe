// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Files and grids that are no density: one error that says what is wrong and what there is, and an
// empty output. Files that end anywhere.

#ifdef AIRLIGHT_HAS_OPENVDB
#include "AirlightTestReader.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <random>
#include <vector>
#endif

#include <cstdlib>
#include <iostream>

#ifdef AIRLIGHT_HAS_OPENVDB
using namespace airlight_test;

namespace
{
std::string Folder;

// The reader has read a file before; its image must not stay.
void CheckRefused(const std::string& name, const std::string& file, const char* grid,
  std::vector<std::string> words)
{
  Reader reader(Folder + "noise.vdb");
  reader.Read();
  reader->SetFileName(file.c_str());
  reader->SetGridName(grid);
  reader->Update();
  Check(reader.Errors.Take() == 1, name + ": one error");
  std::cout << name << ": " << reader.Errors.GetText() << "\n";
  words.insert(words.end(), { "vtkOpenVDBDensityReader (0x", file });
  for (const std::string& word : words)
  {
    Check(reader.Errors.GetText().find(word) != std::string::npos, name + ": says " + word);
  }
  Check(reader->GetOutput()->GetNumberOfPoints() == 0, name + ": no output");
  reader->SetFileName((Folder + "noise.vdb").c_str());
  reader->SetGridName(nullptr);
  Check(reader.Read()->GetNumberOfPoints() > 0, name + ": a good file afterwards");
}

void TestFiles()
{
  CheckRefused("no name", "", nullptr, { "SetFileName" });
  CheckRefused("missing", Folder + "missing.vdb", nullptr, { "does not exist" });
  CheckRefused("folder", Folder, nullptr, { "is not a file" });
  std::ofstream(Folder + "void.vdb").close();
  CheckRefused("empty file", Folder + "void.vdb", nullptr, { "is empty" });
  std::ofstream(Folder + "text.vdb") << "ply\nformat ascii 1.0\n";
  CheckRefused("text", Folder + "text.vdb", nullptr, { "not an OpenVDB file" });
  std::ofstream(Folder + "short.vdb") << " BDV";
  CheckRefused("its first four bytes", Folder + "short.vdb", nullptr, { "ends too early" });
}

void TestGrids()
{
  const std::string types = Folder + "types.vdb";
  CheckRefused("vectors only", Folder + "vectors.vdb", nullptr,
    { "no grid of float or double", "'velocity' (vec3s)" });
  CheckRefused("points only", Folder + "onlypoints.vdb", nullptr,
    { "no grid of float or double", "'points' (ptdataidx32)" });
  CheckRefused("no grids", Folder + "nogrids.vdb", nullptr, { "no grids" });
  CheckRefused("vector grid", types, "velocity", { "'velocity' holds vec3s", "'fog' (float)" });
  CheckRefused("point grid", types, "points", { "'points' holds ptdataidx32", "'fog' (float)" });
  CheckRefused("no such grid", types, "smoke",
    { "no grid 'smoke'", "'velocity' (vec3s), 'points' (ptdataidx32), 'fog' (float)" });
  CheckRefused(
    "nothing active", Folder + "empty.vdb", nullptr, { "grid 'nothing': it has no active voxels" });
}

void TestMaximumDimension()
{
  Reader reader(Folder + "noise.vdb");
  for (int bad : { 7, 0, -1, 4097 })
  {
    reader->SetMaximumDimension(bad);
    Check(reader.Errors.Take() == 1 &&
        reader.Errors.GetText().find(std::to_string(bad)) != std::string::npos,
      Text("MaximumDimension ", bad));
    Check(reader->GetMaximumDimension() == 512, "the old value stays");
  }
}

//------------------------------------------------------------------------------
// The first part of a file, at many lengths: an error each, and none of the values.
void TestTruncated(const std::string& name)
{
  std::ifstream file(Folder + name, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  const std::string cut = Folder + "cut.vdb";
  int count = 0;
  for (std::size_t length = 1; length < bytes.size(); length += length < 1000 ? 7 : 499)
  {
    std::ofstream(cut, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(length));
    Reader reader(cut);
    reader->Update();
    const bool ok = reader.Errors.Take() == 1 && reader->GetOutput()->GetNumberOfPoints() == 0;
    Check(ok, Text(name, " cut after ", length, " bytes: ", reader.Errors.GetText()));
    ++count;
  }
  std::ofstream(cut, std::ios::binary)
    .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  Check(Reader(cut).Read()->GetNumberOfPoints() > 0, name + ": the whole file is read");
  std::cout << name << ": refused at " << count << " lengths\n";
}

//------------------------------------------------------------------------------
// Eight bytes anywhere become others, many times: an error and no image, or an image of numbers.
void TestDamaged(const std::string& name)
{
  std::ifstream file(Folder + name, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  const std::string damaged = Folder + "damaged.vdb";
  std::mt19937 random(5);
  int refused = 0;
  for (int i = 0; i < 300; ++i)
  {
    std::string text = bytes;
    const std::size_t place = random() % (bytes.size() - 8);
    const char value = i % 3 == 0 ? '\xff' : static_cast<char>(random());
    std::fill_n(text.begin() + static_cast<std::ptrdiff_t>(place), 8, i % 3 == 1 ? '\0' : value);
    std::ofstream(damaged, std::ios::binary)
      .write(text.data(), static_cast<std::streamsize>(text.size()));
    Reader reader(damaged);
    reader->SetMaximumDimension(32);
    reader->Update();
    const int errors = reader.Errors.Take();
    refused += errors;
    const std::string what = Text(name, " damaged at byte ", place, ": ", reader.Errors.GetText());
    Check(errors == (reader->GetOutput()->GetNumberOfPoints() == 0 ? 1 : 0), what);
    vtkDataArray* values = reader->GetOutput()->GetPointData()->GetScalars();
    double range[2] = { 0.0, 0.0 };
    if (values)
    {
      values->GetRange(range);
    }
    Check(std::isfinite(range[0]) && std::isfinite(range[1]), what + ": numbers");
  }
  Check(refused > 0, name + ": some damage is noticed");
  std::cout << name << ": refused " << refused << " of 300 times\n";
}
}
#endif

//------------------------------------------------------------------------------
int TestOpenVDBDensityReaderErrors(int argc, char* argv[])
{
#ifdef AIRLIGHT_HAS_OPENVDB
  Folder = WriteFiles("TestOpenVDBDensityReaderErrors", argc, argv);
  TestFiles();
  TestGrids();
  TestMaximumDimension();
  TestTruncated("noise.vdb");
  TestTruncated("half.vdb");
  TestTruncated("stream.vdb");
  TestTruncated("names.vdb");
  TestTruncated("background.vdb"); // nodes that are half read hold its background, no pointers
  for (const char* name : { "background.vdb", "half.vdb", "stream.vdb", "tiles.vdb" })
  {
    TestDamaged(name);
  }
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
#else
  (void)argc;
  (void)argv;
  std::cout << "skipped: built without OpenVDB\n";
  return 125;
#endif
}
