// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/formatted.h>
#include <hybrid/output/overlap_watch.h>

namespace hybrid::output
{
  void OverlapWatch::look(const dda::Geometry &geometry, const double time)
  {
    const dda::Overlap now = dda::deepest_overlap(geometry);
    if (now.part <= overlap.part)
      return;
    overlap = now;
    seen    = time;
  }



  std::string OverlapWatch::warning()
  {
    if (has_warned || overlap.part <= warned)
      return "";
    has_warned = true;
    return formatted("at t = %.4g s ", seen) + overlap_text(overlap) +
           ": it is too soft for what presses on it (Young modulus, Blocks/Penalty ratio), or a contact "
           "was missed; the largest overlap of the run is told at its end";
  }



  void OverlapWatch::serialize(restart::Archive &archive)
  {
    double x = overlap.place.x(), y = overlap.place.y();
    archive(overlap.part, overlap.depth, overlap.size, overlap.block, overlap.other, x, y);
    archive(seen, has_warned);
    overlap.place = {x, y};
  }



  std::string overlap_text(const dda::Overlap &overlap)
  {
    return formatted("a block of %.3g m at (%.2f, %.2f) is in %s by %.3g m, %.2g %% of its size",
                     overlap.size,
                     overlap.place.x(),
                     overlap.place.y(),
                     overlap.other == dda::foundation_body ? "the ground" : "another one",
                     overlap.depth,
                     100. * overlap.part);
  }
} // namespace hybrid::output
