// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/contact/contact_candidates.h>
#include <hybrid/dda/contact/contact_passage.h>
#include <hybrid/dda/contact/contact_selection.h>
#include <hybrid/dda/contact/stillness_cache.h>

#include <utility>
#include <vector>

namespace hybrid::dda
{
  /**
   * Finds the vertex-edge contacts that can be closed in the coming step.
   *
   * Called at the start of every step and again in each round of slip of the
   * bedding planes, always with the geometry of the last accepted step. A
   * Verlet list over a cell grid makes it O(N); the contacts depend on geometry
   * and old contacts only, never on when the list was built. Pairs of the list
   * sleep until they can have come near enough (ContactCandidates); while all
   * sleep, so does the search, and blocks without an awake pair cost nothing
   * but the look at how far they have moved. The same holds for what lies
   * still (StillnessCache): it keeps the contacts that it has.
   *
   * Rules, in the order in which they are applied:
   *
   * 1. *Vertices* are the convex corners of blocks, by any angle above
   *    smooth_angle, and every place of a surface (foundation, or outline of bedrock made of
   * blocks): a surface that bends touches a sole between the block's corners. By rule 2 a place
   *    where the surface is straight touches edges that lie along it only.
   *    Reflex corners of blocks cannot touch first, nor corners between two bonds (BondedOutline).
   * 2. *An edge is a partner* if no bond lies along it (two blocks that are bonded are one body:
   * what slides over both must not see the step that the joint's springs leave), if the vertex is
   * at most reach in front of it or max_depth behind it (a contact that persists is not lost for
   * its depth while the vertex is in the block, or within held_depth below a surface), projects on
   * it (a contact that persists may hang over by reach / 100; at a valley more, see 4, within
   *    ContactTolerances::search_distance()), and both edges of the vertex lie
   *    on the outer side of its line up to 3 degrees (Shi 1988, entrance; 5
   *    degrees for a contact that persists). The angle test is what keeps
   *    neighbours in a stack, whose corners coincide, from catching each other.
   * 3. *A new contact behind an edge* counts only if the vertex is really
   *    inside the block: targets need not be convex. Or if it has passed the tip
   *    that the edge ends in, so that the blocks overlap although the vertex is
   *    outside again: two tips that have passed each other, or a corner and a tip on
   *    one ground, into which the corner is pressed deeper. (Loads with which
   *    contacts begin that are found in overlap: contact_load.h.)
   * 4. *Undecided corners*: a vertex exactly on a corner both of whose edges
   *    pass is no contact yet. Whichever edge were chosen would jam one of
   *    two ways past the corner; one step later the vertex has moved and rule
   *    5 knows the way it went.
   *    The same for the side below a seam: a vertex that slides on a row is,
   *    by its penetration, in front of the side of the next block, and that
   *    block's corner in front of the slider's side. So is one over a crack, whose sole alone is
   *    carried, and which is level with the next block, as that block's corner is with the sole.
   *    So is one whose row has a block that only touches the row's line with a
   *    tip, as triangles have. At a valley an edge goes on below its neighbour: a
   *    vertex pressed into the foot of a wall is beside one edge or both.
   * 5. *One edge per vertex and body*: the edge it projects on, the edge in
   *    history, an edge that continues the one in history, one that it is beside
   *    without the help of a valley (of a low step the upper tread), the side by
   *    which it has passed a tip, the least penetration; of equal ones the edge
   *    that the vertex's sole runs along, then the lower one, so that neither
   *    round-off nor numbers decide. Two edges only if they face each other (a
   *    notch, a valley of the foundation sharper than 10 degrees).
   * 6. *One edge per seam*: of edges of several bodies with normals within 10
   *    degrees that pass the vertex at the same height only one acts, so
   *    that stiffness and friction are the same on the seam as beside it.
   *    History decides while the vertex is still over its edge.
   *    Two edges that it had before, at different heights, are no seam: a tip
   *    between them would be lost.
   * 7. *Corner against corner*: if vertex and target corner are in each other's
   *    blocks through edges that are not parallel, only one of the two
   *    contacts acts (history, then least penetration). A row whose next block
   *    is a little too high would otherwise stop a sliding block at its side.
   * 8. *History*: contacts that persist keep slip, plastic slip, state and edge
   *    position. When a vertex leaves an edge and another one continues it
   *    (normals within 10 degrees, same height), slip, plastic slip and state
   *    go with it; edge_position is that on the new edge. Others are dropped.
   * 9. *First activation*: neighbours of the mesh that have slept may overlap a little when
   *    one of them wakes (joints give way before they fail). They carry nothing
   *    (stress_free_gap) until they overlap more, by waking_slack: a spring that is loaded
   *    when it is made would throw them apart, and one at its limit would
   *    open and close with every tremor. (Contacts of a released joint: joint_release.h.)
   */
  class ContactDetection
  {
  public:
    struct Parameters
    {
      double reach;               ///< gap below which a pair becomes a contact, at most [m], > 0
      double margin;              ///< skin of the Verlet list [m], >= 0
      double smooth_angle;        ///< turns up to this are no corners [rad], e.g. 1e-3
      double max_depth = -1.;     ///< penetration above which a vertex is lost, at most [m];
                                  ///< negative: reach
      double held_depth = -1.;    ///< the same of a contact with a surface that persists [m];
                                  ///< negative: max_depth
      double waking_slack = 1e-3; ///< by which part of the reach neighbours that have woken may
                                  ///< overlap more before they carry [-]
    };

    explicit ContactDetection(const Parameters &parameters);

    ContactDetection(const ContactDetection &)            = delete; ///< parts refer to its pairs
    ContactDetection &operator=(const ContactDetection &) = delete;

    /// Sizes of the blocks [m]: pairs with small ones have smaller tolerances (PairTolerances).
    void set_sizes(const std::vector<double> &size)
    {
      pairs.set_sizes(size);
    }

    /// Blocks that joints hold beside each other; see ContactCandidates.
    void set_neighbours(const std::vector<int> &offset, const std::vector<int> &list)
    {
      candidates.set_neighbours(offset, list);
    }

    /// Bonded pairs and awake blocks; to be called when a joint is released.
    void set_skipped_pairs(const SkippedPairs &skipped)
    {
      candidates.set_skipped_pairs(skipped);
    }

    /// Blocks that were awake at the search before; see ContactCandidates.
    void set_was_awake(const std::vector<ContactScope> &awake_then)
    {
      candidates.set_was_awake(awake_then);
    }

    /**
     * Replace @p contacts by those of the coming step, sorted by vertex_body,
     * vertex, edge_body, edge. @p contacts must be sorted so on entry, and @p rest
     * is what the last call left. Allocates nothing once the lists have grown.
     */
    void update(const Geometry &geometry, std::vector<Contact> &contacts, RestState &rest);

    /// The same with a search for every vertex, at rest or not.
    void update(const Geometry &geometry, std::vector<Contact> &contacts)
    {
      RestState unknown;
      update(geometry, contacts, unknown);
    }

    /// Whether a step from @p geometry, with the @p contacts of the last update(), takes a vertex
    /// into a body that it had no contact with (ContactPassage): it has to be cut.
    bool is_passed(const Geometry             &geometry,
                   const std::vector<Contact> &contacts,
                   const StepMotion           &motion);

    /// What the last update() found and did.
    struct Report
    {
      int  lost       = 0; ///< vertices deeper than max_depth inside a block, ignored
      long edge_tests = 0; ///< edges looked at
      long builds     = 0; ///< Verlet lists built since construction
      long searches   = 0; ///< updates since construction in which the search did not sleep
    };

    const Report &report() const
    {
      return last;
    }

    /// Distances computed when the Verlet list was last built.
    long n_build_tests() const
    {
      return candidates.n_distance_tests();
    }

  private:
    void keep_deep_contacts(const Geometry &geometry, const std::vector<Contact> &contacts);

    /// Blocks that are in awake pairs or in contacts: only their outlines are looked at.
    void find_near_blocks(const Geometry &geometry, const std::vector<Contact> &contacts);

    /// Near pairs of one vertex, [begin, end) of the awake candidates.
    struct Group
    {
      std::size_t begin, end;
    };

    /// The group that begins at an awake candidate.
    Group group_at(std::size_t begin) const;

    /// True if all that is near the vertex rests and was there at the search before.
    bool group_rests(const Group &group) const;

    /// True if no vertex needs a search: @p contacts stay as they are.
    bool is_all_settled(const std::vector<Contact> &contacts, RestState &rest) const;

    /// Mark vertices at rest whose contacts are those of the step before.
    void settle(const std::vector<Contact> &contacts, RestState &rest);

    void select(const Geometry &geometry, RestState &rest);

    /// The contacts that one vertex had, as trials. They pass all tests of its own.
    void keep(const Geometry &geometry, const Contact *old_contacts, int n_old);

    /// Search for the contacts of one vertex. Returns false if it is lost inside a block.
    bool
    search(const Geometry &geometry, const Group &group, const Contact *old_contacts, int n_old);

    void add_body(const Geometry &geometry, const ContactCandidate &candidate);

    bool is_lost(const Geometry &geometry, int vertex_body, int vertex, int block) const;

    void resolve_corners(const Geometry &geometry);

    using Range = std::pair<std::vector<ContactTrial>::const_iterator,
                            std::vector<ContactTrial>::const_iterator>;

    Range trials_of(int body, int vertex) const;

    const ContactTolerances &tolerances_of(const Contact &contact) const
    {
      return pairs.of(contact.vertex_body, contact.edge_body);
    }

    bool is_above_seam(const Geometry &geometry, std::size_t trial) const;

    bool runs_over_tip(const Geometry     &geometry,
                       const ContactTrial &support,
                       const Contact      &contact,
                       const Vec2         &way) const;

    bool meets_level(const Geometry &geometry, const Contact &contact, int end) const;

    bool loses_corner(const Geometry &geometry, std::size_t trial) const;

    const double                  smooth_angle;
    const double                  waking_slack;
    PairTolerances                pairs;
    ContactCandidates             candidates;
    std::vector<ContactCandidate> deep_pairs; ///< sorted
    ContactSelection              selection;
    StillnessCache                watch;
    OutlineFrames                 frames;

    std::vector<Contact>      previous;                       ///< contacts of the step before
    std::vector<ContactTrial> trials;                         ///< sorted
    std::vector<int>          first_of_vertex, first_of_node; ///< first trial of a vertex, or -1
    std::vector<char>         dropped;                        ///< per trial
    std::vector<int>          near_blocks;
    std::vector<char>         is_near;                     ///< per block
    std::vector<Vec2>         moved_vertices, moved_nodes; ///< work of is_passed()
    Report                    last;
  };
} // namespace hybrid::dda
