// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace hybrid::dda
{
  /**
   * What sliding contacts keep of their shear stiffness in the tangent, as a part of it [-].
   *
   * A contact at its friction limit has none, and where hundreds of contacts may slide or stick the
   * updates become long and end at the first few contacts that stick again: the line search takes
   * small parts, for hundreds of iterations. A share that grows while it does and falls while whole
   * updates are taken (Levenberg 1944, Marquardt 1963) shortens the updates; the residual, and with
   * it the solution, knows nothing of it.
   */
  class SlidingRegularisation
  {
  public:
    double value() const
    {
      return share;
    }

    /// After an update of which the line search took @p part. @return true if the share changes.
    bool adapt(double fraction);

  private:
    double share = 0.;
  };
} // namespace hybrid::dda
