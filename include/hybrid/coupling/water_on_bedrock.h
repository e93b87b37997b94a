// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/model/model.h>

#include <Eigen/Core>

#include <memory>

namespace hybrid::coupling
{
  /**
   * What a change of the water's level puts on the surface of the bedrock: the pressures of now
   * less those of the static state [N/m], on its nodes as they lay at the start. Only with
   * `pressures`.
   */
  class WaterOnBedrock
  {
  public:
    /// None where the level of @p blocks' water does not change or does not press.
    static std::unique_ptr<WaterOnBedrock> make(const dda::Model &blocks);

    explicit WaterOnBedrock(const dda::Model &blocks);

    /// A step from @p time to @p time + @p dt begins with this displacement of the surface [m].
    void begin(double time, double dt, const Eigen::VectorXd &displacement);

    /// Force at the end of the step [N/m].
    const Eigen::VectorXd &force() const
    {
      return at_end;
    }

    /// Work that it does up to this displacement at the end of the step [J/m].
    double work(const Eigen::VectorXd &displacement) const;

  private:
    dda::Water        water;
    std::vector<Vec2> nodes;
    int               degree; ///< of the elements below
    double            gamma;  ///< Newmark's [-]
    Eigen::VectorXd   at_rest, at_start, at_end, moved;
  };
} // namespace hybrid::coupling
