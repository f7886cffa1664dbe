// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The visitors of the structures that shaders and C++ share meet each member that the GLSL text
// declares, with its type, and no other. Without a window.

#include "AirlightTestCheck.h"
#include "Medium/AirlightConvert.h"
#include "OpenGL/AirlightShaderLibrary.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkParticipatingMedium.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <map>
#include <regex>
#include <set>

using namespace airlight;
using airlight_test::Check;

namespace
{
using Names = std::set<std::string>; // "vec3 region.boxMin"

// The structures in a GLSL text.
class Structures
{
public:
  explicit Structures(const std::string& source)
  {
    std::string text = std::regex_replace(source, std::regex("//[^\n]*"), "");
    for (const char* name :
      { "AIRLIGHT_GRID_MEMBER", "AIRLIGHT_LIGHT_GRID_MEMBERS", "AIRLIGHT_SKY_MEMBER" })
    {
      std::smatch members;
      const std::string word = name;
      Check(std::regex_search(
              text, members, std::regex("#define " + word + " +((?:[^\n]*\\\\\n)*[^\n]*)")),
        "the text defines " + word);
      text = std::regex_replace(text, std::regex("\\b" + word + "\\b"), members.str(1));
    }
    text = std::regex_replace(text, std::regex("\\bAIRLIGHT_DATA_MEMBER\\b"), "");
    text = std::regex_replace(text, std::regex("\\bAIRLIGHT_SAMPLES\\b"), "int");
    text = std::regex_replace(text, std::regex("\\breal3x3\\b"), "mat3");
    text = std::regex_replace(text, std::regex("\\breal4x4\\b"), "mat4");
    text = std::regex_replace(text, std::regex("\\breal(?=\\b)"), "float");
    text = std::regex_replace(text, std::regex("\\breal(?=[234]\\b)"), "vec");
    const std::regex structure("\\bstruct\\s+(\\w+)\\s*\\{([^}]*)\\}");
    for (std::sregex_iterator found(text.begin(), text.end(), structure), end; found != end;
         ++found)
    {
      this->Bodies[found->str(1)] = found->str(2);
    }
  }

  // Numbers, vectors and arrays of a structure, those of structures in it included. Of an array of
  // structures the first.
  Names List(const std::string& structure, const std::string& owner = "") const
  {
    Names names;
    const std::string& body = this->Bodies.at(structure);
    const std::regex member("(\\w+)\\s+(\\w+)\\s*(\\[[^\\]]*\\])?\\s*;");
    for (std::sregex_iterator found(body.begin(), body.end(), member), end; found != end; ++found)
    {
      const std::string type = found->str(1);
      const std::string name = owner + found->str(2);
      const bool array = found->length(3) > 0;
      if (this->Bodies.count(type) == 0)
      {
        names.insert(type + " " + name + (array ? "[]" : ""));
        continue;
      }
      const Names inner = this->List(type, name + (array ? "[0]." : "."));
      names.insert(inner.begin(), inner.end());
    }
    return names;
  }

private:
  std::map<std::string, std::string> Bodies;
};

class Collector
{
public:
  void operator()(const Member& member, int) { this->Add("int", member.Name); }
  void operator()(const Member& member, double) { this->Add("float", member.Name); }
  void operator()(const Member& member, const glm::dvec2&) { this->Add("vec2", member.Name); }
  void operator()(const Member& member, const glm::dvec3&) { this->Add("vec3", member.Name); }
  void operator()(const Member& member, const glm::dmat3&) { this->Add("mat3", member.Name); }
  template <std::size_t Count>
  void operator()(const Member& member, const int (&)[Count])
  {
    this->Add("int", member.Name + "[]");
  }
  template <std::size_t Count>
  void operator()(const Member& member, const glm::dvec3 (&)[Count])
  {
    this->Add("vec3", member.Name + "[]");
  }
  template <std::size_t Count>
  void operator()(const Member& member, const glm::dvec4 (&)[Count])
  {
    this->Add("vec4", member.Name + "[]");
  }
  template <std::size_t Count>
  void operator()(const Member& member, const glm::dmat4 (&)[Count])
  {
    this->Add("mat4", member.Name + "[]");
  }

  Names Visited;

private:
  void Add(const std::string& type, const std::string& name)
  {
    Check(this->Visited.insert(type + " " + name).second, name + " is visited once");
  }
};

void Compare(const std::string& structure, const Names& declared, const Names& visited)
{
  Check(!declared.empty(), structure + " has members");
  for (const std::string& name : declared)
  {
    Check(visited.count(name) == 1, structure + ": " + name + " is declared but not visited");
  }
  for (const std::string& name : visited)
  {
    Check(declared.count(name) == 1, structure + ": " + name + " is visited but not declared");
  }
}
}

//------------------------------------------------------------------------------
int TestAirlightShaderLibrary(int, char*[])
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 2);
  image->AllocateScalars(VTK_DOUBLE, 1);
  std::fill_n(static_cast<double*>(image->GetScalarPointer()), 8, 1.0);
  vtkNew<vtkParticipatingMedium> medium;
  medium->SetDensityToImage();
  medium->SetDensityImage(image);
  medium->SetSkyRadiance(1.0, 1.0, 1.0);
  const f64::AirlightMedia media = ConvertMedia({ medium }, glm::dvec3(0.0));
  Check(media.item[0].density == AIRLIGHT_DENSITY_GRID, "the medium has an image");

  const Structures structures(GetScatteringSource(media, -1, true));
  Collector ofMedia;
  VisitMediaUniforms(ofMedia, media);
  Compare("AirlightMedia", structures.List("AirlightMedia"), ofMedia.Visited);
  Collector ofLight;
  const f64::AirlightLight light{};
  VisitLight(ofLight, light);
  Compare("AirlightLight", structures.List("AirlightLight"), ofLight.Visited);
  Collector ofPhotometry;
  VisitPhotometry(ofPhotometry, light.photometry);
  Compare("AirlightPhotometry", structures.List("AirlightPhotometry"), ofPhotometry.Visited);
  return airlight_test::Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
