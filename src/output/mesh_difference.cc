// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/mesh_difference.h>
#include <hybrid/output/step_difference.h>

#include <algorithm>
#include <cmath>

namespace hybrid::output
{
  namespace
  {
    /// All numbers of an error.
    std::array<double *, 4> numbers(Summary::ErrorPart &error)
    {
      return {{&error.part[0], &error.part[1], &error.part[2], &error.slip_left}};
    }
  } // namespace



  void measure_mesh_error(const StepRecord              &run,
                          const std::vector<StepRecord> &coarser,
                          const double                   highest_order,
                          Summary::MeshError            &error)
  {
    constexpr double         unknown_order = 1.45, lowest_order = 0.5;
    const Summary::ErrorPart near = step_difference(coarser.front(), run);
    Summary::ErrorPart       far =
      coarser.size() > 1 ? step_difference(coarser[1], coarser[0]) : Summary::ErrorPart();
    error.size = error.half_size = near;
    error.meshes                 = static_cast<int>(coarser.size());
    error.until                  = run.until;
    for (const StepRecord &record : coarser)
      error.until = std::fmin(error.until, record.until);
    error.failed_in_other = !std::isnan(error.until) && error.until != run.until;
    error.reason =
      std::isnan(std::fmax(near.part[0], near.part[1])) ? "nothing moves until a joint fails" : "";
    const auto size = numbers(error.size), half = numbers(error.half_size), other = numbers(far);
    for (std::size_t q = 0; q < size.size(); ++q)
      {
        const double near_by = *size[q], found = std::log2(*other[q] / near_by);
        if (std::isnan(near_by))
          continue;                                   // no slip is left, or a joint failed
        const bool   is_seen = found >= lowest_order; // NaN: there is no third mesh
        const double p       = is_seen ? std::min(found, highest_order) : unknown_order;
        const double gain    = std::exp2(p);
        *size[q] = (is_seen ? std::fmax(near_by, *other[q] / gain) : near_by) / (gain - 1.);
        *half[q] = is_seen || std::isnan(found) ? *size[q] / gain : *size[q];
      }
  }
} // namespace hybrid::output
