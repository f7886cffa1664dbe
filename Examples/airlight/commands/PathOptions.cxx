// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "commands/PathOptions.h"

#include "commands/OptionNumbers.h"
#include "formats/UserError.h"

#include <limits>

namespace airlight
{

namespace
{
constexpr int ManyPaths = 1 << 24; // an error or a time ends them
constexpr double LeastError = 1e-6;
constexpr double LongestTime = 1e6;
}

//------------------------------------------------------------------------------
void PathOptions::AddTo(CLI::App* command, CLI::Option* reference)
{
  const int most = std::numeric_limits<int>::max();
  CLI::Option* orders =
    command
      ->add_option("--orders", this->Settings.Orders,
        "How many times light may be scattered by the medium or reflected by surfaces, with "
        "--reference; 0: any number of times. From 2 on paths of light are drawn at random, and "
        "the picture has noise (default 1)")
      ->check(CLI::Range(0, most))
      ->needs(reference);
  command
    ->add_option("--error", this->Error,
      "Draw paths until the noise is this share of the mean radiance, such as 1e-2, with --orders")
    ->needs(orders);
  command
    ->add_option("--time-limit", this->TimeLimit,
      "Draw paths for so many seconds, with --orders; the picture then depends on the machine")
    ->needs(orders);
  command
    ->add_option("--samples", this->Settings.Samples,
      "Draw so many paths of each pixel at most, with --orders (default 64; with --error or "
      "--time-limit as many as it takes)")
    ->check(CLI::Range(2, most))
    ->needs(orders);
  command
    ->add_option("--seed", this->Settings.Seed,
      "Draw other paths, with --orders; the same seed gives the same picture (default 0)")
    ->check(CLI::Range(0, most))
    ->needs(orders);
}

//------------------------------------------------------------------------------
PathChoices PathOptions::GetSettings() const
{
  PathChoices settings = this->Settings;
  const auto read = [](const char* option, const std::string& text, double low, double high,
                      const char* expected, double& number) {
    if (!text.empty() && (!GetNumber(text, number) || !IsInRange({ number }, low, high)))
    {
      FailOption(option, text, expected);
    }
  };
  read("--error", this->Error, LeastError, 1.0, "a number from 1e-6 to 1, such as 0.01",
    settings.Error);
  read("--time-limit", this->TimeLimit, 1e-3, LongestTime, "seconds from 0.001 to 1e6",
    settings.TimeLimit);
  const bool noisy =
    !this->Error.empty() || !this->TimeLimit.empty() || settings.Samples > 0 || settings.Seed != 0;
  if (settings.Orders == 1 && noisy)
  {
    throw UserError("--error, --time-limit, --samples and --seed are of random paths, which "
                    "--orders 1 has none of: leave them out, or give other orders");
  }
  if (settings.Samples == 0)
  {
    settings.Samples = settings.Error > 0.0 || settings.TimeLimit > 0.0 ? ManyPaths : 64;
  }
  return settings;
}

}
