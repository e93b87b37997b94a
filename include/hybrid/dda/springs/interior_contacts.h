// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/springs/spring_stiffness.h>
#include <hybrid/dda/springs/springs.h>

#include <Eigen/Core>

#include <vector>

namespace hybrid::dda
{
  /**
   * Contacts on the central path of a primal-dual interior point method, for steps in which many
   * contacts change together.
   *
   * The conditions of Coulomb friction on the forces N (normal, compression positive) and T
   * (shear), the parting W = g + N/k_n and the slip rates p, q of the step along +T and -T,
   *
   *     N W = 0,     p (mu N - T) = 0,     q (mu N + T) = 0,     all factors >= 0,
   *     s - s_p + T/k_s + p - q = 0,
   *
   * are those of the penalty springs: where N W = 0, N is k_n <-g>. Here the three products are
   * t > 0, which falls to nothing while iterations go on. So each contact is open, sliding and
   * sticking in part, and all change together instead of one after the other (Mehrotra 1992; for
   * friction in this form Kanno, Martins and Pinto da Costa 2006). N, W, T, p and q are eliminated
   * from Newton's equations spring by spring: what is left is a force and a stiffness like that of
   * any spring, in the same places of the matrix. Friction is that of the full law, which makes the
   * stiffness unsymmetric.
   *
   * A joint that holds still slides at c + N tan(phi). That is the friction of a contact which is
   * pressed by N + c / tan(phi), with the gap -(N + c / tan(phi)) / k_n beyond the apex of the
   * Mohr-Coulomb cone. So it is on the path with this contact in place of its normal force, which
   * stays that of its law. What slip and damage take from c is what its law says in the trial.
   * Contacts with cohesion, and bonds without friction, follow their laws.
   */
  class InteriorContacts
  {
  public:
    /// Begin with the forces at the start of the step and the gaps of the trial that @p springs
    /// have evaluated last. @param energy that each of the products shall have at least [J/m]
    /// @param force to move a product by as much force as parting [N/m]
    void begin(const Model &model, const Springs &springs, double dt, double energy, double force);

    /// No contact is on the path.
    void clear()
    {
      points.clear();
    }

    /// Number of contacts on the path.
    std::size_t size() const
    {
      return points.size();
    }

    /// Mean product of all [J/m].
    double mean_product() const
    {
      return mean_product_after(0.);
    }

    /// The same after this part of the direction.
    double mean_product_after(double fraction) const;

    /// Aim at these products: @p target [J/m], less what the direction there is would add by its
    /// second order where @p corrects (Mehrotra 1992).
    void aim(double target, bool corrects);

    /// Forces and stiffness in the trial that @p springs have evaluated last.
    void set_responses(const Trial &trial, Springs &springs);

    /// Direction in all variables from the update of the unknowns.
    /// @return part of it up to which all factors stay positive, at most 1
    double
    follow(const Springs &springs, const SpringStiffness &stiffness, const Eigen::VectorXd &update);

    /// All go this part of the direction.
    void move(double fraction);

    /// Each goes this part of the way that it can, at most the whole direction. What it does not go
    /// is in the next direction.
    void move_each(double fraction);

    /// What each contact does most; others are left. @return number of them that changed
    int conditions(std::vector<Condition> &now) const;

  private:
    /// Variables of one contact, forces as tractions [Pa].
    struct Variables
    {
      double normal = 0., parting = 0., shear = 0., forward = 0., backward = 0.;
    };

    /// The three products, each a traction times a length [J/m2].
    struct Products
    {
      double parting = 0., forward = 0., backward = 0.;
    };

    struct Point
    {
      int       spring;
      bool      slides;              ///< its friction is limited
      bool      is_bond;             ///< the normal force is that of its law
      bool      acts = true;         ///< a bond that is torn and open in the trial does not
      double    length;              ///< [m]
      double    mu, k_n, k_s;        ///< friction [-], stiffness [Pa/m]
      double    gap_by_opening = 1.; ///< derivative of gap(), see there [-]
      double    origin;              ///< slip at which the shear spring bears nothing [m]
      Variables at, direction;
      double    longest = 1.; ///< part of the direction that it can go
      Products  target;
      double    parting_left, slip_left;             ///< of both compatibility conditions [m]
      double    k_nn, k_tt, k_tn;                    ///< as eliminated [Pa/m]
      double    normal_part, shear_part;             ///< of the direction without motion [Pa]
      double    strength_forward, strength_backward; ///< mu N - T, mu N + T [Pa]

      /// Its gap in a trial [m]; of a bond that of the contact which has its friction.
      double    gap(const Springs::Response &response) const;
      void      eliminate();
      void      follow(double gap, double slip);
      void      set_longest();
      void      move(double fraction);
      Products  products_after(double fraction) const;
      Condition condition() const;

      /// What the direction adds to mu N - T and to mu N + T [Pa].
      double forward_change() const
      {
        return mu * direction.normal - direction.shear;
      }
      double backward_change() const
      {
        return mu * direction.normal + direction.shear;
      }
    };

    std::vector<Point> points;

    /// Whether a spring can be on the path.
    static bool may_begin(const Springs::Spring &spring, const Springs::Response &response);

    /// A spring's fixed data.
    static Point point(const Model &model, const Springs &springs, double dt, int number);
  };
} // namespace hybrid::dda
