// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the fuzzers share: an input that is read as numbers and choices, and a check that stops the
 * program as a crash does.
 */

#ifndef AirlightFuzz_h
#define AirlightFuzz_h

#include <fuzzer/FuzzedDataProvider.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace airlight_fuzz
{
using Vector = std::array<double, 3>;

// Stops with the text unless it holds.
void Require(bool holds, const std::string& text);

// That numbers are finite, and at least 0.
void RequireFinite(const double* values, int count, const char* name);
void RequirePositive(const double* values, int count, const char* name);

// A file with these bytes, the same in each call; it is gone when the program ends.
const std::string& WriteInput(const uint8_t* data, size_t size, const char* extension);

class Input
{
public:
  Input(const uint8_t* data, size_t size)
    : Provider(data, size)
  {
  }

  bool HasMore() { return this->Provider.remaining_bytes() > 0; }
  bool Flag() { return this->Provider.ConsumeBool(); }

  // From low to high.
  int Integer(int low, int high) { return this->Provider.ConsumeIntegralInRange(low, high); }

  // One that calls take: small whole numbers, so that values coincide, any in a modest range, any
  // power of ten, infinities, and any bits at all.
  double Number();
  Vector Numbers() { return { this->Number(), this->Number(), this->Number() }; }

  // A finite one of modest size, of a few values only.
  double Modest() { return 0.5 * this->Integer(-8, 8); }
  Vector ModestVector() { return { this->Modest(), this->Modest(), this->Modest() }; }

  // All that is left, as bytes.
  std::vector<uint8_t> Rest() { return this->Provider.ConsumeRemainingBytes<uint8_t>(); }

  // Modest in most inputs, any in some: chosen once.
  Vector Point();
  bool IsModest() const { return this->Points != 1; }

private:
  FuzzedDataProvider Provider;
  int Points = -1;
};
}

#endif
