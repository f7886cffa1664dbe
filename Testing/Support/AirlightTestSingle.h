// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Media and lights in single precision, as shaders get them; data and images are left out.
 */

#ifndef AirlightTestSingle_h
#define AirlightTestSingle_h

#include "Integration/AirlightMembers.h"

#include <algorithm>
#include <cstddef>

namespace airlight_test
{
struct SingleCopy
{
  template <typename Single, typename Double>
  void operator()(const airlight::Member&, Single& to, const Double& from) const
  {
    to = Single(from);
  }
  template <typename Single, typename Double, std::size_t Count>
  void operator()(const airlight::Member&, Single (&to)[Count], const Double (&from)[Count]) const
  {
    std::copy(from, from + Count, to);
  }
};

inline airlight::f32::AirlightMedia ToSingle(const airlight::f64::AirlightMedia& media)
{
  airlight::f32::AirlightMedia result{};
  airlight::VisitMedia(SingleCopy(), result, media);
  for (int i = 0; i < media.count; ++i)
  {
    airlight::VisitSky(SingleCopy(), result.item[i].sky, media.item[i].sky);
  }
  airlight::VisitMultiple(SingleCopy(), result.multiple, media.multiple);
  return result;
}

inline airlight::f32::AirlightLight ToSingle(const airlight::f64::AirlightLight& light)
{
  airlight::f32::AirlightLight result{};
  airlight::VisitLight(SingleCopy(), result, light);
  return result;
}
}

#endif
