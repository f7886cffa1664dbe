// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef PathOptions_h
#define PathOptions_h

#include "scene/ReferencePicture.h"

#include <CLI/CLI.hpp>

#include <string>

namespace airlight
{

/**
 * How far `airlight render --reference` follows light that is scattered several times.
 */
class PathOptions
{
public:
  /**
   * Add the options to a command; each needs `reference`. Keep this object until it has run.
   */
  void AddTo(CLI::App* command, CLI::Option* reference);

  /**
   * Throws UserError.
   */
  PathChoices GetSettings() const;

private:
  PathChoices Settings;
  std::string Error;
  std::string TimeLimit;
};

}

#endif
