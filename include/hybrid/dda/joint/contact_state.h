// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace hybrid::dda
{
  /**
   * How one contact carries load.
   *
   * The open-close iteration of a time step has converged when, after at least
   * one update, the residual of the laws is within the tolerance. It asks for no test of the
   * states: the forces are those of the states, so that balance says that both agree.
   */
  enum class ContactState
  {
    open,    ///< separated: no force
    sliding, ///< closed, shear strength exhausted: Coulomb force only
    locked   ///< closed and sticking: normal and shear spring act
  };


  /// What a joint or contact is taken to do, whatever its gap and its strength say.
  enum class Condition : char
  {
    law,             ///< what its law says
    open,            ///< it bears nothing
    sticks,          ///< closed; a joint only does not slide
    holds,           ///< a joint neither slides nor cracks; never told of a trial
    slides_forward,  ///< closed and at its strength, with positive shear traction
    slides_backward, ///< likewise, negative
  };
} // namespace hybrid::dda
