// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "commands/Commands.h"

#include "formats/ImageFile.h"
#include "formats/UserError.h"

#include <vtkImageAppend.h>
#include <vtkNew.h>

#include <memory>
#include <string>
#include <vector>

namespace airlight
{

namespace
{
struct MontageOptions
{
  std::vector<std::string> Inputs;
  std::string Output;
};

void Montage(const MontageOptions& options)
{
  if (CheckImageFile(options.Output) != ImageFormat::Png)
  {
    throw UserError(options.Output + ": a montage is a .png");
  }
  for (const std::string& input : options.Inputs)
  {
    CheckPngFile(input);
  }
  vtkNew<vtkImageAppend> append;
  append->SetAppendAxis(0);
  int height = 0;
  for (const std::string& input : options.Inputs)
  {
    const auto image = ReadPng(input);
    const int inputHeight = image->GetDimensions()[1];
    height = height == 0 ? inputHeight : height;
    if (inputHeight != height)
    {
      throw UserError(input + ": is " + std::to_string(inputHeight) + " pixels high, and " +
        options.Inputs[0] + " " + std::to_string(height));
    }
    append->AddInputData(image);
  }
  append->Update();
  WritePng(append->GetOutput(), options.Output);
}
}

//------------------------------------------------------------------------------
void AddMontageCommand(CLI::App& program)
{
  auto options = std::make_shared<MontageOptions>();
  CLI::App* command =
    program.add_subcommand("montage", "Put pictures (.png) of the same height side by side");
  command->add_option("PICTURE", options->Inputs, "Pictures from left to right")->required();
  command->add_option("-o,--output", options->Output, "Picture to write, .png")->required();
  command->callback([options] { Montage(*options); });
}

}
