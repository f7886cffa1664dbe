// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LightOptions_h
#define LightOptions_h

#include "scene/Scene.h"

#include <CLI/CLI.hpp>

#include <map>
#include <string>
#include <vector>

namespace airlight
{

/**
 * Lamps on the command line, and the options that change the lamp before them.
 */
class LightOptions
{
public:
  /**
   * Add the options to a command. Keep this object until it has run.
   */
  void AddTo(CLI::App* command);

  /**
   * The lamps in the order of the command line; empty if there are none. Throws UserError.
   */
  std::vector<LightSource> Read() const;

  /**
   * The options that mean nothing without the pass.
   */
  std::vector<CLI::Option*> GetPassOptions() const { return this->PassOptions; }

private:
  CLI::Option* Add(const char* name, const char* help);

  CLI::App* Command = nullptr;
  std::map<std::string, std::vector<std::string>> Texts; // by option
  std::vector<CLI::Option*> PassOptions;
};

}

#endif
