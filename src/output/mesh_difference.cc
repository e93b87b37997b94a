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



    /// The smallest of displacement, velocity and acceleration; NaN: there is none.
    double seen_order(const Summary::ErrorPart &near, const Summary::ErrorPart &far)
    {
      double result = MonitorSummary::unknown;
      for (std::size_t q = 0; q < near.part.size(); ++q)
        result = std::fmin(result, std::log2(far.part[q] / near.part[q]));
      return result;
    }
  } // namespace



  void measure_mesh_error(const StepRecord              &run,
                          const std::vector<StepRecord> &coarser,
                          const MeshOrders               orders,
                          Summary::MeshError            &error)
  {
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
    const double found  = seen_order(near, far);
    error.order_is_seen = found >= orders.lowest; // NaN: there is no third mesh
    const double p      = error.order_is_seen ? std::min(found, orders.highest) : orders.assumed;
    const double gain = std::exp2(p), fastest = std::exp2(orders.highest);
    const auto   size = numbers(error.size), half = numbers(error.half_size), other = numbers(far);
    for (std::size_t q = 0; q < size.size(); ++q)
      if (!std::isnan(*size[q])) // slip is left, and no joint failed
        {
          *size[q] = std::fmax(*size[q] / (error.coarsened * (gain - 1.)),
                               *other[q] / (fastest * (fastest - 1.)));
          *half[q] = *size[q] / gain;
        }
  }



  double coarsened_part(const double left, const MeshOrders orders)
  {
    return std::min((1. - left) / (1. - orders.left), 1.);
  }



  void add_corner_error(const StepRecord &run, const StepRecord &halved, Summary::MeshError &error)
  {
    const double       least_order = 0.5;
    Summary::ErrorPart difference  = step_difference(run, halved);
    const auto         corner = numbers(difference), size = numbers(error.size),
               half  = numbers(error.half_size);
    error.of_corners = true;
    for (std::size_t q = 0; q < size.size(); ++q)
      {
        const double left = *corner[q] / (1. - std::exp2(-least_order * corner_halvings));
        if (left > *size[q] && q < difference.where.size())
          error.size.where[q] = difference.where[q];
        *size[q] = std::fmax(*size[q], left);
        *half[q] = std::fmax(*half[q], left * std::exp2(-least_order));
      }
  }
} // namespace hybrid::output
