// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace hybrid::dda
{
  /**
   * How one contact carries load.
   *
   * The open-close iteration of a time step has converged when no contact
   * changes its state any more and all forces balance.
   */
  enum class ContactState
  {
    open,    ///< separated: no force
    sliding, ///< closed, shear strength exhausted: Coulomb force only
    locked   ///< closed and sticking: normal and shear spring act
  };
} // namespace hybrid::dda
