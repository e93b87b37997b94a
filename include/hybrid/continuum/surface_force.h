// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace hybrid::continuum
{
  /**
   * Forces lambda of the blocks on the surface at the end of a step, less those at rest [N/m].
   *
   * Contacts act fully implicitly, on the rock as on the blocks (dda::Springs): with the force C =
   * M c at the end of the step, u1 = ... + dt^2/2 c, v1 = ... + dt c, and the next step finds
   * nothing of it.
   */
  struct SurfaceForce
  {
    SurfaceForce() = default;

    /// Forces that act with Newmark's weights.
    template <typename Derived>
    SurfaceForce(const Eigen::MatrixBase<Derived> &newmark)
      : all(newmark)
    {}

    SurfaceForce(const Eigen::VectorXd &at_end,
                 const Eigen::VectorXd &of_contacts,
                 const Eigen::VectorXd &not_handed_on)
      : all(at_end)
      , contacts(of_contacts)
      , ended(not_handed_on)
    {}

    Eigen::VectorXd all;
    Eigen::VectorXd contacts; ///< part of it that acted fully implicitly; empty: none
    Eigen::VectorXd ended;    ///< part of it that the next step must not find: contacts, and joints
                              ///< that tore in this step; empty: none

    /// Unknown @p k of a part. @return 0 where the part is empty
    static double at(const Eigen::VectorXd &part, const std::size_t k)
    {
      return part.size() == 0 ? 0. : part[static_cast<Eigen::Index>(k)];
    }

    /// Whether joints tore, too.
    bool has_torn() const
    {
      return ended.size() > 0 && ended != contacts;
    }
  };
} // namespace hybrid::continuum
