// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/step/secant_correction.h>
#include <hybrid/restart/archive.h>

#include <cmath>

namespace hybrid::dda
{
  namespace
  {
    /// A tangent that is wrong by more is none that a secant mends.
    constexpr double largest_part = 0.1;
  } // namespace



  void SecantCorrection::correct(const Eigen::VectorXd &scale, Eigen::VectorXd &update)
  {
    applied = 0.;
    if (!is_known || update.size() != direction.size())
      return;
    double s_s = 0., s_w = 0., s_u = 0., w_w = 0., u_u = 0.;
    for (Eigen::Index k = 0; k < update.size(); ++k)
      {
        const double weight = scale[k] * scale[k], s = weight * direction[k];
        s_s += s * direction[k];
        s_w += s * remedy[k];
        s_u += s * update[k];
        w_w += weight * remedy[k] * remedy[k];
        u_u += weight * update[k] * update[k];
      }
    const double part = s_u / (s_s - s_w);
    if (!(std::abs(s_w) <= largest_part * s_s) ||
        !(part * part * w_w <= largest_part * largest_part * u_u))
      return;
    applied = part;
    update += part * remedy;
  }



  void SecantCorrection::first(const Eigen::VectorXd &update)
  {
    direction = update;
    is_known  = false;
  }



  void SecantCorrection::second(const Eigen::VectorXd &update)
  {
    if (applied != 0.) // the first update had this much of the old one
      remedy = update + applied * remedy;
    else
      remedy = update;
    is_known = true;
  }



  void SecantCorrection::serialize(restart::Archive &archive)
  {
    archive(is_known, direction, remedy);
  }
} // namespace hybrid::dda
