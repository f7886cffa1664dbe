// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// What mappers' shaders know of materials when they are made (AirlightSpecialization.h)
// changes no picture, whatever becomes of the materials: it is that of shaders that ask for all
// numbers, or of a fresh scene.

#include "AirlightTestScene.h"

#include "vtkAssembly.h"
#include "vtkCallbackCommand.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkShader.h"
#include "vtkShaderProgram.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
// How many of the four numbers the last shader that was drawn with knows.
class Knowledge
{
public:
  explicit Knowledge(vtkActor* actor)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback([](vtkObject*, unsigned long, void* self, void* program) {
      auto* shader = static_cast<vtkShaderProgram*>(program)->GetFragmentShader();
      static_cast<Knowledge*>(self)->Source = shader->GetSource();
    });
    actor->GetMapper()->AddObserver(vtkCommand::UpdateShaderEvent, this->Command);
  }

  int Count() const
  {
    int count = 0;
    for (const char* name :
      { "ambientIntensity", "diffuseIntensity", "specularIntensity", "opacityUniform" })
    {
      count += this->Source.find(std::string("const float ") + name) != std::string::npos ? 1 : 0;
    }
    return count;
  }

private:
  vtkNew<vtkCallbackCommand> Command;
  std::string Source;
};

class Stage : public Scene
{
public:
  Stage()
    : Scene(100, 75)
  {
    this->AddPointLight({ 2.0, 4.0, 3.0 });
    this->AddPointLight({ -3.0, 2.0, 4.0 });
  }

  vtkActor* AddBall(double x, vtkProperty* property = nullptr)
  {
    vtkActor* ball =
      this->Add(MakeSphere(1.5), [x](vtkActor* actor) { actor->SetPosition(x, 0, 0); });
    if (property)
    {
      ball->SetProperty(property);
    }
    return ball;
  }
};

// Numbers that are those in single precision, as shaders take them, and not in double.
void Disguise(vtkProperty* property)
{
  property->SetAmbient(1e-60);
  property->SetSpecular(1e-60);
  property->SetDiffuse(1.0 - 1e-12);
}

vtkSmartPointer<vtkProperty> MakeGleaming()
{
  auto property = vtkSmartPointer<vtkProperty>::New();
  property->SetAmbient(0.3);
  property->SetDiffuse(0.4);
  property->SetSpecular(0.8);
  property->SetSpecularPower(5.0);
  property->SetInterpolationToFlat();
  return property;
}

vtkSmartPointer<vtkProperty> MakeDull()
{
  auto property = vtkSmartPointer<vtkProperty>::New();
  property->SetInterpolationToFlat();
  return property;
}

//------------------------------------------------------------------------------
using Change = std::function<void(vtkActor*)>;

// `known`: how many numbers the shader is to know.
void CompareContent(const std::string& name, vtkPolyData* data, int known, const Change& change)
{
  Buffers buffers[2];
  for (const bool disguised : { false, true })
  {
    Stage stage;
    vtkActor* actor = stage.Add(data);
    actor->GetMapper()->SetScalarVisibility(true);
    change(actor);
    if (disguised)
    {
      Disguise(actor->GetProperty());
    }
    const Knowledge knowledge(actor);
    buffers[disguised] = stage.Render();
    const int expected = disguised ? std::min(known, 1) : known; // the opacity is not disguised
    Check(knowledge.Count() == expected,
      name + ": " + std::to_string(expected) + " numbers are known, not " +
        std::to_string(knowledge.Count()));
  }
  CheckSame(buffers[0], buffers[1], name);
}

void TestContent()
{
  const vtkSmartPointer<vtkPolyData> ball = MakeSphere(2.0);
  vtkSmartPointer<vtkPolyData> coloured = MakeSphere(2.0);
  vtkNew<vtkFloatArray> heights;
  for (vtkIdType i = 0; i < coloured->GetNumberOfPoints(); ++i)
  {
    heights->InsertNextValue(static_cast<float>(coloured->GetPoint(i)[1]));
  }
  coloured->GetPointData()->SetScalars(heights);
  CompareContent("a ball", ball, 4, [](vtkActor*) {});
  CompareContent("colours of points", coloured, 4, [](vtkActor*) {});
  CompareContent("unlit", ball, 3, [](vtkActor* actor) { actor->GetProperty()->LightingOff(); });
  CompareContent("smooth, by physics", ball, 4, [](vtkActor* actor) {
    actor->GetProperty()->SetInterpolationToPBR();
    actor->GetProperty()->SetRoughness(0.4);
  });
  CompareContent("another back", ball, 4, [](vtkActor* actor) {
    actor->SetBackfaceProperty(MakeGleaming());
    actor->GetProperty()->SetFrontfaceCulling(true);
  });
  CompareContent(
    "edges", ball, 0, [](vtkActor* actor) { actor->GetProperty()->SetEdgeVisibility(true); });
  CompareContent("vertices", ball, 0, [](vtkActor* actor) {
    actor->GetProperty()->SetVertexVisibility(true);
    actor->GetProperty()->SetPointSize(5.0);
  });
  CompareContent("a wireframe", ball, 0,
    [](vtkActor* actor) { actor->GetProperty()->SetRepresentationToWireframe(); });
  CompareContent("what is selected", ball, 0, [](vtkActor* actor) {
    vtkNew<vtkIdTypeArray> ids;
    ids->InsertNextValue(10);
    vtkNew<vtkSelectionNode> node;
    node->SetContentType(vtkSelectionNode::INDICES);
    node->SetFieldType(vtkSelectionNode::CELL);
    node->SetSelectionList(ids);
    vtkNew<vtkSelection> selection;
    selection->AddNode(node);
    actor->GetMapper()->SetSelection(selection);
  });
}

//------------------------------------------------------------------------------
// Draws two balls after each change, and compares the pictures with those of fresh scenes.
void TestChanges()
{
  const vtkSmartPointer<vtkProperty> dull = MakeDull();
  const vtkSmartPointer<vtkProperty> gleaming = MakeGleaming();
  const vtkSmartPointer<vtkProperty> changing = MakeDull();
  Stage stage;
  vtkActor* left = stage.AddBall(-2.0, dull);
  vtkActor* right = stage.AddBall(2.0, dull);
  const Knowledge knowledge(left);
  const auto compare = [&](const std::string& name, int known) {
    Stage fresh;
    fresh.AddBall(-2.0, left->GetProperty());
    if (right->GetVisibility())
    {
      fresh.AddBall(2.0, right->GetProperty());
    }
    CheckSame(stage.Render(), fresh.Render(), name);
    Check(knowledge.Count() == known, name + ": " + std::to_string(known) + " numbers are known");
  };
  compare("dull", 4);
  // Properties that are older than the shaders.
  left->SetProperty(gleaming);
  compare("specular", 1);
  left->SetProperty(dull);
  compare("dull again", 4);
  left->SetProperty(changing);
  compare("another dull one", 4);
  changing->SetSpecular(0.5);
  compare("the same, specular", 3);
  changing->SetSpecular(0.0);
  changing->SetAmbient(0.2);
  compare("without, and with ambient light", 3);
  // Not drawn while they change.
  left->SetProperty(dull);
  right->VisibilityOff();
  compare("one alone", 4);
  right->SetProperty(gleaming);
  left->SetProperty(gleaming);
  compare("one alone is specular", 1);
  right->VisibilityOn();
  compare("the other comes back", 1);
  left->SetProperty(dull);
  compare("the first is dull", 4);
}

//------------------------------------------------------------------------------
// A mapper's shader serves all of its actors, wherever they are.
void TestSharing()
{
  for (const bool first : { true, false })
  {
    for (const bool inside : { false, true })
    {
      Stage shared;
      Stage apart;
      const vtkSmartPointer<vtkActor> dull = shared.AddBall(-2.0, MakeDull());
      const Knowledge knowledge(dull);
      shared.Render();
      Check(knowledge.Count() == 4, "one actor of a mapper: 4 numbers are known");
      shared.Renderer->RemoveActor(dull);
      vtkNew<vtkActor> gleaming;
      gleaming->SetMapper(dull->GetMapper());
      gleaming->SetProperty(MakeGleaming());
      gleaming->SetPosition(2.0, 0.0, 0.0);
      vtkNew<vtkAssembly> assembly;
      assembly->AddPart(gleaming);
      vtkProp* other = gleaming;
      if (inside)
      {
        gleaming->GetProperty()->SetOpacity(0.5); // an opaque assembly is not known
        other = assembly;
      }
      shared.Renderer->AddViewProp(first ? dull : other);
      shared.Renderer->AddViewProp(first ? other : dull);
      const vtkSmartPointer<vtkActor> ball = apart.AddBall(-2.0, dull->GetProperty());
      apart.AddBall(2.0, gleaming->GetProperty());
      if (!first)
      {
        apart.Renderer->RemoveActor(ball);
        apart.Renderer->AddActor(ball);
      }
      CheckSame(shared.Render(), apart.Render(), "two actors of a mapper, beside and inside");
      Check(knowledge.Count() == (inside ? 0 : 1), "what is so of both is known");
    }
  }
}
}

//------------------------------------------------------------------------------
int TestMaterialSpecialization(int, char*[])
{
  TestContent();
  TestChanges();
  TestSharing();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
