// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A data object of the user's and what the library derives from it, such as a mesh and its tree. It
 * is derived again when the data object is modified.
 */

#ifndef AirlightDerivedData_h
#define AirlightDerivedData_h

#include "Medium/AirlightChange.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <memory>
#include <string>

namespace airlight
{
// Result::Build(Data*, std::string& error) makes the result, or null and an error that continues
// "The <name>".
template <typename Data, typename Result>
class DerivedData
{
public:
  // "density image", "image", and the error without data.
  DerivedData(const char* name, const char* shortName, const char* missing)
    : Name(name)
    , ShortName(shortName)
    , Missing(missing)
  {
  }

  Change Set(Data* data)
  {
    if (this->Source == data)
    {
      return {};
    }
    std::string error;
    std::shared_ptr<const Result> made;
    if (data && !(made = Result::Build(data, error)))
    {
      return { false,
        std::string("The ") + this->Name + " " + error + ". The old " + this->ShortName +
          " stays." };
    }
    this->Source = data;
    this->Made = made;
    this->MadeTime = this->GetMTime();
    return { true, "" };
  }

  Data* Get() const { return this->Source; }
  vtkMTimeType GetMTime() const { return this->Source ? this->Source->GetMTime() : 0; }

  // The result, or null with an error. An error is given once for each modification of the data or,
  // without data, of the owner.
  std::shared_ptr<const Result> Update(vtkMTimeType ownerTime, std::string& error)
  {
    if (!this->Source)
    {
      error = this->MissingTime != ownerTime ? this->Missing : "";
      this->MissingTime = ownerTime;
    }
    else if (this->MadeTime != this->GetMTime())
    {
      this->Made = Result::Build(this->Source, error);
      this->MadeTime = this->GetMTime();
      error = this->Made ? ""
                         : std::string("The ") + this->Name + " " + error +
          ". The medium is ignored until it is fixed.";
    }
    return this->Made;
  }

private:
  const char* Name;
  const char* ShortName;
  const char* Missing;
  vtkSmartPointer<Data> Source;
  std::shared_ptr<const Result> Made;
  vtkMTimeType MadeTime = 0;
  vtkMTimeType MissingTime = 0; // of the owner when missing data was reported
};
}

#endif
