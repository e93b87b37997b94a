// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/rest_watch.h>
#include <hybrid/restart/archive.h>

#include <algorithm>

namespace hybrid
{
  RestWatch::RestWatch(const double given_speed, const double earliest_time)
    : speed(given_speed)
    , earliest(earliest_time)
    , still_since(earliest_time)
  {}



  void RestWatch::look(const double time, const double fastest)
  {
    if (fastest > speed)
      still_since = std::max(time, earliest);
    resting = is_on() && time - still_since >= waiting_time;
  }



  void RestWatch::serialize(restart::Archive &archive)
  {
    archive(still_since);
  }
} // namespace hybrid
