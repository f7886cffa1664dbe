// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkPhaseFunction and its subclasses as objects: parameters by name, media that share one, the
// same function by object and by type, a function of the user's own, and bad input.

#include "AirlightTestCheck.h"
#include "AirlightTestErrors.h"
#include "AirlightTestPhase.h"
#include "Integration/AirlightMath.h"
#include "Phase/AirlightPhaseShape.h"

#include "vtkHenyeyGreensteinPhaseFunction.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPhaseFunction.h"
#include "vtkSchlickPhaseFunction.h"
#include "vtkTabulatedPhaseFunction.h"
#include "vtkVariant.h"

#include <cstdlib>
#include <limits>
#include <sstream>

using namespace airlight_test;
using Medium = vtkParticipatingMedium;

namespace
{
constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

void CheckNear(double value, double expected, double relative, const std::string& what)
{
  Check(std::abs(value - expected) <= relative * std::abs(expected),
    Text(what, " is ", value, ", expected ", expected));
}

// The two have the same function, fit and bound, to the last bit.
void CheckSame(Medium* a, Medium* b, const std::string& what)
{
  for (double mu = -1.0; mu <= 1.0; mu += 1.0 / 16.0)
  {
    Check(a->EvaluatePhaseFunction(mu) == b->EvaluatePhaseFunction(mu),
      Text(what, " at ", mu, ": ", a->EvaluatePhaseFunction(mu), " and ",
        b->EvaluatePhaseFunction(mu)));
  }
  Check(a->GetPhaseErrorBound() == b->GetPhaseErrorBound(), what + ": the bound");
  Check(a->GetNumberOfPhasePoles() == b->GetNumberOfPhasePoles(), what + ": the number of poles");
  for (int k = 0; k < a->GetNumberOfPhasePoles(); ++k)
  {
    double pole[4];
    double other[4];
    a->GetPhasePole(k, pole);
    b->GetPhasePole(k, other);
    Check(std::equal(pole, pole + 4, other), Text(what, ": pole ", k));
  }
}

//------------------------------------------------------------------------------
void TestObjectsAndTypes()
{
  const char* const names[] = { "Isotropic", "HenyeyGreenstein", "Rayleigh", "Schlick",
    "CornetteShanks", "MieHazy", "MieMurky" };
  for (int type = Medium::ISOTROPIC; type < Medium::TABULATED; ++type)
  {
    const auto object =
      vtkSmartPointer<vtkPhaseFunction>::Take(vtkPhaseFunction::NewByName(names[type]));
    Check(object && object->GetName() == names[type], Text("a function named ", names[type]));
    vtkNew<Medium> byType;
    byType->SetPhaseFunction(type);
    if (object->GetNumberOfParameters() > 0)
    {
      byType->SetAnisotropy(-0.6);
      object->SetParameter(object->GetParameterName(0), -0.6);
    }
    vtkNew<Medium> byObject;
    byObject->SetPhaseFunction(object);
    Check(byObject->GetPhaseFunction() == Medium::OBJECT, "its type");
    Check(byObject->GetPhaseFunctionObject() == object, "its object");
    CheckSame(byType, byObject, names[type]);
    CheckNear(object->Evaluate(0.3), byType->EvaluatePhaseFunction(0.3), 0.0, names[type]);
  }
}

// Every function of the library has a name, which finds it, and integrates to 1 over the sphere
// with parameters in the middle and at the ends of their ranges, by the midpoint rule in the angle.
void TestAllClasses()
{
  Check(vtkPhaseFunction::GetNumberOfClasses() >= 8, "the number of functions");
  for (int i = 0; i < vtkPhaseFunction::GetNumberOfClasses(); ++i)
  {
    const std::string name = vtkPhaseFunction::GetNameOfClass(i);
    const auto object = vtkSmartPointer<vtkPhaseFunction>::Take(vtkPhaseFunction::NewByName(name));
    Check(object && object->GetName() == name, "the function " + name);
    if (auto* table = vtkTabulatedPhaseFunction::SafeDownCast(object))
    {
      table->SetTable(MakeTable(TABLE_SMOOTH));
    }
    for (const double share : { 0.0, 0.5, 0.7, 1.0 })
    {
      for (int k = 0; k < object->GetNumberOfParameters(); ++k)
      {
        double range[2];
        object->GetParameterRange(k, range);
        const double value = range[0] + share * (range[1] - range[0]);
        object->SetParameter(object->GetParameterName(k), value);
        CheckNear(object->GetParameter(object->GetParameterName(k)), value, 0.0, name);
      }
      double sum = 0.0;
      constexpr int steps = 200000;
      for (int k = 0; k < steps; ++k)
      {
        const double angle = Pi * (k + 0.5) / steps;
        sum += object->Evaluate(std::cos(angle)) * std::sin(angle);
      }
      CheckNear(
        2.0 * Pi * sum * Pi / steps, 1.0, 1e-5, Text("the integral of ", name, ", ", share));
    }
    std::ostringstream text;
    object->Print(text);
    Check(text.str().find("Name: " + name) != std::string::npos, name + " prints its name");
  }
}

//------------------------------------------------------------------------------
void TestShared()
{
  vtkNew<vtkHenyeyGreensteinPhaseFunction> function;
  vtkNew<Medium> first;
  vtkNew<Medium> second;
  ErrorListener errors(first);
  first->SetPhaseFunction(function);
  second->SetPhaseFunction(function);
  const vtkMTimeType time = first->GetMTime();
  first->SetPhaseFunction(function);
  Check(first->GetMTime() == time, "the same object modifies nothing");
  function->SetAnisotropy(0.7);
  Check(first->GetMTime() > time && second->GetMTime() > time, "a parameter modifies both media");
  vtkNew<Medium> expected;
  expected->SetPhaseFunctionToHenyeyGreenstein();
  expected->SetAnisotropy(0.7);
  CheckSame(first, expected, "the first medium");
  CheckSame(second, expected, "the second medium");
  function->SetAnisotropy(-0.2);
  expected->SetAnisotropy(-0.2);
  CheckSame(first, expected, "the first medium after a change");

  // The types, and back to the object.
  first->SetPhaseFunctionToRayleigh();
  CheckNear(first->EvaluatePhaseFunction(0.0), 3.0 / (16.0 * Pi), 1e-15, "Rayleigh's function");
  first->SetPhaseFunction(Medium::OBJECT);
  CheckSame(first, expected, "the object again");
  first->SetPhaseFunction(nullptr);
  Check(first->GetPhaseFunction() == Medium::ISOTROPIC && !first->GetPhaseFunctionObject(),
    "without an object the medium is isotropic");
  CheckNear(first->EvaluatePhaseFunction(0.3), 0.25 / Pi, 0.0, "the isotropic function");
  Check(errors.Take() == 0, "no error so far");
  first->SetPhaseFunction(Medium::OBJECT);
  Check(errors.Take() == 1 && errors.GetText().find("vtkPhaseFunction") != std::string::npos,
    "an object that is not there: " + errors.GetText());
  Check(first->GetPhaseFunction() == Medium::ISOTROPIC, "the old function stays");

  // The medium's own anisotropy does not concern an object.
  second->SetAnisotropy(0.5);
  CheckNear(second->EvaluatePhaseFunction(1.0), expected->EvaluatePhaseFunction(1.0), 0.0,
    "an object with the medium's anisotropy");
  ErrorListener unused(second);
  second->GetPhaseErrorBound();
  Check(unused.Take() == 1 && unused.GetText().find("0.5") != std::string::npos &&
      unused.GetText().find("HenyeyGreenstein") != std::string::npos,
    "an anisotropy without effect: " + unused.GetText());
}

//------------------------------------------------------------------------------
void TestBadParameters()
{
  vtkNew<vtkSchlickPhaseFunction> function;
  ErrorListener errors(function);
  function->SetAnisotropy(0.25);
  const vtkMTimeType time = function->GetMTime();
  for (const double bad : { 1.0, -1.0, 1.25, inf, -inf, nan })
  {
    function->SetAnisotropy(bad);
    Check(errors.Take() == 1, Text("one error for ", bad));
    const std::string& text = errors.GetText();
    Check(text.find(Text("Anisotropy ", bad)) != std::string::npos &&
        text.find("[-0.99, 0.99]") != std::string::npos && text.find("0.25") != std::string::npos,
      "it names property, value, range and the old value: " + text);
    function->SetParameter("k", bad);
    Check(errors.Take() == 1 && errors.GetText().find("k ") != std::string::npos,
      "by name: " + errors.GetText());
  }
  function->SetParameter("g", 0.5);
  Check(errors.Take() == 1 && errors.GetText().find("\"g\"") != std::string::npos &&
      errors.GetText().find("use one of k") != std::string::npos,
    "an unknown name: " + errors.GetText());
  Check(function->GetParameter("") == 0.0 && errors.Take() == 1, "the value of an unknown name");
  double range[2] = { 7.0, 7.0 };
  for (const int index : { -1, 1 })
  {
    function->GetParameterRange(index, range);
    Check(errors.Take() == 1 && range[0] == 0.0 && range[1] == 0.0, "a range that is not there");
    Check(function->GetParameterName(index).empty() && errors.Take() == 1, "nor is the name");
  }
  Check(function->GetMTime() == time && function->GetAnisotropy() == 0.25, "nothing changed");
  Check(function->Evaluate(nan) == 0.0 && errors.Take() == 1, "a cosine that is no number");
  CheckNear(function->Evaluate(7.0), function->Evaluate(1.0), 0.0, "a cosine above 1");
}

//------------------------------------------------------------------------------
// As TestPhaseErrors for SetPhaseTable().
void TestTableObject()
{
  vtkNew<vtkTabulatedPhaseFunction> function;
  ErrorListener errors(function);
  CheckNear(function->Evaluate(0.3), 0.25 / Pi, 0.0, "the function without a table");
  Check(errors.Take() == 1 && errors.GetText().find("SetTable()") != std::string::npos,
    "a missing table: " + errors.GetText());
  function->Evaluate(0.2);
  Check(errors.Take() == 0, "the error comes once");

  vtkNew<Medium> medium;
  ErrorListener mediumErrors(medium);
  medium->SetPhaseFunction(function);
  CheckNear(medium->EvaluatePhaseFunction(0.3), 0.25 / Pi, 0.0, "the medium without a table");
  Check(mediumErrors.Take() == 1 && mediumErrors.GetText().find("SetTable()") != std::string::npos,
    "a missing table of a medium: " + mediumErrors.GetText());

  const vtkSmartPointer<vtkTable> table = MakeTable(TABLE_SMOOTH);
  function->SetTable(table);
  vtkNew<Medium> byType;
  byType->SetPhaseTable(table);
  byType->SetPhaseFunctionToTabulated();
  CheckSame(byType, medium, "the table");
  Check(function->GetTable() == table, "the table is there");

  vtkNew<vtkTable> empty;
  function->SetTable(empty);
  Check(errors.Take() == 1 && errors.GetText().find("0 rows") != std::string::npos,
    "an empty table: " + errors.GetText());
  Check(function->GetTable() == table, "the old table stays");
  table->SetValue(0, 1, vtkVariant(-1.0));
  table->Modified();
  CheckNear(medium->EvaluatePhaseFunction(0.3), 0.25 / Pi, 0.0, "a spoilt table");
  Check(mediumErrors.Take() == 1 && mediumErrors.GetText().find("row 0") != std::string::npos,
    "a spoilt table is an error: " + mediumErrors.GetText());
}

//------------------------------------------------------------------------------
// A function of the user's: forward, with a bow that no poles follow.
class vtkBowPhaseFunction : public vtkPhaseFunction
{
public:
  static vtkBowPhaseFunction* New();
  vtkTypeMacro(vtkBowPhaseFunction, vtkPhaseFunction);

  double Height = 0.0;

  static double Shape(double angle, double height)
  {
    const double x = (angle - 2.4) / 0.05;
    return std::exp(2.0 * std::cos(angle)) + height * std::exp(-x * x);
  }

  double EvaluateHalfAngle(double s) override { return Shape(2.0 * std::atan(s), this->Height); }

protected:
  vtkBowPhaseFunction() = default;
};
vtkStandardNewMacro(vtkBowPhaseFunction);

void TestOwnFunction()
{
  for (const double height : { 0.0, 0.5 })
  {
    vtkNew<vtkBowPhaseFunction> function;
    function->Height = height;
    Check(function->GetName() == "Bow", "its name is that of the class: " + function->GetName());
    vtkNew<Medium> medium;
    medium->SetPhaseFunction(function);
    const double bound = medium->GetPhaseErrorBound();
    Check(bound <= 1e-3, Text("the bound ", bound, " is within the tolerance"));
    Check((medium->GetNumberOfPhasePoles() > 0) == (height == 0.0),
      Text(medium->GetNumberOfPhasePoles(), " poles with a bow of ", height));
    const auto shape = medium->GetPhaseShape();
    for (int k = 0; k <= 3000; ++k)
    {
      const double angle = Pi * k / 3000.0;
      const double expected = vtkBowPhaseFunction::Shape(angle, height);
      CheckNear(medium->EvaluatePhaseFunction(std::cos(angle)), expected, 1e-12,
        Text("the value at ", angle));
      if (height == 0.0)
      {
        const auto fit = GetPhase<airlight::f64::AirlightPhase>(medium);
        CheckNear(FittedPhase(fit, 1.0 - std::cos(angle), 1.0 + std::cos(angle)), expected,
          bound + 1e-13, Text("the fit at ", angle));
      }
      else
      {
        airlight::f64::AirlightPhase phase{};
        phase.data = shape->Rows.data();
        phase.rows = static_cast<int>(shape->Rows.size());
        CheckNear(airlight::f64::airlightPhase(phase, std::cos(angle)), expected, bound + 1e-13,
          Text("the table at ", angle));
      }
    }
  }
}
}

//------------------------------------------------------------------------------
int TestPhaseFunctionObjects(int, char*[])
{
  TestObjectsAndTypes();
  TestAllClasses();
  TestShared();
  TestBadParameters();
  TestTableObject();
  TestOwnFunction();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
