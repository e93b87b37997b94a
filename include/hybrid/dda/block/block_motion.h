// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/block/block.h>

#include <cmath>

namespace hybrid::dda
{
  /**
   * The finite motion of one block over a step,
   *   x' = c + u + R(r) (I + e) (x - c),
   * with the exact rotation R (the first-order update would make a spinning
   * block grow), and its derivative with respect to the six unknowns.
   */
  struct BlockMotion
  {
    Vec2   old_centroid = Vec2::Zero();            ///< c [m]
    Vec2   centroid     = Vec2::Zero();            ///< c + u [m]
    double u = 0., v = 0.;                         ///< displacement of the centroid [m]
    double cosine = 1., sine = 0.;                 ///< of r
    double gxx = 0., gxy = 0., gyx = 0., gyy = 0.; ///< R (I + e) - I, without cancellation
    double ixx = 1., ixy = 0., iyy = 1.;           ///< (I + e)^-1

    BlockMotion() = default;

    BlockMotion(const Vec2 &c, const Vec6 &d)
      : old_centroid(c)
      , centroid(c + Vec2(d[0], d[1]))
      , u(d[0])
      , v(d[1])
      , cosine(std::cos(d[2]))
      , sine(std::sin(d[2]))
    {
      const double half = std::sin(0.5 * d[2]), cosine_less_one = -2. * half * half;
      const double axx = 1. + d[3], ayy = 1. + d[4], axy = 0.5 * d[5];
      const double determinant = axx * ayy - axy * axy;
      ixx                      = ayy / determinant;
      ixy                      = -axy / determinant;
      iyy                      = axx / determinant;
      gxx                      = cosine_less_one * axx + d[3] - sine * axy;
      gxy                      = cosine * axy - sine * ayy;
      gyx                      = sine * axx + cosine * axy;
      gyy                      = sine * axy + cosine_less_one * ayy + d[4];
    }

    /// Displacement over the step of the material point that was at @p x [m].
    Vec2 displacement(const Vec2 &x) const
    {
      const Vec2 r = x - old_centroid;
      return {u + gxx * r.x() + gxy * r.y(), v + gyx * r.x() + gyy * r.y()};
    }

    /// Displacement over the step of the material point that is now at @p x [m].
    Vec2 displacement_to(const Vec2 &x) const
    {
      const Vec2   r  = x - centroid;
      const double tx = cosine * r.x() + sine * r.y(), ty = cosine * r.y() - sine * r.x();
      return displacement(old_centroid + Vec2(ixx * tx + ixy * ty, ixy * tx + iyy * ty));
    }

    /// a . (dx'/dd) for a point now at @p x: the generalised gradient along the direction @p a.
    Vec6 gradient(const Vec2 &x, const Vec2 &a) const
    {
      const Vec2   r  = x - centroid;
      const double tx = cosine * r.x() + sine * r.y(), ty = cosine * r.y() - sine * r.x();
      const double lx = ixx * tx + ixy * ty, ly = ixy * tx + iyy * ty; // before the step
      const double bx = cosine * a.x() + sine * a.y(), by = cosine * a.y() - sine * a.x();
      Vec6         g;
      g << a.x(), a.y(), r.x() * a.y() - r.y() * a.x(), bx * lx, by * ly, 0.5 * (bx * ly + by * lx);
      return g;
    }
  };
} // namespace hybrid::dda
