// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "formats/LocatedJsonLines.h"

#include "formats/UserError.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <iterator>
#include <vector>

namespace airlight
{

namespace
{
// nlohmann's parser reports no positions, but it reads through an iterator: this one leaves its
// place behind. The parser is never more than one character past the token that it reports.
class TracingIterator
{
public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  TracingIterator(const char* place, const char** trace)
    : Place(place)
    , Trace(trace)
  {
  }
  reference operator*() const { return *this->Place; }
  TracingIterator& operator++()
  {
    *this->Trace = ++this->Place;
    return *this;
  }
  bool operator==(const TracingIterator& other) const { return this->Place == other.Place; }
  bool operator!=(const TracingIterator& other) const { return this->Place != other.Place; }

private:
  const char* Place;
  const char** Trace;
};

//------------------------------------------------------------------------------
class LineHandler : public nlohmann::json_sax<nlohmann::json>
{
public:
  LineHandler(const std::string& text, const std::string& fileName)
    : FileName(fileName)
    , Counted(text.data())
    , Trace(text.data())
  {
  }

  const char** GetTrace() { return &this->Trace; }

  std::map<std::string, int> Lines;

  bool null() override { return this->AddValue(); }
  bool boolean(bool) override { return this->AddValue(); }
  bool number_integer(number_integer_t) override { return this->AddValue(); }
  bool number_unsigned(number_unsigned_t) override { return this->AddValue(); }
  bool number_float(number_float_t, const string_t&) override { return this->AddValue(); }
  bool string(string_t&) override { return this->AddValue(); }
  bool binary(binary_t&) override { return this->AddValue(); }
  bool start_object(std::size_t) override { return this->Open(false); }
  bool end_object() override { return this->Close(); }
  bool start_array(std::size_t) override { return this->Open(true); }
  bool end_array() override { return this->Close(); }

  bool key(string_t& key) override
  {
    Level& level = this->Levels.back();
    level.Item = level.Path / key;
    if (!this->Lines.emplace(level.Item.to_string(), this->GetLine()).second)
    {
      this->Fail("key '" + key + "' is given twice");
    }
    return true;
  }

  bool parse_error(
    std::size_t, const std::string&, const nlohmann::json::exception& exception) override
  {
    // Of "[json.exception.parse_error.101] parse error at line 3, column 5: syntax error ..." only
    // the last part is the user's.
    std::string reason = exception.what();
    reason = reason.substr(reason.find("] ") + 2);
    const std::string location = "parse error at line ";
    if (reason.compare(0, location.size(), location) == 0)
    {
      reason = reason.substr(reason.find(": ") + 2);
    }
    this->Fail("malformed JSON: " + reason);
    return false; // never reached
  }

private:
  struct Level
  {
    nlohmann::json::json_pointer Path; // of the object or array
    nlohmann::json::json_pointer Item; // of the value that is being read
    bool IsArray = false;
    std::size_t Count = 0;
  };

  // Scene files are four levels deep. The bound keeps hostile files from filling the memory.
  static constexpr std::size_t MaximumDepth = 64;

  bool AddValue()
  {
    if (this->Levels.empty())
    {
      this->Lines[""] = this->GetLine();
    }
    else if (this->Levels.back().IsArray)
    {
      Level& level = this->Levels.back();
      level.Item = level.Path / level.Count++;
      this->Lines[level.Item.to_string()] = this->GetLine();
    }
    return true;
  }

  bool Open(bool isArray)
  {
    this->AddValue();
    if (this->Levels.size() == MaximumDepth)
    {
      this->Fail("nested too deeply");
    }
    Level level;
    if (!this->Levels.empty())
    {
      level.Path = this->Levels.back().Item;
    }
    level.IsArray = isArray;
    this->Levels.push_back(level);
    return true;
  }

  bool Close()
  {
    this->Levels.pop_back();
    return true;
  }

  // The last character read may belong to what follows a number, and may be a line's end: it does
  // not count.
  int GetLine()
  {
    while (this->Counted + 1 < this->Trace)
    {
      this->Line += *this->Counted++ == '\n' ? 1 : 0;
    }
    return this->Line;
  }

  [[noreturn]] void Fail(const std::string& message)
  {
    throw UserError(this->FileName + ":" + std::to_string(this->GetLine()) + ": " + message);
  }

  std::string FileName;
  const char* Counted;
  const char* Trace;
  int Line = 1;
  std::vector<Level> Levels;
};
}

//------------------------------------------------------------------------------
std::map<std::string, int> FindJsonLines(const std::string& text, const std::string& fileName)
{
  LineHandler handler(text, fileName);
  nlohmann::json::sax_parse(TracingIterator(text.data(), handler.GetTrace()),
    TracingIterator(text.data() + text.size(), handler.GetTrace()), &handler);
  return handler.Lines;
}

}
