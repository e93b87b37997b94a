// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/contact/contact_history.h>

#include <vector>

namespace hybrid::dda
{
  /// A contact that passed the tests of its own edge.
  struct ContactTrial
  {
    /// What the past says for this edge; the order is that of preference.
    enum class History
    {
      none,
      continuing, ///< the vertex leaves another edge that this one continues
      same_edge
    };

    Contact contact;
    double  gap;       ///< [m]
    double  overhang;  ///< distance of the projection from the edge, 0 on it [m]
    bool    is_inside; ///< the vertex projects on the edge
    History history;
    int     origin;             ///< number of the old contact that it continues or repeats, or -1
    bool    by_valley  = false; ///< it is beside the end of the edge, which a valley lets go on
    bool    has_passed = false; ///< the vertex has passed the tip in which the edge ends

    /// Which of two edges at one height acts where their ends meet is decided by where they lie,
    /// not by round-off or numbers.
    double below_sole = 0.;    ///< largest cosine between an edge of the vertex and the way to the
                               ///< edge's middle; 1: it runs along the edge
    double middle_height = 0.; ///< of the edge [m]
  };


  /**
   * Chooses the contacts of one vertex; the rules are those of ContactDetection.
   *
   * Use: begin_vertex(), then for every body near it add_edge() for each edge
   * and end_body(), then end_vertex().
   */
  class ContactSelection
  {
  public:
    /// @param pairs must outlive this
    explicit ContactSelection(const PairTolerances &pairs);

    void
    begin_step(const Geometry &geometry, const OutlineFrames &frames, const BondedOutline &outline);

    /// @param old_contacts of this vertex, @p n_old of them
    void begin_vertex(int body, int vertex, const Contact *old_contacts, int n_old);

    /// Try one edge of a body.
    void add_edge(int body, int edge);

    /// Reduce the edges of the body just added to those that act. Returns how many do.
    int end_body();

    /// Reduce to one edge per seam, hand over histories, append to @p trials in order of body and
    /// edge.
    void end_vertex(std::vector<ContactTrial> &trials);

    /// Edges tried since begin_step().
    long n_edge_tests() const
    {
      return edge_tests;
    }

  private:
    bool passes_angle_test(const Vec2 &normal, double sine) const;

    bool is_held(int body, int edge, double gap) const;

    bool   is_below_valley(const Contact &contact, double along) const;
    double allowed_overhang(const ContactTrial &trial, double along) const;

    int edge_following(int body, int edge) const;

    /// Which contacts of the vertex carry it at a seam.
    enum class Support
    {
      before, ///< those of the last step
      now     ///< the trials
    };

    bool is_below_seam(const ContactTrial &trial, Support support) const;

    bool is_level_with_sole(int body, int corner, int other) const;
    bool is_level_with_trial(int body, int edge, double gap) const;
    bool is_tip_of_row(int body, int corner, Support support) const;

    bool is_undecided(const ContactTrial &trial) const;

    bool is_in_body(const ContactTrial &trial) const;

    bool has_passed_tip(const ContactTrial &trial) const;

    void set_place(ContactTrial &trial) const;

    bool may_act_together(const ContactTrial &a, const ContactTrial &b) const;

    bool is_same_seam(const ContactTrial &a, const ContactTrial &b) const;

    /// Of the vertex and a body.
    const ContactTolerances &with(const int body) const
    {
      return pairs.of(vertex_body, body);
    }

    const ContactTolerances &of(const ContactTrial &trial) const
    {
      return with(trial.contact.edge_body);
    }

    const PairTolerances &pairs;
    const Geometry       *geometry = nullptr;
    const OutlineFrames  *frames   = nullptr;
    const BondedOutline  *outline  = nullptr;

    int                       vertex_body = 0, vertex = 0;
    Vec2                      point, to_next, to_previous; ///< of the vertex
    ContactHistory            old;
    std::vector<ContactTrial> trials;         ///< of this vertex
    std::vector<char>         below_seam;     ///< per trial, work of end_vertex()
    std::size_t               body_begin = 0; ///< first trial of the present body
    long                      edge_tests = 0;
  };
} // namespace hybrid::dda
