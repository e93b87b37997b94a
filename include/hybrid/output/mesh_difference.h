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
   * Lines that are close to each other (bedding planes, thin layers) keep cells small in all
   * meshes, and a difference tells nothing of what these leave. Where sizes are chosen by need all
   * cells leave about as much (Babuska & Rheinboldt 1978), so of the error E the part 1 - f of
   * larger cells makes d = (1 - f) (2^p - 1) E, and E = d / ((1 - f) (2^p - 1)), with 1 - f in
   * error.coarsened: coarsened_part().
   *
   * @param coarser runs with meshes twice and four times as coarse, or the first of them alone
   */
  void measure_mesh_error(const StepRecord              &run,
                          const std::vector<StepRecord> &coarser,
                          MeshOrders                     orders,
                          Summary::MeshError            &error);

  /// Part of the cells that are larger in a mesh that has @p left of the unknowns or blocks [-]:
  /// f + (1 - f) orders.left are left if the part f stays. At most 1.
  double coarsened_part(double left, MeshOrders orders);

  /// How often cells at corners are halved in the run that tells what these leave.
  constexpr int corner_halvings = 3;

  /**
   * What inward corners leave at least, from the difference d to a run whose cells there are
   * @p halved so many times: d / (1 - 2^(-n/2)). Displacements beside a corner go with r^lambda,
   * lambda from 1/2 up (Williams 1952; see scene::corners_of_bedrock()), and cells of the size h
   * err by h^lambda there, by h^(2 lambda) elsewhere: with n = 3 d is 0.65 of the error or more,
   * and less than all of it. Half the size leaves at most 1/sqrt(2).
   */
  void add_corner_error(const StepRecord &run, const StepRecord &halved, Summary::MeshError &error);
} // namespace hybrid::output
