// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace hybrid::restart
{
  class Archive; ///< see archive.h
}
