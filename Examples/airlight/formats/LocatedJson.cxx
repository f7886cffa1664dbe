// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "formats/LocatedJson.h"

#include "formats/Files.h"
#include "formats/LocatedJsonLines.h"
#include "formats/UserError.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace airlight
{

namespace
{
std::string JoinKeys(const std::vector<std::string>& a, const std::vector<std::string>& b)
{
  std::string text;
  for (const auto* keys : { &a, &b })
  {
    for (const std::string& key : *keys)
    {
      text += (text.empty() ? "" : ", ") + key;
    }
  }
  return text;
}

bool Contains(const std::vector<std::string>& keys, const std::string& key)
{
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

std::string DescribeRange(double low, double high)
{
  std::ostringstream text;
  if (low > -std::numeric_limits<double>::max())
  {
    text << " of at least " << low;
  }
  if (high < std::numeric_limits<double>::max())
  {
    text << (text.tellp() > 0 ? " and" : " of") << " at most " << high;
  }
  return text.str();
}
}

//------------------------------------------------------------------------------
LocatedJson::LocatedJson(
  std::shared_ptr<const Document> document, const Path& path, const std::string& name)
  : File(std::move(document))
  , Where(path)
  , Name(name)
{
}

//------------------------------------------------------------------------------
LocatedJson LocatedJson::ReadFile(const std::string& fileName)
{
  auto document = std::make_shared<Document>();
  document->FileName = fileName;
  const std::string text = ReadTextFile(fileName);
  document->Lines = FindJsonLines(text, fileName);
  document->Root = nlohmann::json::parse(text);
  return LocatedJson(document, Path(), "");
}

//------------------------------------------------------------------------------
void LocatedJson::CheckKeys(
  const std::vector<std::string>& required, const std::vector<std::string>& optional) const
{
  const std::string owner = this->Name.empty() ? "the scene" : this->Name;
  const auto& value = this->GetValue();
  if (!value.is_object())
  {
    this->FailAt(this->Where,
      owner + " must be an object with the keys " + JoinKeys(required, optional) + ", not " +
        this->GetShortText());
  }
  for (const auto& item : value.items())
  {
    if (!Contains(required, item.key()) && !Contains(optional, item.key()))
    {
      this->FailAt(this->Where / item.key(),
        "unknown key '" + item.key() + "' in " + owner +
          "; known keys: " + JoinKeys(required, optional));
    }
  }
  for (const std::string& key : required)
  {
    if (!value.contains(key))
    {
      this->FailAt(
        this->Where, std::string("missing key '").append(key).append("' in ").append(owner));
    }
  }
}

//------------------------------------------------------------------------------
bool LocatedJson::Has(const std::string& key) const { return this->GetValue().contains(key); }

//------------------------------------------------------------------------------
LocatedJson LocatedJson::operator[](const std::string& key) const
{
  return LocatedJson(
    this->File, this->Where / key, this->Name.empty() ? key : this->Name + "." + key);
}

//------------------------------------------------------------------------------
std::vector<LocatedJson> LocatedJson::GetItems() const
{
  if (!this->GetValue().is_array())
  {
    this->Fail("must be a list [...], not " + this->GetShortText());
  }
  std::vector<LocatedJson> items;
  for (std::size_t i = 0; i < this->GetValue().size(); ++i)
  {
    const std::string name = this->Name + "[" + std::to_string(i) + "]";
    items.push_back(LocatedJson(this->File, this->Where / i, name));
  }
  return items;
}

//------------------------------------------------------------------------------
std::string LocatedJson::GetString() const
{
  if (!this->GetValue().is_string())
  {
    this->Fail("must be a string, not " + this->GetShortText());
  }
  return this->GetValue().get<std::string>();
}

//------------------------------------------------------------------------------
bool LocatedJson::GetBoolean() const
{
  if (!this->GetValue().is_boolean())
  {
    this->Fail("must be true or false, not " + this->GetShortText());
  }
  return this->GetValue().get<bool>();
}

//------------------------------------------------------------------------------
double LocatedJson::GetNumber(double low, double high) const
{
  const auto& value = this->GetValue();
  const double number = value.is_number() ? value.get<double>() : std::nan("");
  if (!(number >= low && number <= high))
  {
    this->Fail("must be a number" + DescribeRange(low, high) + ", not " + this->GetShortText());
  }
  return number;
}

//------------------------------------------------------------------------------
int LocatedJson::GetInteger(int low, int high) const
{
  const auto& value = this->GetValue();
  const double number = value.is_number_integer() ? value.get<double>() : std::nan("");
  if (!(number >= low && number <= high))
  {
    this->Fail(
      "must be a whole number" + DescribeRange(low, high) + ", not " + this->GetShortText());
  }
  return static_cast<int>(number);
}

//------------------------------------------------------------------------------
Vector3 LocatedJson::GetVector(double low, double high) const
{
  if (!this->GetValue().is_array() || this->GetValue().size() != 3)
  {
    this->Fail("must be a list of 3 numbers, not " + this->GetShortText());
  }
  const std::vector<LocatedJson> items = this->GetItems();
  return { items[0].GetNumber(low, high), items[1].GetNumber(low, high),
    items[2].GetNumber(low, high) };
}

//------------------------------------------------------------------------------
void LocatedJson::Fail(const std::string& complaint) const
{
  this->FailAt(this->Where, (this->Name.empty() ? "the scene" : this->Name) + " " + complaint);
}

//------------------------------------------------------------------------------
void LocatedJson::FailAt(const Path& path, const std::string& message) const
{
  const auto line = this->File->Lines.find(path.to_string());
  throw UserError(this->File->FileName + ":" +
    std::to_string(line == this->File->Lines.end() ? 1 : line->second) + ": " + message);
}

//------------------------------------------------------------------------------
std::string LocatedJson::GetShortText() const
{
  const auto& value = this->GetValue();
  if (value.is_object())
  {
    return "an object";
  }
  // Never throws, whatever bytes the strings hold; long values say no more than their beginning.
  std::string text = value.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
  return text.size() > 60 ? text.substr(0, 57) + "..." : text;
}

}
