// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/output/mesh_orders.h>
#include <hybrid/output/step_record.h>
#include <hybrid/output/summary.h>

namespace hybrid::output
{
  /**
   * The error of a mesh from its difference d to one twice as coarse: d / (2^p - 1) (Richardson
   * 1911), and 1/2^p of that with half the size.
   *
   * The order p is one for all quantities, the smallest that the three meshes show of displacement,
   * velocity and acceleration: two meshes may be close by luck, which makes an order look too high,
   * never too low. It lies within @p orders: differences that fall more slowly than with the lowest
   * are those of meshes that do not resolve the waves, so they say nothing of finer ones. The
   * assumed one counts there, and without a third mesh; then error.order_is_seen is false.
   *
   * The difference D of the coarser two tells what the finer two leave at least, if they are close
   * by luck: D / (2^P (2^P - 1)), with P the highest order.
   *
   * @param coarser runs with meshes twice and four times as coarse, or the first of them alone
   */
  void measure_mesh_error(const StepRecord              &run,
                          const std::vector<StepRecord> &coarser,
                          MeshOrders                     orders,
                          Summary::MeshError            &error);
} // namespace hybrid::output
