// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * JSON whose values know the line they stand on, so that every complaint about a scene file can
 * name file, line and key.
 */

#ifndef LocatedJson_h
#define LocatedJson_h

#include "formats/Vector3.h"

#include <nlohmann/json.hpp>

#include <limits>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace airlight
{

/**
 * One value of a JSON file. All members throw UserError if the file does not hold what they return.
 */
class LocatedJson
{
public:
  /**
   * Read a file and return its outermost value. Malformed JSON, keys given twice and numbers that
   * overflow are errors.
   */
  static LocatedJson ReadFile(const std::string& fileName);

  /**
   * Require an object that has all keys of `required` and no key outside `required` and `optional`.
   */
  void CheckKeys(
    const std::vector<std::string>& required, const std::vector<std::string>& optional = {}) const;

  bool Has(const std::string& key) const;
  LocatedJson operator[](const std::string& key) const;
  std::vector<LocatedJson> GetItems() const;

  ///@{
  /**
   * The value itself, with the range it has to be in, ends included.
   */
  std::string GetString() const;
  bool GetBoolean() const;
  double GetNumber(double low, double high) const;
  int GetInteger(int low, int high) const;
  Vector3 GetVector(double low = -std::numeric_limits<double>::max(),
    double high = std::numeric_limits<double>::max()) const;
  ///@}

  /**
   * Throw UserError: "file:line: <name of this value> <complaint>".
   */
  [[noreturn]] void Fail(const std::string& complaint) const;

private:
  using Path = nlohmann::json::json_pointer;
  struct Document
  {
    std::string FileName;
    nlohmann::json Root;
    std::map<std::string, int> Lines; // of keys and array items, by path
  };

  LocatedJson(std::shared_ptr<const Document> document, const Path& path, const std::string& name);

  const nlohmann::json& GetValue() const { return this->File->Root.at(this->Where); }
  [[noreturn]] void FailAt(const Path& path, const std::string& message) const;
  std::string GetShortText() const;

  std::shared_ptr<const Document> File;
  Path Where;
  std::string Name; // as users write it: medium.phase.g, lights[0].position
};

}

#endif
