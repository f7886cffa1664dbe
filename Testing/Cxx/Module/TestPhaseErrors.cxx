// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Phase functions with bad input: tables that are none, tables that change, an anisotropy where
// there is none. Every error says what was wrong, and the old state stays.

#include "AirlightTestCheck.h"
#include "AirlightTestErrors.h"
#include "AirlightTestPhase.h"

#include "vtkNew.h"
#include "vtkStringArray.h"
#include "vtkVariant.h"

#include <cstdlib>
#include <functional>
#include <limits>

using namespace airlight_test;
using Medium = vtkParticipatingMedium;

namespace
{
constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

void CheckNear(double value, double expected, const std::string& what)
{
  Check(std::abs(value - expected) <= 1e-12 * std::abs(expected),
    Text(what, " is ", value, ", expected ", expected));
}

//------------------------------------------------------------------------------
// Rayleigh's function: quickly fitted, and not what a medium without a table has.
vtkSmartPointer<vtkTable> QuickTable()
{
  return SampleTable(0.0, 180.0, 5.0, [](double a) { return 1.0 + std::cos(a) * std::cos(a); });
}

// The medium refuses the table with one error that has all of `words`, and keeps the old table.
void CheckRefused(const std::string& what, vtkTable* bad, const std::vector<std::string>& words)
{
  vtkNew<Medium> medium;
  const vtkSmartPointer<vtkTable> good = QuickTable();
  medium->SetPhaseTable(good);
  medium->SetPhaseFunctionToTabulated();
  const double before = medium->EvaluatePhaseFunction(0.5);
  const vtkMTimeType time = medium->GetMTime();
  ErrorListener errors(medium);
  medium->SetPhaseTable(bad);
  const int count = errors.Take();
  Check(count == 1, Text(what, ": ", count, " errors"));
  for (const std::string& word : words)
  {
    Check(errors.GetText().find(word) != std::string::npos,
      what + ": no \"" + word + "\" in \"" + errors.GetText() + "\"");
  }
  Check(medium->GetPhaseTable() == good, what + ": the old table stays");
  Check(medium->GetMTime() == time, what + " modifies nothing");
  CheckNear(medium->EvaluatePhaseFunction(0.5), before, what + ": the value before");
  Check(errors.Take() == 0, what + ": no error afterwards");
}

// Good rows at 0, 45, 90, 135, 180 degrees with the values 5, 4, 3, 2, 1.
vtkSmartPointer<vtkTable> GoodTable()
{
  return SampleTable(0.0, 180.0, 45.0, [](double angle) { return 5.0 - angle * 4.0 / Pi; });
}

// The good table with one cell changed.
vtkSmartPointer<vtkTable> Spoilt(vtkIdType row, vtkIdType column, double value)
{
  const vtkSmartPointer<vtkTable> table = GoodTable();
  table->SetValue(row, column, vtkVariant(value));
  return table;
}

void TestBadShapes()
{
  vtkNew<vtkTable> empty;
  CheckRefused("a table without anything", empty, { "0 rows", "0 columns", "at least 2" });
  const vtkSmartPointer<vtkTable> headers = GoodTable();
  headers->SetNumberOfRows(0);
  CheckRefused("a table without rows", headers, { "0 rows", "2 columns", "at least 2" });
  const vtkSmartPointer<vtkTable> oneColumn = GoodTable();
  oneColumn->RemoveColumn(1);
  CheckRefused("one column", oneColumn, { "5 rows", "1 column", "at least 2" });
  const vtkSmartPointer<vtkTable> oneRow = GoodTable();
  oneRow->SetNumberOfRows(1);
  CheckRefused("one row", oneRow, { "1 row", "2 columns", "at least 2" });

  for (int column = 0; column < 2; ++column)
  {
    const vtkSmartPointer<vtkTable> good = GoodTable();
    vtkNew<vtkStringArray> text;
    text->SetName("text");
    for (int row = 0; row < 5; ++row)
    {
      text->InsertNextValue("much");
    }
    vtkNew<vtkTable> table;
    table->AddColumn(column == 0 ? text.Get() : good->GetColumn(0));
    table->AddColumn(column == 1 ? text.Get() : good->GetColumn(1));
    CheckRefused("a column of text", table, { "much", "row 0", column == 0 ? "angle" : "value" });
  }
}

void TestBadCells()
{
  CheckRefused("an angle below 0", Spoilt(0, 0, -2.5), { "angle -2.5", "row 0", "[0, 180]" });
  CheckRefused("an angle above 180", Spoilt(4, 0, 181.5), { "angle 181.5", "row 4", "[0, 180]" });
  CheckRefused("a descending angle", Spoilt(2, 0, 40.0), { "angle 40", "row 2", "ascend" });
  CheckRefused("an angle that is no number", Spoilt(3, 0, nan), { "nan", "row 3" });
  CheckRefused("an infinite angle", Spoilt(3, 0, inf), { "inf", "row 3" });
  CheckRefused("a value of 0", Spoilt(2, 1, 0.0), { "value 0", "row 2", "above 0" });
  CheckRefused("a negative value", Spoilt(1, 1, -3.5), { "value -3.5", "row 1", "above 0" });
  CheckRefused("an infinite value", Spoilt(4, 1, inf), { "inf", "row 4", "finite" });
  CheckRefused("a value that is no number", Spoilt(0, 1, nan), { "nan", "row 0", "finite" });

  // Every angle twice, whatever rounding makes of it.
  vtkNew<Medium> medium;
  ErrorListener errors(medium);
  for (int tenths = 1; tenths < 1800; ++tenths)
  {
    const double angle = 0.1 * tenths;
    const vtkSmartPointer<vtkTable> table = Spoilt(1, 0, angle);
    table->SetValue(2, 0, vtkVariant(angle));
    medium->SetPhaseTable(table);
    Check(errors.Take() == 1 && !medium->GetPhaseTable(),
      Text("the angle ", angle, " twice is refused"));
    Check(errors.GetText().find("row 2") != std::string::npos,
      "the error names the row: " + errors.GetText());
  }
}

//------------------------------------------------------------------------------
void TestMissingTable()
{
  vtkNew<Medium> medium;
  ErrorListener errors(medium);
  ErrorListener warnings(medium, vtkCommand::WarningEvent); // five rows are few
  medium->SetPhaseFunctionToTabulated();
  Check(errors.Take() == 0, "choosing Tabulated before there is a table is no error");
  CheckNear(medium->EvaluatePhaseFunction(0.3), 0.25 / Pi, "the function without a table");
  Check(errors.Take() == 1, "a missing table is an error at first use");
  Check(errors.GetText().find("SetPhaseTable()") != std::string::npos,
    "the error says what to do: " + errors.GetText());
  CheckNear(medium->EvaluatePhaseFunction(-0.3), 0.25 / Pi, "the function without a table");
  CheckNear(medium->GetPhaseErrorBound(), 0.0, "the bound without a table");
  Check(medium->GetNumberOfPhasePoles() == 1, "one pole without a table");
  Check(errors.Take() == 0, "the error comes once, not at each use");

  medium->SetPhaseTable(GoodTable());
  CheckNear(medium->EvaluatePhaseFunction(1.0) / medium->EvaluatePhaseFunction(-1.0), 5.0,
    "contrast of the table set later");
  Check(errors.Take() == 0, "no error with a table");

  medium->SetPhaseTable(nullptr);
  CheckNear(medium->EvaluatePhaseFunction(0.3), 0.25 / Pi, "the function after the table left");
  Check(errors.Take() == 1, "a table that left is an error at first use");
}

void TestTableChanges()
{
  vtkNew<Medium> medium;
  ErrorListener errors(medium);
  ErrorListener warnings(medium, vtkCommand::WarningEvent);
  const vtkSmartPointer<vtkTable> table = QuickTable();
  medium->SetPhaseTable(table);
  medium->SetPhaseFunctionToTabulated();
  const auto contrast = [&] {
    return medium->EvaluatePhaseFunction(1.0) / medium->EvaluatePhaseFunction(-1.0);
  };
  const double bound = medium->GetPhaseErrorBound();
  CheckNear(contrast(), 1.0, "contrast of the table");
  const vtkMTimeType time = medium->GetMTime();

  table->SetValue(0, 1, vtkVariant(2.2));
  table->Modified();
  Check(medium->GetMTime() > time, "a modified table modifies the medium");
  CheckNear(contrast(), 1.1, "contrast of the modified table");
  Check(medium->GetPhaseErrorBound() != bound, "a modified table is fitted again");
  Check(errors.Take() == 0, "no error while the table is good");

  table->SetValue(3, 1, vtkVariant(-2.0));
  table->Modified();
  CheckNear(medium->EvaluatePhaseFunction(0.3), 0.25 / Pi, "the function of a spoilt table");
  CheckNear(medium->GetPhaseErrorBound(), 0.0, "the bound of a spoilt table");
  const int count = errors.Take();
  Check(count == 1, Text("a spoilt table is one error, not ", count));
  Check(errors.GetText().find("row 3") != std::string::npos &&
      errors.GetText().find("value -2") != std::string::npos,
    "the error names row and value: " + errors.GetText());

  table->SetValue(3, 1, vtkVariant(2.0));
  table->Modified();
  CheckNear(contrast(), 1.1, "contrast of the fixed table");
  Check(errors.Take() == 0, "no error once the table is fixed");
}

//------------------------------------------------------------------------------
// With a function that has none, SetAnisotropy(0.5) has no effect, which is an error when the
// medium is used, in either order; a function that is chosen later and has one takes it.
void TestAnisotropyUnused(int type, bool first)
{
  vtkNew<Medium> medium;
  ErrorListener errors(medium);
  const std::string what = Text("anisotropy with phase function ", type, first ? ", first" : "");
  medium->SetPhaseTable(QuickTable());
  medium->SetPhaseFunctionToHenyeyGreenstein();
  medium->SetAnisotropy(0.25);
  medium->SetPhaseFunction(type);
  medium->GetPhaseErrorBound();
  Check(errors.Take() == 0, what + ": none once it has had a meaning");
  vtkNew<Medium> fresh;
  ErrorListener freshErrors(fresh);
  fresh->SetPhaseTable(QuickTable());
  if (first)
  {
    fresh->SetAnisotropy(0.5);
    fresh->SetPhaseFunction(type);
  }
  else
  {
    fresh->SetPhaseFunction(type);
    fresh->SetAnisotropy(0.5);
  }
  Check(freshErrors.Take() == 0, what + ": no error before it is used");
  CheckNear(fresh->GetAnisotropy(), 0.5, what + ": the value");
  fresh->GetPhaseErrorBound();
  Check(freshErrors.Take() == 1, what + ": one error in use");
  Check(freshErrors.GetText().find("0.5") != std::string::npos &&
      freshErrors.GetText().find("HenyeyGreenstein") != std::string::npos,
    what + ": the error names value and remedy: " + freshErrors.GetText());
  fresh->GetPhaseErrorBound();
  Check(freshErrors.Take() == 0, what + ": the error comes once");
  fresh->SetPhaseFunctionToHenyeyGreenstein();
  CheckNear(fresh->EvaluatePhaseFunction(1.0), (1.0 - 0.25) / (4.0 * Pi * 0.125),
    what + ": a function that has one takes it");
  fresh->GetPhaseErrorBound();
  Check(freshErrors.Take() == 0, what + ": and is no error");
}

void TestAnisotropyRemoved(int type)
{
  vtkNew<Medium> medium;
  ErrorListener errors(medium);
  const std::string what = Text("no anisotropy with phase function ", type);
  medium->SetPhaseTable(QuickTable());
  medium->SetPhaseFunction(type);
  medium->SetAnisotropy(0.5);
  medium->SetAnisotropy(0.0);
  medium->GetPhaseErrorBound();
  Check(errors.Take() == 0, what + ": 0 is no error");
  CheckNear(medium->GetAnisotropy(), 0.0, what + ": 0 is taken");
}

void TestUnusedAnisotropies()
{
  const int types[] = { Medium::ISOTROPIC, Medium::RAYLEIGH, Medium::MIE_HAZY, Medium::MIE_MURKY,
    Medium::TABULATED };
  for (const int type : types)
  {
    TestAnisotropyUnused(type, false);
    TestAnisotropyUnused(type, true);
    TestAnisotropyRemoved(type);
  }
}

// Before a function is chosen it may be set, as long as one is chosen in time.
void TestAnisotropyFirst()
{
  for (const int type : { Medium::HENYEY_GREENSTEIN, Medium::SCHLICK, Medium::CORNETTE_SHANKS })
  {
    vtkNew<Medium> medium;
    ErrorListener errors(medium);
    medium->SetAnisotropy(0.5);
    medium->SetPhaseFunction(type);
    Check(medium->EvaluatePhaseFunction(1.0) > 2.0 * medium->EvaluatePhaseFunction(-1.0),
      Text("an anisotropy set before the function ", type, " counts"));
    medium->GetPhaseErrorBound();
    Check(errors.Take() == 0, "an anisotropy set before the function is no error");
    medium->SetPhaseFunctionToIsotropic();
    medium->GetPhaseErrorBound();
    Check(errors.Take() == 0, "back to isotropic is no error");
    CheckNear(medium->GetAnisotropy(), 0.5, "the anisotropy after the return to isotropic");
  }

  vtkNew<Medium> never;
  ErrorListener errors(never);
  never->SetAnisotropy(0.5);
  Check(errors.Take() == 0, "an anisotropy without a function is no error at first");
  never->GetPhaseErrorBound();
  Check(errors.Take() == 1, "it is one when the medium is used");
  Check(errors.GetText().find("0.5") != std::string::npos, "it names the value");
  never->SetAnisotropy(0.0);
  never->GetPhaseErrorBound();
  Check(errors.Take() == 0, "taken back, it is none");
}
}

//------------------------------------------------------------------------------
int TestPhaseErrors(int, char*[])
{
  TestBadShapes();
  TestBadCells();
  TestMissingTable();
  TestTableChanges();
  TestUnusedAnisotropies();
  TestAnisotropyFirst();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
