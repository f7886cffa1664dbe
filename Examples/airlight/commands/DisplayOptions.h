// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef DisplayOptions_h
#define DisplayOptions_h

#include "scene/SceneBuilder.h"

#include <CLI/CLI.hpp>

#include <string>

namespace airlight
{

/**
 * How `airlight render` and `airlight view` show radiance on the screen: exposure, tone mapping,
 * colour space and dithering.
 */
class DisplayOptions
{
public:
  /**
   * Add the options to a command. Keep this object until it has run.
   */
  void AddTo(CLI::App* command);

  /**
   * For pictures. Throws UserError.
   */
  DisplaySettings GetSettings() const;

  /**
   * The factor of linear values that are written as they are: 1 unless it was given. Throws
   * UserError.
   */
  double GetFactor() const;

private:
  std::string Exposure;
  std::string ToneMapping;
  std::string ColorSpace;
  bool NoDithering = false;
};

}

#endif
