// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/output/step_record.h>
#include <hybrid/output/summary.h>

namespace hybrid::output
{
  /**
   * The error of a mesh from its difference d to one twice as coarse: d / (2^p - 1) (Richardson
   * 1911).
   *
   * The order p is that of the three meshes, at most @p highest_order: beyond, the difference of
   * the coarser two counts, as the finer two may be close by luck. Below 1/2 no order
   * is seen: the coarsest mesh resolves nothing, or the meshes do not converge. Then, and without a
   * third mesh, 2^p - 1 is sqrt(3), in the middle between first and second order. What half the
   * size leaves is not known where no order is seen: as much.
   *
   * @param coarser runs with meshes twice and four times as coarse, or the first of them alone
   */
  void measure_mesh_error(const StepRecord              &run,
                          const std::vector<StepRecord> &coarser,
                          double                         highest_order,
                          Summary::MeshError            &error);
} // namespace hybrid::output
