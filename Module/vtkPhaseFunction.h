// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPhaseFunction
 * @brief   the distribution of scattered light over angle
 *
 * A phase function gives, for each scattering angle theta, the fraction of the scattered light per
 * solid angle, in 1/sr. Its integral over the sphere is 1. Give one to
 * vtkParticipatingMedium::SetPhaseFunction().
 *
 * NewByName() creates a phase function by its name. SetParameter() sets its parameters by name;
 * each subclass also has setters of its own.
 *
 * A subclass (in C++) needs EvaluateHalfAngle() only; AddParameter() declares its parameters. A
 * phase function is integrated in closed form through a fit by poles, or from a table if no fit is
 * good enough; see vtkParticipatingMedium::SetPhaseTolerance() and Documentation/physics.md.
 *
 * Errors: invalid values give an error and the old value is kept.
 *
 * @sa vtkParticipatingMedium vtkTabulatedPhaseFunction
 */

#ifndef vtkPhaseFunction_h
#define vtkPhaseFunction_h

#include "vtkAirlightModule.h" // for export macro
#include "vtkObject.h"

#include <memory> // for the shape
#include <string> // for names
#include <vector> // for the parameters

namespace airlight
{
struct PhaseShape;
}

class VTKAIRLIGHT_EXPORT vtkPhaseFunction : public vtkObject
{
public:
  vtkTypeMacro(vtkPhaseFunction, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The phase function in 1/sr at the cosine of the scattering angle; 1 is forward. Values beyond
   * [-1, 1] count as -1 and 1. NaN is an error and gives 0.
   */
  double Evaluate(double cosTheta);

  /**
   * The name: that of the class without "vtk" and "PhaseFunction", such as "HenyeyGreenstein".
   */
  std::string GetName();

  ///@{
  /**
   * The parameters: their names, their ranges (minimum and maximum, both included) and their
   * values. Units and defaults are those of the subclass's setters. Index range: 0 to
   * GetNumberOfParameters() - 1. An unknown index or name is an error; the name is then empty, the
   * range (0, 0) and the value 0. A value outside the range is an error and the old one is kept.
   */
  int GetNumberOfParameters();
  std::string GetParameterName(int index);
  void GetParameterRange(int index, double range[2]);
  void SetParameter(const std::string& name, double value);
  double GetParameter(const std::string& name);
  ///@}

  ///@{
  /**
   * All phase functions of the library, by the names of GetName(). NewByName() returns a new one
   * with default parameters, which the caller owns; an unknown name gives a warning and null. Index
   * range of GetNameOfClass(): 0 to GetNumberOfClasses() - 1; an unknown index gives a warning and
   * an empty name.
   */
  static int GetNumberOfClasses();
  static std::string GetNameOfClass(int index);
  static VTK_NEWINSTANCE vtkPhaseFunction* NewByName(const std::string& name);
  ///@}

#ifndef __VTK_WRAP__
  /**
   * The phase function in 1/sr at s = tan(theta/2), with theta the scattering angle: from 0
   * (forward) to 1e150 (backward). A subclass must return a finite value above 0, and the integral
   * over the sphere must be 1; neither is checked. If the value depends on anything but the
   * parameters, the subclass must call Modified() when that changes. In s, narrow forward and
   * backward peaks keep all their digits.
   */
  virtual double EvaluateHalfAngle(double s) = 0;

  /**
   * tan(theta/2) of the cosine, which is clamped to [-1, 1]; at most 1e150.
   */
  static double GetHalfAngleTangent(double cosTheta);

  // Empty, or why the function cannot be used; it is then isotropic. For the library's own use.
  virtual std::string FindProblem() { return std::string(); }

  // The phase function as it is integrated, with at most this relative error if that is possible.
  // It is made when it is first needed, and again after a change. For the library's own use.
  std::shared_ptr<const airlight::PhaseShape> GetShape(double tolerance);
#endif

protected:
  vtkPhaseFunction();
  ~vtkPhaseFunction() override;

  /**
   * For constructors of subclasses: adds a parameter with its range, both ends included, and its
   * default. Indices follow the order of the calls, from 0.
   */
  void AddParameter(const char* name, double minimum, double maximum, double value);

#ifndef __VTK_WRAP__
  // The default fits poles, and makes a table if they do not suffice. For the library's own
  // functions, some of which are exact.
  virtual std::shared_ptr<const airlight::PhaseShape> MakeShape(double tolerance);
#endif

  ///@{
  /**
   * For the setters and getters of subclasses. The index is that of an added parameter; errors name
   * `property`.
   */
  void SetParameterAt(size_t index, const char* property, double value);
  double GetParameterAt(size_t index) const { return this->Parameters[index].Value; }
  ///@}

private:
  vtkPhaseFunction(const vtkPhaseFunction&) = delete;
  void operator=(const vtkPhaseFunction&) = delete;

  struct Parameter
  {
    std::string Name;
    double Range[2];
    double Value;
  };

  Parameter* FindParameter(const std::string& name);
  bool HasParameterAt(int index);

  std::vector<Parameter> Parameters;
  vtkMTimeType ProblemTime = 0; // of this object when its problem was reported
  std::shared_ptr<const airlight::PhaseShape> Shape;
  double ShapeTolerance = 0.0;
  vtkMTimeType ShapeTime = 0; // of this object when the shape was made
};

#endif
