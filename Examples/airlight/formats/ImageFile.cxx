// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "formats/ImageFile.h"

#include "formats/ChildProcess.h"
#include "formats/Exr.h"
#include "formats/Files.h"
#include "formats/Pfm.h"
#include "formats/UserError.h"
#include "formats/VTKMessages.h"

#include <vtkImageExtractComponents.h>
#include <vtkImageWriter.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPNGWriter.h>
#include <vtkTIFFWriter.h>

#include <algorithm>

namespace airlight
{

namespace
{
void Write(vtkImageWriter* writer, vtkImageData* image, const std::string& fileName)
{
  CheckOutputFile(fileName);
  const VTKMessages messages;
  writer->SetInputData(image);
  writer->SetFileName(fileName.c_str());
  writer->Write();
  if (writer->GetErrorCode() != 0 || !messages.GetFirstError().empty())
  {
    throw UserError(fileName + ": cannot be written " + messages.GetFirstError());
  }
}

// Not a number becomes black, as on the screen.
unsigned char Quantize(float value)
{
  return static_cast<unsigned char>(value > 0.0f ? std::min(value, 1.0f) * 255.0f + 0.5f : 0.0f);
}
}

//------------------------------------------------------------------------------
ImageFormat CheckImageFile(const std::string& fileName)
{
  CheckOutputFile(fileName);
  const std::string extension = GetExtension(fileName);
  if (extension == "png")
  {
    return ImageFormat::Png;
  }
  if (extension == "pfm")
  {
    return ImageFormat::Pfm;
  }
  if (extension == "tif" || extension == "tiff")
  {
    return ImageFormat::Tiff;
  }
  if (extension == "exr")
  {
    return ImageFormat::Exr;
  }
  throw UserError(fileName + ": unknown kind of image; known: png, pfm, tiff, exr");
}

//------------------------------------------------------------------------------
void WriteFloatImage(vtkImageData* image, const std::string& fileName)
{
  switch (CheckImageFile(fileName))
  {
    case ImageFormat::Pfm:
      WritePfm(image, fileName);
      break;
    case ImageFormat::Exr:
      WriteExr(image, fileName);
      break;
    case ImageFormat::Tiff:
    {
      vtkNew<vtkTIFFWriter> writer;
      writer->SetCompressionToNoCompression();
      Write(writer, image, fileName);
      break;
    }
    case ImageFormat::Png:
    {
      vtkNew<vtkImageData> bytes;
      bytes->SetDimensions(image->GetDimensions());
      bytes->AllocateScalars(VTK_UNSIGNED_CHAR, image->GetNumberOfScalarComponents());
      const auto* values = static_cast<const float*>(image->GetScalarPointer());
      const vtkIdType count = image->GetNumberOfPoints() * image->GetNumberOfScalarComponents();
      std::transform(
        values, values + count, static_cast<unsigned char*>(bytes->GetScalarPointer()), Quantize);
      WritePng(bytes, fileName);
      break;
    }
  }
}

//------------------------------------------------------------------------------
void WritePng(vtkImageData* image, const std::string& fileName)
{
  vtkNew<vtkPNGWriter> writer;
  Write(writer, image, fileName);
}

//------------------------------------------------------------------------------
void CheckPngFile(const std::string& fileName)
{
  CheckInputFile(fileName);
  TryInChildProcess(fileName, [&fileName] { ReadPng(fileName); });
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> ReadPng(const std::string& fileName)
{
  CheckInputFile(fileName);
  const VTKMessages messages;
  vtkNew<vtkPNGReader> reader;
  if (!reader->CanReadFile(fileName.c_str()))
  {
    throw UserError(fileName + ": is not a PNG file");
  }
  reader->SetFileName(fileName.c_str());
  reader->Update();
  const std::string complaint =
    messages.GetFirstError().empty() ? messages.GetFirstWarning() : messages.GetFirstError();
  if (!complaint.empty() || reader->GetErrorCode() != 0)
  {
    throw UserError(fileName + ": damaged PNG file: " + complaint);
  }
  if (reader->GetOutput()->GetScalarType() != VTK_UNSIGNED_CHAR)
  {
    throw UserError(fileName + ": has more than 8 bits per channel");
  }
  vtkNew<vtkImageExtractComponents> rgb;
  rgb->SetInputConnection(reader->GetOutputPort());
  const bool colored = reader->GetOutput()->GetNumberOfScalarComponents() >= 3;
  rgb->SetComponents(0, colored ? 1 : 0, colored ? 2 : 0);
  rgb->Update();
  return rgb->GetOutput();
}

}
