// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/input_error.h>
#include <hybrid/scene/newmark.h>

namespace hybrid
{
  Newmark Newmark::preset(const std::string &name)
  {
    if (name == "dissipative")
      return {0.3, 0.6};
    if (name == "trapezoidal" || name == "fourth order")
      return {0.25, 0.5};
    if (name == "shi")
      return {0.5, 1.};
    throw InputError("Newmark preset '" + name +
                     "' is unknown: must be one of dissipative | trapezoidal | fourth order | shi");
  }
} // namespace hybrid
